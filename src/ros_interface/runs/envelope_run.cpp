#include <ros_interface/runs/envelope_run.h>

#include <sstream>
#include <utility>

#include <cable_variation/envelope/clearance/closest_solved.h>
#include <cable_variation/envelope/envelope_memory.h>
#include <cable_variation/geometry/mesh/mesh_volume.h>
#include <cable_variation/util/quantity.h>
#include <cable_variation/util/seconds_since.h>
#include <ros_interface/conversion/component_deviations.h>
#include <ros_interface/conversion/envelope_conversion.h>
#include <ros_interface/markers/clearance_markers.h>
#include <ros_interface/node/names.h>
#include <ros_interface/runs/envelope_files.h>
#include <ros_interface/runs/envelope_report.h>

namespace cable_variation_ros {

using cable_variation::Clock;
using cable_variation::Envelope;
using cable_variation::EnvelopeClearance;
using cable_variation::EnvelopePiece;
using cable_variation::EquilibriumSolver;
using cable_variation::OuterSurface;
using cable_variation::Scene;
using cable_variation::secondsSince;
using cable_variation::Status;

namespace {

// Shares of the time done after the envelope itself, its clearances and its surface, roughly.
constexpr double kEnvelopeShare = 0.85, kClearanceShare = 0.93, kSurfaceShare = 0.97;
// Coordinates that STL rounds by more than this are warned of [m].
constexpr double kWorthTelling = 1e-5;

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
  task_ = toEnvelopeTask(request_, context.design(), context.moved(), limits_.threads, limits_.memory_limit);
  snapshot_ = context.snapshot();
  if (!task_.options.motions.empty()) snapshot_.design = withShiftsInScene(std::move(snapshot_.design));
}

void EnvelopeRun::calculate(RunControl& control) {
  refuseFinerMeshThanMemory(task_, scene());
  const Result result = solve(control);
  control.throwIfCancelled();
  answer(result);
  view(result);
  write(result, control);
}

bool EnvelopeRun::show(const SolverContext& context) { return publisher_.show(std::move(view_), context); }

EnvelopeRun::Result EnvelopeRun::solve(RunControl& control) {
  const std::function<void()> check = [&control] { control.throwIfCancelled(); };
  Result result{solverAt(snapshot_, task_.options, task_.other_design), {}, {}, {}};
  const EquilibriumSolver& solver = result.solver;
  cable_variation::ClearanceOptions clearance_options;
  clearance_options.skip_near_clips = task_.skip_near_clips;
  clearance_options.check = check;
  cable_variation::ClosestSolved closest(scene(), task_.options, snapshot_.parts, solver, clearance_options);
  task_.options.cuts = closest.cuts();
  result.envelope =
      generateEnvelope(scene(), task_.options, solver, control.observer(kEnvelopeShare), closest.witness());

  Clock::time_point start = Clock::now();
  control.report({"clearances", kEnvelopeShare, result.envelope.solves});
  result.clearances = clearances(scene(), result.envelope, task_.options, snapshot_.parts, solver,
                                 clearance_options, &closest);
  response_.clearance_time = secondsSince(start);
  control.throwIfCancelled();

  start = Clock::now();
  control.report({"surface", kClearanceShare, result.envelope.solves});
  result.surfaces = envelopeSurfaces(task_, result.envelope, check);
  response_.surface_time = secondsSince(start);
  return result;
}

void EnvelopeRun::answer(const Result& result) {
  const OuterSurface& surface = result.surfaces.whole;
  Response answer = toResponse(scene(), result.envelope, result.clearances);
  answer.clearance_time = response_.clearance_time;
  answer.surface_time = response_.surface_time;
  answer.header.frame_id = kWorldFrame;
  answer.header.stamp = ros::Time::now();
  answer.mesh = toMesh(surface.mesh);
  answer.surface_excess = surface.excess;
  answer.volume = volumeWithin(surface.mesh);
  answer.margin = task_.options.margin;
  answer.seed = task_.options.seed;
  response_ = std::move(answer);
  if (!surface.coarsened) return;
  std::ostringstream text;
  text << "the mesh is coarser than wanted, " << 1e3 * surface.excess
       << " mm outside the envelope at most: " << cable_variation::memoryText(task_.mesh_memory)
       << " of ~memory_limit are for it";
  warn(text.str());
}

void EnvelopeRun::view(const Result& result) {
  const Envelope& envelope = result.envelope;
  view_.markers = envelopeMarkers(scene(), result.surfaces.by_cable);
  if (task_.show_pieces && markersOf(envelope) > task_.mesh_memory) {
    warn("the pieces are not shown: the markers would take " +
         cable_variation::memoryText(markersOf(envelope)) + ", allowed are " +
         cable_variation::memoryText(task_.mesh_memory) + " of ~memory_limit");
  } else if (task_.show_pieces) {
    const auto pieces = pieceMarkers(scene(), envelope.frames.front().pieces);
    view_.markers.markers.insert(view_.markers.markers.end(), pieces.markers.begin(), pieces.markers.end());
  }
  view_.mesh.header = response_.header;
  view_.mesh.cables = response_.cables;
  view_.mesh.probability = response_.probability;
  view_.mesh.excess = response_.surface_excess;
  view_.mesh.mesh = response_.mesh;
  view_.interference = interferenceOf(task_, scene(), snapshot_.on_tf, result.clearances);
  view_.origin = viewOrigin(snapshot_, task_.options.motions);
  for (const std::string& warning : warningsOfMoved(view_.origin, task_.options.motions)) warn(warning);
}

void EnvelopeRun::write(const Result& result, RunControl& control) {
  if (task_.name.empty()) return control.complete();
  control.report({"files", kSurfaceShare, result.envelope.solves});
  const OuterSurface& surface = result.surfaces.whole;
  const std::string report = envelopeReport(
      task_, snapshot_, result.solver,
      {task_.options, result.envelope, result.clearances, surface.mesh, surface.excess, response_.volume},
      response_.warnings);
  EnvelopeFiles files = envelopeFiles(limits_.output, task_.name, scene(), result.envelope, surface, report);
  control.complete();
  cable_variation_ros::write(files, limits_.output);
  response_.mesh_file = files.mesh;
  response_.urdf_file = files.urdf;
  response_.region_file = files.region;
  response_.report_file = files.report;
  if (files.rounding > kWorthTelling) {
    warn("the STL files have their coordinates rounded by up to " +
         cable_variation::shortNumber(files.rounding) + " m, so far from the origin; the .obj has them all");
  }
  if (files.error.empty()) return;
  response_.status.code = Status::IO_ERROR;
  response_.status.message = files.error;
}

}  // namespace cable_variation_ros
