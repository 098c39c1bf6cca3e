#pragma once

#include <functional>

#include <ros/publisher.h>
#include <visualization_msgs/MarkerArray.h>

#include <cable_variation/CableTubes.h>
#include <cable_variation/Legend.h>

#include <ros_interface/display/marker_channel.h>

namespace ros {
class NodeHandle;
}

namespace cable_variation_ros {

class TubePublisher;

/// One view at a time on ~variation and ~tubes, and on ~legend what its colours mean.
class VariationPublisher {
 public:
  VariationPublisher(ros::NodeHandle& node, TubePublisher& tubes);

  /// @param tubes cables with their variation; none if it is not of cables
  /// @param renew called when what is in force has changed, as long as no other view takes the place of this
  /// one: it shows the view as it is now, hides it or leaves it. Empty: the view goes away then.
  void show(const visualization_msgs::MarkerArray& markers, cable_variation::CableTubes tubes,
            cable_variation::Legend legend, std::function<void()> renew);
  /// Nothing is to be seen until the view is renewed.
  void hide();
  /// No view.
  void clear();

  /// ~tubes is left to whoever publishes it afterwards.
  void contextChanged();

 private:
  MarkerChannel markers_, marks_;
  ros::Publisher legend_;
  TubePublisher& tubes_;
  std::function<void()> renew_;
  bool showing_ = false;
  bool renewing_ = false;
};

}  // namespace cable_variation_ros
