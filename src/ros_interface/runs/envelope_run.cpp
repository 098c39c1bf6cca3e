#include <ros_interface/runs/envelope_run.h>

#include <utility>

#include <cable_variation/envelope/envelope_memory.h>
#include <ros_interface/conversion/component_deviations.h>
#include <ros_interface/conversion/envelope_conversion.h>
#include <ros_interface/markers/clearance_markers.h>
#include <ros_interface/markers/envelope_markers.h>
#include <ros_interface/node/names.h>
#include <ros_interface/runs/requests.h>

namespace cable_variation_ros {

using cable_variation::Envelope;
using cable_variation::EnvelopeCalculation;
using cable_variation::EnvelopeClearance;
using cable_variation::EnvelopePiece;
using cable_variation::EnvelopeTask;
using cable_variation::Scene;
using cable_variation::Status;

namespace {

// What the edges of all pieces take as markers and as a message [B].
double markersOf(const Envelope& envelope) {
  constexpr double kBytes = 2.0 * 2.0 * 3.0 * 24.0;  // two points of each of three edges by vertex, twice
  double bytes = 0.0;
  for (const EnvelopePiece& piece : envelope.frames.front().pieces)
    bytes += kBytes * static_cast<double>(piece.body.core.surface().vertices.size());
  return bytes;
}

InterferenceView interferenceOf(const EnvelopeTask& task, const Scene& scene,
                                const cable_variation::ComponentPoses& on_tf,
                                const std::vector<EnvelopeClearance>& found) {
  InterferenceView view;
  view.marks = clearanceMarks(scene, found, !task.options.motions.empty());
  const cable_variation::ComponentPoses deviations =
      componentDeviations(scene, task.options.values, task.options.moved, on_tf);
  for (const cable_variation::Component& component : scene.components) {
    const auto deviation = deviations.find(component.name);
    const auto markers =
        triangleMarkers(component, collidingTriangles(found, component.name),
                        deviation != deviations.end() ? deviation->second : cable_variation::Pose());
    view.triangles.insert(view.triangles.end(), markers.begin(), markers.end());
  }
  return view;
}

}  // namespace

EnvelopeRun::EnvelopeRun(Request request, RunLimits limits, EnvelopePublisher& publisher)
    : request_(std::move(request)), limits_(std::move(limits)), publisher_(publisher) {}

void EnvelopeRun::prepare(const SolverContext& context) {
  task_ = toEnvelopeTask(fromMessage(request_), context.design(), context.moved(), limits_.threads,
                         limits_.memory_limit);
  snapshot_ = snapshotFor(task_.options, context.snapshot());
}

void EnvelopeRun::calculate(cable_variation::RunControl& control) {
  const EnvelopeCalculation found = calculateEnvelope(task_, snapshot_, true, control);
  answer(found);
  view(found);
  write(found, control);
}

bool EnvelopeRun::show(const SolverContext& context) { return publisher_.show(std::move(view_), context); }

void EnvelopeRun::answer(const EnvelopeCalculation& found) {
  const cable_variation::OuterSurface& surface = found.surfaces.whole;
  response_ = toResponse(scene(), found.envelope, found.clearances);
  response_.warnings = found.warnings;
  response_.clearance_time = found.clearance_time;
  response_.surface_time = found.surface_time;
  response_.header.frame_id = kWorldFrame;
  response_.header.stamp = ros::Time::now();
  response_.mesh = toMesh(surface.mesh);
  response_.surface_excess = surface.excess;
  response_.volume = found.volume;
  response_.margin = task_.options.margin;
  response_.seed = task_.options.seed;
}

void EnvelopeRun::view(const EnvelopeCalculation& found) {
  const Envelope& envelope = found.envelope;
  view_.markers = envelopeMarkers(scene(), found.surfaces.by_cable);
  if (request_.show_pieces && markersOf(envelope) > task_.mesh_memory) {
    warn("the pieces are not shown: the markers would take " +
         cable_variation::memoryText(markersOf(envelope)) + ", allowed are " +
         cable_variation::memoryText(task_.mesh_memory) + " of ~memory_limit");
  } else if (request_.show_pieces) {
    const auto pieces = pieceMarkers(scene(), envelope.frames.front().pieces);
    view_.markers.markers.insert(view_.markers.markers.end(), pieces.markers.begin(), pieces.markers.end());
  }
  view_.mesh.header = response_.header;
  view_.mesh.cables = response_.cables;
  view_.mesh.probability = response_.probability;
  view_.mesh.excess = response_.surface_excess;
  view_.mesh.mesh = response_.mesh;
  view_.interference = interferenceOf(task_, scene(), snapshot_.on_tf, found.clearances);
  view_.origin = viewOrigin(snapshot_, task_.options.motions);
  for (const std::string& warning : warningsOfMoved(view_.origin, task_.options.motions)) warn(warning);
}

void EnvelopeRun::write(const EnvelopeCalculation& found, cable_variation::RunControl& control) {
  const cable_variation::EnvelopeFiles files =
      writeEnvelope(task_, snapshot_, found, limits_.output, response_.warnings, control);
  response_.mesh_file = files.mesh;
  response_.urdf_file = files.urdf;
  response_.region_file = files.region;
  response_.report_file = files.report;
  if (files.error.empty()) return;
  response_.status.code = Status::IO_ERROR;
  response_.status.message = files.error;
}

}  // namespace cable_variation_ros
