#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <cable_variation/equilibrium/equilibrium.h>

namespace cable_variation_ros {

/// Clips where they are, as small shapes by kind with their names, namespace
/// clip/NAME: a block (fixed), a band with its tab (rolling), a ball in a cup
/// (pivot), a pin (hinge), a square channel (sliding), a sleeve
/// (sliding_rolling), a ring (eyelet), an open channel (guide), a plate (plane),
/// a rubber disc (grommet), a cone (free), a small block (general). A free clip is
/// where its cable is; without an equilibrium it is nowhere.
/// @param named with their names as texts
visualization_msgs::MarkerArray clipMarkers(const cable_variation::Equilibrium& equilibrium,
                                            const cable_variation::Harness& harness, bool named = true);

}  // namespace cable_variation_ros
