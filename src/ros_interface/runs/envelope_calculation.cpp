#include <ros_interface/runs/envelope_calculation.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <sstream>

#include <cable_variation/envelope/clearance/closest_solved.h>
#include <cable_variation/envelope/clearance/envelope_clearance.h>
#include <cable_variation/envelope/envelope_memory.h>
#include <cable_variation/geometry/body/outer_surface.h>
#include <cable_variation/geometry/mesh/mesh_volume.h>
#include <cable_variation/util/quantity.h>
#include <ros_interface/conversion/component_deviations.h>
#include <ros_interface/conversion/envelope_conversion.h>
#include <ros_interface/markers/clearance_markers.h>
#include <ros_interface/markers/envelope_markers.h>
#include <ros_interface/node/names.h>
#include <ros_interface/request/request_status.h>
#include <ros_interface/runs/envelope_files.h>

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
                  cable_variation::ClosestSolved& closest, RunControl& control) {
  const auto observe = [&](const cable_variation::EnvelopeProgress& progress) {
    control.report({progress.stage, kEnvelopeShare * progress.share, progress.solves, progress.time});
    return !control.cancelled();
  };
  return generateEnvelope(scene, task.options, solver, observe, closest.witness());
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
  options.memory_limit /= static_cast<double>(envelope.cables.size());
  std::vector<CableSurface> surfaces;
  for (const std::size_t cable : envelope.cables) {
    surfaces.push_back({cable, surfaceOf(envelope.frames.front().pieces, cable, options).mesh});
  }
  return surfaces;
}

/// Of the nominal cables alone, the envelope's mesh will take so much at least.
void refuseFinerMeshThanMemory(const EnvelopeTask& task, const Scene& scene) {
  if (!(task.mesh_excess > 0.0)) return;
  double area = 0.0, thinnest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < scene.harness.cables.size(); ++i) {
    const auto& chosen = task.options.cables;
    if (!chosen.empty() && std::find(chosen.begin(), chosen.end(), i) == chosen.end()) continue;
    const cable_variation::Cable& cable = scene.harness.cables[i];
    double radius = std::numeric_limits<double>::infinity();
    for (const auto& part : cable.sections) radius = std::min(radius, part.section.radius);
    area += 2.0 * M_PI * radius * cable.length;
    thinnest = std::min(thinnest, radius);
  }
  const double needed = cable_variation::outerSurfaceMemory(area, thinnest, task.mesh_excess);
  if (needed <= task.mesh_memory) return;
  std::ostringstream text;
  text << "mesh_excess: is " << task.mesh_excess << " m, which would take "
       << cable_variation::memoryText(needed) << " for the nominal cables alone; allowed for the mesh are "
       << cable_variation::memoryText(task.mesh_memory) << " of ~memory_limit: expected "
       << cable_variation::finestExcess(area, thinnest, task.mesh_memory) << " m at least, or 0: its default";
  throw std::invalid_argument(text.str());
}

// What the edges of all pieces take as markers and as a message [B].
double markersOf(const Envelope& envelope) {
  constexpr double kBytes = 2.0 * 2.0 * 3.0 * 24.0;  // two points of each of three edges by vertex, twice
  double bytes = 0.0;
  for (const EnvelopePiece& piece : envelope.frames.front().pieces)
    bytes += kBytes * static_cast<double>(piece.body.core.surface().vertices.size());
  return bytes;
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
  refuseFinerMeshThanMemory(task, scene);
  const EquilibriumSolver solver = solverAt(snapshot, task.options, task.other_design);
  cable_variation::ClearanceOptions clearance_options;
  clearance_options.skip_near_clips = task.skip_near_clips;
  clearance_options.check = [&control] { control.throwIfCancelled(); };
  cable_variation::ClosestSolved closest(scene, task.options, snapshot.parts, solver, clearance_options);
  const Envelope envelope = generate(task, scene, solver, closest, control);
  const std::size_t solves = envelope.solves;

  Stopwatch watch;
  control.report({"clearances", kEnvelopeShare, solves, 0.0});
  const std::vector<EnvelopeClearance> found =
      clearances(scene, envelope, task.options, snapshot.parts, solver, clearance_options, &closest);
  const double clearance_time = watch.lap();
  control.throwIfCancelled();

  control.report({"surface", kClearanceShare, solves, 0.0});
  OuterSurfaceOptions surface_options;
  surface_options.excess = task.mesh_excess;
  surface_options.threads = task.options.threads;
  surface_options.memory_limit = task.mesh_memory;
  surface_options.check = clearance_options.check;
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
  if (surface.coarsened) {
    std::ostringstream text;
    text << "the mesh is coarser than wanted, " << 1e3 * surface.excess
         << " mm outside the envelope at most: " << cable_variation::memoryText(task.mesh_memory)
         << " of ~memory_limit are for it";
    response.warnings.push_back(text.str());
  }
  response.clearance_time = clearance_time;
  response.surface_time = surface_time;

  EnvelopeView& view = outcome.view;
  view.markers = envelopeMarkers(scene, by_cable);
  if (task.show_pieces && markersOf(envelope) > task.mesh_memory) {
    response.warnings.push_back("the pieces are not shown: the markers would take " +
                                cable_variation::memoryText(markersOf(envelope)) + ", allowed are " +
                                cable_variation::memoryText(task.mesh_memory) + " of ~memory_limit");
  } else if (task.show_pieces) {
    const auto pieces = pieceMarkers(scene, envelope.frames.front().pieces);
    view.markers.markers.insert(view.markers.markers.end(), pieces.markers.begin(), pieces.markers.end());
  }
  view.mesh.header = response.header;
  view.mesh.cables = response.cables;
  view.mesh.probability = response.probability;
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
  EnvelopeFiles files = envelopeFiles(output, task.name, scene, envelope, surface);
  control.complete();
  write(files, output);
  response.mesh_file = files.mesh;
  response.urdf_file = files.urdf;
  response.region_file = files.region;
  if (files.rounding > kWorthTelling) {
    response.warnings.push_back("the STL files have their coordinates rounded by up to " +
                                cable_variation::shortNumber(files.rounding) +
                                " m, so far from the origin; the .obj has them all");
  }
  if (!files.error.empty()) {
    response.status.code = Status::IO_ERROR;
    response.status.message = files.error;
  }
  return outcome;
}

}  // namespace cable_variation_ros
