#pragma once

#include <memory>
#include <set>
#include <string>

#include <ros/subscriber.h>
#include <ros/wall_timer.h>

#include <cable_variation/ComponentDeviations.h>

#include <cable_variation/scene/scene.h>
#include <ros_interface/display/marker_channel.h>

namespace cable_variation_ros {

/// Shows components on ~components, each in its frame. The frames have them as
/// designed; ~component_deviations tells how they deviate from that. RViz drops a marker for good if the
/// frames on its way have no time in common when it comes, as while the nodes that publish them start: where
/// tf or joint states drive components all are told of again, ever more rarely.
class ComponentDisplay {
 public:
  explicit ComponentDisplay(ros::NodeHandle& node);

  /// Shows the components of `scene` in `which`, in place of what was shown.
  void show(std::shared_ptr<const cable_variation::Scene> scene, std::set<std::string> which);

 private:
  void deviate(const cable_variation::ComponentDeviations& message);
  void publish();
  void repeat();

  std::shared_ptr<const cable_variation::Scene> scene_;  ///< none before the first show()
  std::set<std::string> which_;
  cable_variation::ComponentPoses deviations_shown_;
  MarkerChannel markers_;
  ros::Subscriber deviations_;
  ros::WallTimer again_;
  double pause_ = 0.0;  // until the next repetition [s]
};

}  // namespace cable_variation_ros
