#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>

#include <tf2_ros/static_transform_broadcaster.h>

#include <cable_variation/math/pose.h>

namespace cable_variation_ros {

class SolverContext;

/// The clips on tf, each a frame in its component's: a robot or a person can go to WH_Start. They change with
/// the design alone and are static between, wherever the component goes. tf keeps the frames of clips that
/// another scene does not have: static ones cannot be taken back.
class ClipFrames {
 public:
  void publish(const SolverContext& context);

 private:
  tf2_ros::StaticTransformBroadcaster broadcaster_;
  std::optional<std::size_t> design_number_;                                   // that was published
  std::map<std::string, std::pair<std::string, cable_variation::Pose>> sent_;  // parent and pose, by frame
};

}  // namespace cable_variation_ros
