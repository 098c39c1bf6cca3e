#pragma once

#include <vector>

#include <visualization_msgs/MarkerArray.h>

#include <cable_variation/Label.h>

#include <ros_interface/display/marker_channel.h>

namespace cable_variation_ros {

class InterferencePublisher;
class SolverContext;

/// ~path_check, ~marks/path_check (without texts) and on ~labels: what was found along the path that was
/// checked last, until the design is another one.
class PathPublisher {
 public:
  /// @param labels that shows them; must outlive this
  PathPublisher(ros::NodeHandle& node, InterferencePublisher& labels);

  /// @param design_number that it was found with; nothing is shown if that is no longer in force
  void show(const visualization_msgs::MarkerArray& markers, std::vector<cable_variation::Label> events,
            std::size_t design_number, const SolverContext& context);
  void contextChanged(const SolverContext& context);

 private:
  void publish(const visualization_msgs::MarkerArray& markers, std::vector<cable_variation::Label> events);

  MarkerChannel channel_, marks_;
  InterferencePublisher& labels_;
  bool showing_ = false;
  std::size_t design_number_ = 0;
};

}  // namespace cable_variation_ros
