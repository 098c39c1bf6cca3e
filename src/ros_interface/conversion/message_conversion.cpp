#include <ros_interface/conversion/message_conversion.h>

#include <cmath>
#include <stdexcept>

#include <cable_variation/analysis/centreline_points.h>
#include <cable_variation/equilibrium/bend_radius.h>
#include <ros_interface/conversion/contact_conversion.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

using cable_variation::CableShape;
using cable_variation::CableShapes;
using cable_variation::CableState;
using cable_variation::Equilibrium;
using cable_variation::Harness;
using cable_variation::Pose;
using cable_variation::ShapePoint;

namespace {

/// A message with fields x, y and z, of a vector or a quaternion.
template <typename Message, typename Value>
Message withXyz(const Value& value) {
  Message message;
  message.x = value.x();
  message.y = value.y();
  message.z = value.z();
  return message;
}

}  // namespace

geometry_msgs::Vector3 toVector(const Eigen::Vector3d& vector) {
  return withXyz<geometry_msgs::Vector3>(vector);
}

geometry_msgs::Point toPoint(const Eigen::Vector3d& point) { return withXyz<geometry_msgs::Point>(point); }

geometry_msgs::Quaternion toQuaternion(const Eigen::Quaterniond& orientation) {
  auto message = withXyz<geometry_msgs::Quaternion>(orientation);
  message.w = orientation.w();
  return message;
}

geometry_msgs::Pose toPose(const Pose& pose) {
  geometry_msgs::Pose message;
  message.position = toPoint(pose.position);
  message.orientation = toQuaternion(pose.orientation);
  return message;
}

geometry_msgs::TransformStamped toTransform(const Pose& pose, const std::string& parent,
                                            const std::string& frame, const ros::Time& stamp) {
  geometry_msgs::TransformStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = parent;
  message.child_frame_id = frame;
  message.transform.translation = toVector(pose.position);
  message.transform.rotation = toQuaternion(pose.orientation);
  return message;
}

Eigen::Vector3d fromVector(const geometry_msgs::Vector3& vector) { return {vector.x, vector.y, vector.z}; }

Pose fromPose(const geometry_msgs::Pose& pose, const std::string& what) {
  geometry_msgs::Transform transform;
  transform.translation.x = pose.position.x;
  transform.translation.y = pose.position.y;
  transform.translation.z = pose.position.z;
  transform.rotation = pose.orientation;
  return fromTransform(transform, what);
}

Pose fromTransform(const geometry_msgs::Transform& transform, const std::string& what) {
  const Eigen::Vector3d position = fromVector(transform.translation);
  if (!position.allFinite()) throw std::invalid_argument(what + ": position is not finite");
  const Eigen::Quaterniond orientation(transform.rotation.w, transform.rotation.x, transform.rotation.y,
                                       transform.rotation.z);
  const double norm = orientation.norm();
  constexpr double kTolerance = 1e-3;  // generous to quaternions typed or stored with few digits
  if (!(std::abs(norm - 1.0) <= kTolerance)) {
    throw std::invalid_argument(what + ": quaternion has norm " + std::to_string(norm) + ", expected 1");
  }
  return {position, orientation.normalized()};
}

CableState toCableState(const CableShape& shape, double length) {
  CableState state;
  state.cable = shape.cable;
  state.length = length;
  state.radius = shape.radius;
  const cable_variation::BendRadius bend = smallestBendRadius(shape);
  state.smallest_bend_radius = bend.radius;
  state.smallest_bend_radius_at = bend.arc_length;
  for (const Pose& pose : shape.sample(cable_variation::centrelineCount(length))) {
    state.centreline.push_back(toPoint(pose.position));
  }
  for (const ShapePoint& point : shape.points) {
    state.arc_length.push_back(point.arc_length);
    state.section.push_back(toPose(point.pose));
    state.force.push_back(toVector(point.force));
    state.moment.push_back(toVector(point.moment));
    state.strain.push_back(toVector(point.strain));
    state.curvature.push_back(toVector(point.curvature));
  }
  return state;
}

CableShapes toCableShapes(const Equilibrium& equilibrium, const Harness& harness, const ros::Time& stamp) {
  CableShapes shapes;
  shapes.header.stamp = stamp;
  shapes.header.frame_id = kWorldFrame;
  if (!equilibrium.converged()) return shapes;
  for (std::size_t i = 0; i < equilibrium.shapes.size(); ++i) {
    shapes.cables.push_back(toCableState(equilibrium.shapes[i], harness.cables[i].length));
  }
  return shapes;
}

std::vector<cable_variation::ClipReaction> toClipReactions(const Equilibrium& equilibrium,
                                                           const Harness& harness) {
  std::vector<cable_variation::ClipReaction> messages;
  if (!equilibrium.converged()) return messages;
  for (std::size_t i = 0; i < equilibrium.clip_reactions.size(); ++i) {
    const cable_variation::Reaction& reaction = equilibrium.clip_reactions[i];
    cable_variation::ClipReaction message;
    message.clip = reaction.name;
    message.cable = harness.cables[harness.clips[i].cable].name;
    message.force = toVector(reaction.force);
    message.moment = toVector(reaction.moment);
    message.arc_length = reaction.arc_length;
    message.section = toPose(reaction.section);
    messages.push_back(message);
  }
  return messages;
}

geometry_msgs::Wrench toWrench(const cable_variation::Reaction& reaction, const Pose& clip) {
  const Eigen::Vector3d arm = reaction.section.position - clip.position;
  const Eigen::Quaterniond into_clip = clip.orientation.conjugate();
  geometry_msgs::Wrench wrench;
  wrench.force = toVector(into_clip * reaction.force);
  wrench.torque = toVector(into_clip * (reaction.moment + arm.cross(reaction.force)));
  return wrench;
}

cable_variation::SolveEquilibriumResponse toResponse(const Equilibrium& equilibrium, const Harness& harness) {
  cable_variation::SolveEquilibriumResponse response;
  response.shapes = toCableShapes(equilibrium, harness, ros::Time()).cables;
  response.clip_reactions = toClipReactions(equilibrium, harness);
  for (const cable_variation::Reaction& reaction : equilibrium.joint_reactions) {
    cable_variation::JointReaction message;
    message.joint = reaction.name;
    message.force = toVector(reaction.force);
    message.moment = toVector(reaction.moment);
    message.section = toPose(reaction.section);
    response.joint_reactions.push_back(message);
  }
  response.contacts = toContacts(equilibrium, harness);
  response.smallest_gap = equilibrium.smallest_gap;
  response.energy.elastic = equilibrium.energy.elastic;
  response.energy.gravity = equilibrium.energy.gravity;
  response.energy.springs = equilibrium.energy.springs;
  response.energy.loads = equilibrium.energy.loads;
  response.energy.total = equilibrium.energy.total();
  response.smallest_eigenvalue = equilibrium.smallest_eigenvalue;
  response.iterations = static_cast<std::uint32_t>(equilibrium.iterations);
  response.residual = equilibrium.residual;
  response.discretisation_error = equilibrium.discretisation_error;
  response.solve_time = equilibrium.solve_time;
  for (const cable_variation::Alternative& alternative : equilibrium.alternatives) {
    cable_variation::AlternativeEquilibrium message;
    message.energy = alternative.energy;
    message.largest_distance = alternative.largest_distance;
    response.alternatives.push_back(message);
  }
  response.warnings = equilibrium.notes;
  return response;
}

}  // namespace cable_variation_ros
