#include <ros_interface/display/interference_publisher.h>

#include <ros/node_handle.h>

#include <cable_variation/Labels.h>

#include <ros_interface/markers/labels.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

using cable_variation::Label;
using cable_variation::Labels;

InterferencePublisher::InterferencePublisher(ros::NodeHandle& node)
    : channel_(node, kInterferenceTopic),
      marks_(node, std::string(kMarksTopics) + kInterferenceTopic),
      labels_(node.advertise<Labels>(kLabelsTopic, 1, true)) {}

void InterferencePublisher::showMeasures(std::vector<DistanceMark> marks,
                                         const visualization_msgs::MarkerArray& clips,
                                         std::vector<Label> names) {
  measures_ = std::move(marks);
  clips_ = clips;
  names_ = std::move(names);
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

void InterferencePublisher::showPath(std::vector<Label> events) {
  path_ = std::move(events);
  publish();
}

void InterferencePublisher::publish() {
  std::vector<DistanceMark> marks = measures_;
  for (const InterferenceView* view : {&envelope_, &region_}) {
    marks.insert(marks.end(), view->marks.begin(), view->marks.end());
  }
  visualization_msgs::MarkerArray all = interferenceMarkers(marks, clips_), pairs = pairMarkers(marks);
  for (visualization_msgs::MarkerArray* array : {&all, &pairs}) {
    for (const InterferenceView* view : {&envelope_, &region_}) {
      array->markers.insert(array->markers.end(), view->triangles.begin(), view->triangles.end());
    }
  }
  channel_.publish(std::move(all));
  marks_.publish(std::move(pairs));
  Labels labels;
  labels.header.frame_id = kWorldFrame;
  labels.labels = names_;
  const std::vector<Label> figures = distanceLabels(marks);
  labels.labels.insert(labels.labels.end(), figures.begin(), figures.end());
  labels.labels.insert(labels.labels.end(), path_.begin(), path_.end());
  labels_.publish(labels);
}

}  // namespace cable_variation_ros
