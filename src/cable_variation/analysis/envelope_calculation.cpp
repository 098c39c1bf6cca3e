#include <cable_variation/analysis/envelope_calculation.h>

#include <functional>
#include <sstream>
#include <utility>

#include <cable_variation/analysis/envelope_report.h>
#include <cable_variation/envelope/clearance/closest_solved.h>
#include <cable_variation/envelope/envelope_memory.h>
#include <cable_variation/geometry/mesh/mesh_volume.h>
#include <cable_variation/util/quantity.h>
#include <cable_variation/util/seconds_since.h>

namespace cable_variation {

namespace {

// Shares of the time done after the envelope itself, its clearances and its surface, roughly.
constexpr double kEnvelopeShare = 0.85, kClearanceShare = 0.93, kSurfaceShare = 0.97;
// Coordinates that STL rounds by more than this are warned of [m].
constexpr double kWorthTelling = 1e-5;

std::vector<std::string> warningsFor(const EnvelopeTask& task, const EnvelopeCalculation& found) {
  std::vector<std::string> warnings = found.envelope.warnings;
  for (std::string& warning : openPartWarnings(found.clearances)) warnings.push_back(std::move(warning));
  const OuterSurface& surface = found.surfaces.whole;
  if (!surface.coarsened) return warnings;
  std::ostringstream text;
  text << "the mesh is coarser than wanted, " << 1e3 * surface.excess
       << " mm outside the envelope at most: " << memoryText(task.mesh_memory)
       << " of ~memory_limit are for it";
  warnings.push_back(text.str());
  return warnings;
}

}  // namespace

EnvelopeCalculation calculateEnvelope(const EnvelopeTask& task, const DesignSnapshot& snapshot, bool by_cable,
                                      RunControl& control) {
  const Scene& scene = snapshot.design.scene;
  refuseFinerMeshThanMemory(task, scene);
  const std::function<void()> check = [&control] { control.throwIfCancelled(); };
  EnvelopeCalculation found{
      solverAt(snapshot, task.options, task.other_design), {}, {}, {}, 0.0, 0.0, 0.0, {}};
  ClearanceOptions clearance_options;
  clearance_options.skip_near_clips = task.skip_near_clips;
  clearance_options.check = check;
  ClosestSolved closest(scene, task.options, snapshot.parts, found.solver, clearance_options);
  EnvelopeOptions options = task.options;
  options.cuts = closest.cuts();
  found.envelope =
      generateEnvelope(scene, options, found.solver, control.observer(kEnvelopeShare), closest.witness());

  Clock::time_point start = Clock::now();
  control.report({"clearances", kEnvelopeShare, found.envelope.solves});
  found.clearances = clearances(scene, found.envelope, task.options, snapshot.parts, found.solver,
                                clearance_options, &closest);
  found.clearance_time = secondsSince(start);
  control.throwIfCancelled();

  start = Clock::now();
  control.report({"surface", kClearanceShare, found.envelope.solves});
  found.surfaces = envelopeSurfaces(task, found.envelope, by_cable, check);
  found.volume = volumeWithin(found.surfaces.whole.mesh);
  found.surface_time = secondsSince(start);
  control.throwIfCancelled();
  found.warnings = warningsFor(task, found);
  return found;
}

EnvelopeFiles writeEnvelope(const EnvelopeTask& task, const DesignSnapshot& snapshot,
                            const EnvelopeCalculation& found, const OutputDirectory& output,
                            std::vector<std::string>& warnings, RunControl& control) {
  if (task.name.empty()) {
    control.complete();
    return {};
  }
  control.report({"files", kSurfaceShare, found.envelope.solves});
  const OuterSurface& surface = found.surfaces.whole;
  const std::string report = envelopeReport(
      task, snapshot, found.solver,
      {task.options, found.envelope, found.clearances, surface.mesh, surface.excess, found.volume}, warnings);
  EnvelopeFiles files =
      envelopeFiles(output, task.name, snapshot.design.scene, found.envelope, surface, report);
  control.complete();
  write(files, output);
  if (files.rounding > kWorthTelling) {
    warnings.push_back("the STL files have their coordinates rounded by up to " +
                       shortNumber(files.rounding) + " m, so far from the origin; the .obj has them all");
  }
  return files;
}

}  // namespace cable_variation
