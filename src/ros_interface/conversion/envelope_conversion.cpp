#include <ros_interface/conversion/envelope_conversion.h>

#include <algorithm>
#include <optional>

#include <cable_variation/envelope/clearance/clearance_limit.h>
#include <ros_interface/conversion/matrix_conversion.h>
#include <ros_interface/conversion/message_conversion.h>

namespace cable_variation_ros {

using cable_variation::ClearanceResult;
using cable_variation::Envelope;
using cable_variation::EnvelopeClearance;
using cable_variation::GenerateEnvelopeResponse;
using cable_variation::Scene;

namespace {

std::uint8_t toKind(EnvelopeClearance::Kind kind) {
  switch (kind) {
    case EnvelopeClearance::Kind::together:
      return ClearanceResult::TOGETHER;
    case EnvelopeClearance::Kind::production:
      return ClearanceResult::PRODUCTION;
    case EnvelopeClearance::Kind::bodies:
      break;
  }
  return ClearanceResult::BODIES;
}

ClearanceResult toResult(const Scene& scene, const std::vector<std::string>& variables,
                         const EnvelopeClearance& clearance) {
  ClearanceResult result;
  result.cable = scene.harness.cables[clearance.cable].name;
  result.component = clearance.component;
  if (clearance.other) result.other_cable = scene.harness.cables[*clearance.other].name;
  result.distance = clearance.distance;
  result.kind = toKind(clearance.kind);
  result.margin = clearance.margin;
  result.random_shapes = static_cast<std::uint32_t>(clearance.random_shapes);
  result.between_bodies = clearance.between_bodies;
  result.on_envelope = toPoint(clearance.on_envelope);
  result.on_other = toPoint(clearance.on_other);
  result.arc_length = clearance.arc_length;
  result.other_arc_length = clearance.other_arc_length;
  result.time = clearance.time;
  result.variables = variables;
  result.deviations = listed(clearance.deviations);
  result.nominal = clearance.nominal;
  result.nominal_time = clearance.nominal_time;
  result.worst_sample = clearance.worst_sample;
  result.note = noteOf(clearance);
  result.colliding_triangles = static_cast<std::uint32_t>(clearance.colliding.size());
  const std::optional<double> limit = lowerLimit(scene, clearance);
  result.has_limit = limit.has_value();
  result.limit = limit.value_or(0.0);
  return result;
}

cable_variation::ContainmentResult toResult(const Scene& scene,
                                            const cable_variation::Containment& containment) {
  cable_variation::ContainmentResult result;
  result.shapes = static_cast<std::uint32_t>(containment.shapes);
  result.outside = static_cast<std::uint32_t>(containment.outside);
  result.outside_bound = containment.outside_bound;
  result.largest_excess = containment.largest_excess;
  result.largest_protrusion = containment.largest_protrusion;
  result.failed = static_cast<std::uint32_t>(containment.failed);
  if (containment.largest_protrusion > 0.0) {
    result.cable = scene.harness.cables[containment.cable].name;
    result.arc_length = containment.arc_length;
    result.time = containment.time;
    result.deviations = listed(containment.deviations);
  }
  return result;
}

cable_variation::TightnessResult toResult(const cable_variation::Tightness& tightness) {
  cable_variation::TightnessResult result;
  result.ratio = tightness.ratio();
  result.envelope_volume = tightness.envelope_volume;
  result.shapes_volume = tightness.shapes_volume;
  result.shapes = static_cast<std::uint32_t>(tightness.shapes);
  result.voxel = tightness.voxel;
  return result;
}

cable_variation::EnvelopePhaseInfo toInfo(const cable_variation::EnvelopePhase& phase) {
  cable_variation::EnvelopePhaseInfo info;
  info.start = phase.start;
  info.end = phase.end;
  info.poses = static_cast<std::uint32_t>(phase.poses);
  info.excess = phase.excess;
  return info;
}

cable_variation::SnapInfo toInfo(const Scene& scene, const cable_variation::Snap& snap) {
  cable_variation::SnapInfo info;
  info.before = listed(snap.before);
  info.after = listed(snap.after);
  info.begins = snap.begins;
  info.time = snap.time;
  info.branch = static_cast<std::uint32_t>(snap.branch);
  info.cable = scene.harness.cables[snap.cable].name;
  info.arc_length = snap.arc_length;
  info.jump = snap.jump;
  info.share = snap.share;
  info.share_bound = snap.share_bound;
  return info;
}

}  // namespace

shape_msgs::Mesh toMesh(const cable_variation::TriangleMesh& mesh) {
  shape_msgs::Mesh message;
  message.vertices.reserve(mesh.vertices.size());
  for (const Eigen::Vector3d& vertex : mesh.vertices) message.vertices.push_back(toPoint(vertex));
  message.triangles.resize(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    std::copy(mesh.triangles[i].begin(), mesh.triangles[i].end(),
              message.triangles[i].vertex_indices.begin());
  }
  return message;
}

GenerateEnvelopeResponse toResponse(const Scene& scene, const Envelope& envelope,
                                    const std::vector<EnvelopeClearance>& clearances) {
  GenerateEnvelopeResponse response;
  for (const std::size_t cable : envelope.cables) response.cables.push_back(scene.harness.cables[cable].name);
  for (const std::size_t variable : envelope.variables) {
    response.variables.push_back(scene.design_variables[variable].name);
  }
  for (const EnvelopeClearance& each : clearances) {
    response.clearances.push_back(toResult(scene, response.variables, each));
  }
  response.containment = toResult(scene, envelope.containment);
  response.tightness = toResult(envelope.tightness);
  response.probability = envelope.probability;
  response.inflation = envelope.inflation;
  response.largest_inflation = envelope.largest_inflation;
  for (const cable_variation::EnvelopePhase& phase : envelope.phases)
    response.phases.push_back(toInfo(phase));
  response.motion_excess = envelope.motion_excess;
  for (const cable_variation::Snap& snap : envelope.snaps) response.snaps.push_back(toInfo(scene, snap));
  response.branches = static_cast<std::uint32_t>(envelope.branches);
  response.pieces = static_cast<std::uint32_t>(envelope.frames.front().pieces.size());
  response.samples = static_cast<std::uint32_t>(envelope.samples.size());
  response.solves = static_cast<std::uint32_t>(envelope.solves);
  response.failures = static_cast<std::uint32_t>(envelope.failures);
  response.discretisation_error = envelope.discretisation_error;
  response.warnings = envelope.warnings;
  for (std::string& warning : openPartWarnings(clearances)) response.warnings.push_back(std::move(warning));
  response.solve_time = envelope.solve_time;
  response.verify_time = envelope.verify_time;
  return response;
}

}  // namespace cable_variation_ros
