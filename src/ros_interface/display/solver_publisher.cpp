#include <ros_interface/display/solver_publisher.h>

#include <numeric>

#include <ros/node_handle.h>

#include <ros_interface/context/solver_context.h>
#include <ros_interface/conversion/component_deviations.h>
#include <ros_interface/conversion/message_conversion.h>
#include <ros_interface/display/interference_publisher.h>
#include <ros_interface/markers/cable_markers.h>
#include <ros_interface/markers/clip_markers.h>
#include <ros_interface/markers/contact_markers.h>
#include <ros_interface/markers/labels.h>
#include <ros_interface/markers/route_markers.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

using cable_variation::ComponentDeviations;

namespace {

std::vector<std::size_t> firstNumbers(std::size_t count) {
  std::vector<std::size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  return numbers;
}

void append(const visualization_msgs::MarkerArray& more, visualization_msgs::MarkerArray& markers) {
  markers.markers.insert(markers.markers.end(), more.markers.begin(), more.markers.end());
}

}  // namespace

SolverPublisher::SolverPublisher(ros::NodeHandle& node, InterferencePublisher& interference)
    : cables_(node, kCablesTopic),
      marks_(node, std::string(kMarksTopics) + kCablesTopic),
      interference_(interference),
      shapes_(node.advertise<cable_variation::CableShapes>(kShapesTopic, 1, true)),
      deviations_(node.advertise<ComponentDeviations>(kComponentDeviationsTopic, 1, true)) {
  deviations_.publish(deviations_shown_);
}

void SolverPublisher::publish(const SolverContext& context,
                              const std::vector<cable_variation::MeasureValue>& measured) {
  const bool outdated = !context.equilibrium().converged();
  visualization_msgs::MarkerArray markers = cableMarkers(context.lastShape(), context.harness(), outdated);
  const visualization_msgs::MarkerArray clips = clipMarkers(context.equilibrium(), context.harness());
  const visualization_msgs::MarkerArray contacts = contactMarkers(context.equilibrium(), context.harness());
  append(clips, markers);
  append(contacts, markers);
  const visualization_msgs::MarkerArray routes = routeMarkers(context.design().scene, measured);
  append(routes, markers);
  cables_.publish(markers);
  visualization_msgs::MarkerArray marks = clipMarkers(context.equilibrium(), context.harness(), false);
  append(contacts, marks);
  append(routes, marks);
  marks_.publish(marks);
  const cable_variation::Scene& scene = context.design().scene;
  std::vector<cable_variation::Label> labels = clipLabels(context.equilibrium(), context.harness());
  const std::vector<cable_variation::Label> forces = contactLabels(context.equilibrium());
  labels.insert(labels.end(), forces.begin(), forces.end());
  const std::vector<cable_variation::Label> deviations_of_routes = routeLabels(scene, measured);
  labels.insert(labels.end(), deviations_of_routes.begin(), deviations_of_routes.end());
  interference_.showMeasures(distanceMarks(scene, firstNumbers(measured.size()), measured), clips, labels);
  shapes_.publish(toCableShapes(context.equilibrium(), context.harness(), context.stamp()));
  const ComponentDeviations deviations =
      toMessage(componentDeviations(scene, context.design().shifted, context.moved(), context.onTf()));
  if (deviations == deviations_shown_) return;
  deviations_.publish(deviations);
  deviations_shown_ = deviations;
}

}  // namespace cable_variation_ros
