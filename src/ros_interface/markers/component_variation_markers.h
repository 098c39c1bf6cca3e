#pragma once

#include <vector>

#include <visualization_msgs/MarkerArray.h>

#include <cable_variation/Legend.h>

#include <cable_variation/scene/scene.h>
#include <cable_variation/sensitivity/component_variation.h>

namespace cable_variation_ros {

struct ComponentVariationView {
  visualization_msgs::MarkerArray markers;
  cable_variation::Legend legend;  ///< its topic is left to the caller; empty without markers
};

/// Components with each vertex coloured by its six sigma on one scale from 0 to the largest of all, and the
/// largest of each as text. In the components' frames, namespace variation/NAME.
/// @param poses of all components at the design, world (componentPosesAt())
/// @param deviations of components from where their tf frames are, in these frames; those not named have none
ComponentVariationView componentVariationMarkers(
    const cable_variation::Scene& scene, const std::vector<cable_variation::ComponentVariation>& variations,
    const cable_variation::ComponentPoses& poses, const cable_variation::ComponentPoses& deviations = {});

}  // namespace cable_variation_ros
