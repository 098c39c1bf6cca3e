#include <ros_interface/envelope_calculation.h>

#include <algorithm>
#include <chrono>

#include <cable_variation/geometry/mesh_volume.h>
#include <cable_variation/geometry/outer_surface.h>
#include <cable_variation/scene/quantity.h>
#include <cable_variation/variation/envelope_clearance.h>
#include <ros_interface/clearance_markers.h>
#include <ros_interface/component_deviations.h>
#include <ros_interface/envelope_conversion.h>
#include <ros_interface/envelope_files.h>
#include <ros_interface/envelope_markers.h>
#include <ros_interface/names.h>
#include <ros_interface/request_status.h>

namespace cable_variation_ros {

using cable_variation::Envelope;
using cable_variation::EnvelopeClearance;
using cable_variation::EnvelopePiece;
using cable_variation::EquilibriumSolver;
using cable_variation::OuterSurface;
using cable_variation::OuterSurfaceOptions;
using cable_variation::RoundedHull;
using cable_variation::Scene;
using cable_variation::Status;

namespace {

// Shares of the time done after the envelope itself, its clearances and its surface, roughly.
constexpr double kEnvelopeShare = 0.85, kClearanceShare = 0.93, kSurfaceShare = 0.97;

class Stopwatch {
 public:
  /// Since made, or last asked [s].
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    start_ = now;
    return elapsed;
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

Envelope generate(const EnvelopeTask& task, const Scene& scene, const EquilibriumSolver& solver,
                  RunControl& control) {
  const auto observe = [&](const cable_variation::EnvelopeProgress& progress) {
    control.report({progress.stage, kEnvelopeShare * progress.share, progress.solves, progress.time});
    return !control.cancelled();
  };
  try {
    return generateEnvelope(scene, task.options, solver, observe);
  } catch (const std::runtime_error& error) {
    throw RequestError(Status::NOT_CONVERGED, error.what());
  }
}

/// The surface of all pieces, or of one cable's.
OuterSurface surfaceOf(const std::vector<EnvelopePiece>& pieces, std::optional<std::size_t> cable,
                       const OuterSurfaceOptions& options) {
  std::vector<const RoundedHull*> bodies;
  for (const EnvelopePiece& piece : pieces) {
    if (!cable || piece.cable == *cable) bodies.push_back(&piece.body);
  }
  return outerSurface(bodies, options);
}

std::vector<CableSurface> surfacesByCable(const Envelope& envelope, const OuterSurface& whole,
                                          OuterSurfaceOptions options) {
  if (envelope.cables.size() == 1) return {CableSurface{envelope.cables.front(), whole.mesh}};
  options.triangles /= envelope.cables.size();
  std::vector<CableSurface> surfaces;
  for (const std::size_t cable : envelope.cables) {
    surfaces.push_back({cable, surfaceOf(envelope.frames.front().pieces, cable, options).mesh});
  }
  return surfaces;
}

InterferenceView interferenceOf(const EnvelopeTask& task, const Scene& scene,
                                const std::vector<EnvelopeClearance>& found) {
  InterferenceView view;
  view.marks = clearanceMarks(scene, found, !task.options.motions.empty());
  const cable_variation::ComponentPoses deviations =
      componentDeviations(scene, task.options.values, task.options.moved);
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

EnvelopeOutcome calculateEnvelope(const EnvelopeTask& task, const SolverContext::Snapshot& snapshot,
                                  const OutputDirectory& output, RunControl& control) {
  const Scene& scene = snapshot.design.scene;
  const EquilibriumSolver solver = solverAt(snapshot, task.options, task.other_design);
  const Envelope envelope = generate(task, scene, solver, control);
  const std::size_t solves = envelope.solves;

  Stopwatch watch;
  control.report({"clearances", kEnvelopeShare, solves, 0.0});
  cable_variation::ClearanceOptions clearance_options;
  clearance_options.skip_near_clips = task.skip_near_clips;
  const std::vector<EnvelopeClearance> found =
      clearances(scene, envelope, task.options, snapshot.parts, solver, clearance_options);
  const double clearance_time = watch.lap();
  control.throwIfCancelled();

  control.report({"surface", kClearanceShare, solves, 0.0});
  OuterSurfaceOptions surface_options;
  surface_options.excess = task.mesh_excess;
  surface_options.threads = task.options.threads;
  const OuterSurface surface = surfaceOf(envelope.frames.front().pieces, std::nullopt, surface_options);
  const std::vector<CableSurface> by_cable = surfacesByCable(envelope, surface, surface_options);
  const double surface_time = watch.lap();
  control.throwIfCancelled();

  EnvelopeOutcome outcome;
  cable_variation::GenerateEnvelopeResponse& response = outcome.response;
  response = toResponse(scene, envelope, found);
  response.header.frame_id = kWorldFrame;
  response.header.stamp = ros::Time::now();
  response.mesh = toMesh(surface.mesh);
  response.surface_excess = surface.excess;
  response.volume = volumeWithin(surface.mesh);
  response.margin = task.options.margin;
  response.seed = task.options.seed;
  response.clearance_time = clearance_time;
  response.surface_time = surface_time;

  EnvelopeView& view = outcome.view;
  view.markers = envelopeMarkers(scene, by_cable);
  if (task.show_pieces) {
    const auto pieces = pieceMarkers(scene, envelope.frames.front().pieces);
    view.markers.markers.insert(view.markers.markers.end(), pieces.markers.begin(), pieces.markers.end());
  }
  view.mesh.header = response.header;
  view.mesh.cables = response.cables;
  view.mesh.excess = response.surface_excess;
  view.mesh.mesh = response.mesh;
  view.interference = interferenceOf(task, scene, found);
  view.origin = viewOrigin(snapshot, task.options.motions);
  for (const std::string& warning : warningsOfMoved(view.origin, task.options.motions)) {
    response.warnings.push_back(warning);
  }

  if (task.name.empty()) {
    control.complete();
    return outcome;
  }
  constexpr double kWorthTelling = 1e-5;  // [m]
  control.report({"files", kSurfaceShare, solves, 0.0});
  const EnvelopeFiles files = envelopeFiles(output, task.name, scene, envelope, surface);
  response.mesh_file = files.mesh;
  response.urdf_file = files.urdf;
  response.region_file = files.region;
  if (files.rounding > kWorthTelling) {
    response.warnings.push_back("the STL files have their coordinates rounded by up to " +
                                cable_variation::shortNumber(files.rounding) +
                                " m, so far from the origin; the .obj has them all");
  }
  control.complete();
  write(files, output);
  return outcome;
}

}  // namespace cable_variation_ros
