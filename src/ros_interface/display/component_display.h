#pragma once

#include <memory>
#include <set>
#include <string>

#include <ros/subscriber.h>

#include <cable_variation/ComponentDeviations.h>

#include <cable_variation/scene/scene.h>
#include <ros_interface/display/marker_channel.h>

namespace cable_variation_ros {

/// Shows components on ~components, each in its frame. The frames have them as
/// designed; ~component_deviations tells how they deviate from that.
class ComponentDisplay {
 public:
  explicit ComponentDisplay(ros::NodeHandle& node);

  /// Shows the components of `scene` in `which`, in place of what was shown.
  void show(std::shared_ptr<const cable_variation::Scene> scene, std::set<std::string> which);

 private:
  void deviate(const cable_variation::ComponentDeviations& message);

  std::shared_ptr<const cable_variation::Scene> scene_;  ///< none before the first show()
  std::set<std::string> which_;
  MarkerChannel markers_;
  ros::Subscriber deviations_;
};

}  // namespace cable_variation_ros
