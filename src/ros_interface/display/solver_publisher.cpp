#include <ros_interface/display/solver_publisher.h>

#include <ros/node_handle.h>

#include <cable_variation/scene/measure_traits.h>
#include <ros_interface/context/solver_context.h>
#include <ros_interface/conversion/component_deviations.h>
#include <ros_interface/conversion/message_conversion.h>
#include <ros_interface/display/interference_publisher.h>
#include <ros_interface/markers/cable_markers.h>
#include <ros_interface/markers/clip_markers.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

using cable_variation::ComponentDeviations;

namespace {

std::vector<DistanceMark> distancesOf(const SolverContext& context) {
  if (!context.equilibrium().converged()) return {};
  const cable_variation::Scene& scene = context.design().scene;
  std::vector<std::size_t> distances;
  for (std::size_t i = 0; i < scene.measures.size(); ++i) {
    if (traitsOf(scene.measures[i].type).clearance) distances.push_back(i);
  }
  if (distances.empty()) return {};
  return distanceMarks(scene, distances, context.measure(distances));
}

}  // namespace

SolverPublisher::SolverPublisher(ros::NodeHandle& node, InterferencePublisher& interference)
    : cables_(node, kCablesTopic),
      interference_(interference),
      shapes_(node.advertise<cable_variation::CableShapes>(kShapesTopic, 1, true)),
      deviations_(node.advertise<ComponentDeviations>(kComponentDeviationsTopic, 1, true)) {
  deviations_.publish(deviations_shown_);
}

void SolverPublisher::publish(const SolverContext& context) {
  visualization_msgs::MarkerArray markers = cableMarkers(context.equilibrium(), context.harness());
  const visualization_msgs::MarkerArray clips = clipMarkers(context.equilibrium(), context.harness());
  markers.markers.insert(markers.markers.end(), clips.markers.begin(), clips.markers.end());
  cables_.publish(markers);
  interference_.showMeasures(distancesOf(context), clips);
  shapes_.publish(toCableShapes(context.equilibrium(), context.harness(), ros::Time::now()));
  const ComponentDeviations deviations =
      toMessage(componentDeviations(context.design().scene, context.design().shifted, context.moved()));
  if (deviations == deviations_shown_) return;
  deviations_.publish(deviations);
  deviations_shown_ = deviations;
}

}  // namespace cable_variation_ros
