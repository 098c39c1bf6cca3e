#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <ros_interface/display/marker_channel.h>

namespace cable_variation_ros {

class SolverContext;

/// ~path_check: what was found along the path that was checked last, until the design is another one.
class PathPublisher {
 public:
  explicit PathPublisher(ros::NodeHandle& node);

  /// @param design_number that it was found with; nothing is shown if that is no longer in force
  void show(visualization_msgs::MarkerArray markers, std::size_t design_number, const SolverContext& context);
  void contextChanged(const SolverContext& context);

 private:
  MarkerChannel channel_;
  bool showing_ = false;
  std::size_t design_number_ = 0;
};

}  // namespace cable_variation_ros
