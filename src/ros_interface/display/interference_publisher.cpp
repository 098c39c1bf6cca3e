#include <ros_interface/display/interference_publisher.h>

#include <ros/node_handle.h>

#include <ros_interface/node/names.h>

namespace cable_variation_ros {

InterferencePublisher::InterferencePublisher(ros::NodeHandle& node) : channel_(node, kInterferenceTopic) {}

void InterferencePublisher::showMeasures(std::vector<DistanceMark> marks,
                                         const visualization_msgs::MarkerArray& clips) {
  measures_ = std::move(marks);
  clips_ = clips;
  publish();
}

void InterferencePublisher::showEnvelope(InterferenceView view) {
  envelope_ = std::move(view);
  publish();
}

void InterferencePublisher::showRegion(InterferenceView view) {
  region_ = std::move(view);
  publish();
}

void InterferencePublisher::publish() {
  std::vector<DistanceMark> marks = measures_;
  for (const InterferenceView* view : {&envelope_, &region_}) {
    marks.insert(marks.end(), view->marks.begin(), view->marks.end());
  }
  visualization_msgs::MarkerArray array = interferenceMarkers(marks, clips_);
  for (const InterferenceView* view : {&envelope_, &region_}) {
    array.markers.insert(array.markers.end(), view->triangles.begin(), view->triangles.end());
  }
  channel_.publish(std::move(array));
}

}  // namespace cable_variation_ros
