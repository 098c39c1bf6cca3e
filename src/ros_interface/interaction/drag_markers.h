#pragma once

#include <string>

#include <visualization_msgs/InteractiveMarker.h>

#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/math/pose.h>

namespace cable_variation_ros {

/// What can be taken by the mouse: its kind and name, which together name its interactive marker,
/// "clip/WH_Start".
struct DragTarget {
  enum class Kind { clip, component, cable };
  Kind kind;
  std::string name;

  std::string markerName() const;
};

/// The other way round. Throws std::invalid_argument for a name that is none.
DragTarget dragTargetOf(const std::string& marker_name);

/// A ball (of a clip) or cube (of a component) to click on, in the frame world.
/// @param open with arrows and rings for six degrees of freedom
/// @param changed its colour tells that it has been dragged since it was last set as design
visualization_msgs::InteractiveMarker dragMarker(const DragTarget& target, const cable_variation::Pose& pose,
                                                 double size, bool open, bool changed);

/// A cable that has a menu and is not dragged: a faint sheath around it.
visualization_msgs::InteractiveMarker cableMarker(const cable_variation::CableShape& shape,
                                                  const cable_variation::Cable& cable);

}  // namespace cable_variation_ros
