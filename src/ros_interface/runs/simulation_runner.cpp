#include <ros_interface/runs/simulation_runner.h>

#include <mutex>
#include <optional>

#include <ros_interface/display/variation_publisher.h>
#include <ros_interface/node/names.h>
#include <ros_interface/node/spinning_thread.h>
#include <ros_interface/request/name_registry.h>
#include <ros_interface/request/request_status.h>
#include <ros_interface/runs/background_run.h>
#include <ros_interface/runs/simulation_calculation.h>

namespace cable_variation_ros {

using cable_variation::MeasureEvaluator;
using cable_variation::SimulateVariationRequest;
using cable_variation::SimulateVariationResponse;
using cable_variation::SimulationProgress;
using cable_variation::Status;

namespace {

constexpr std::chrono::milliseconds kLook(20);

/// The design that is simulated, and progress, shared with the run's thread.
struct Shared {
  SimulationTask task;
  SolverContext::Snapshot snapshot;
  std::optional<MeasureEvaluator> evaluator;
  SimulationResult result;
  std::mutex mutex;
  SimulationProgress progress;
};

}  // namespace

SimulationRunner::SimulationRunner(SolverContext& context, VariationPublisher& publisher,
                                   SpinningThread& spinning, const OutputDirectory& output,
                                   NameRegistry& names, std::size_t threads, double memory_limit)
    : context_(context),
      publisher_(publisher),
      spinning_(spinning),
      output_(output),
      names_(names),
      threads_(threads),
      memory_limit_(memory_limit) {}

SimulateVariationResponse SimulationRunner::run(const SimulateVariationRequest& request,
                                                const Watcher& watcher) {
  SimulateVariationResponse response;
  const Status status = runRequest([&] { response = complete(request, watcher); });
  if (status.code != Status::SUCCESS) {
    response = SimulateVariationResponse();
    response.status = status;
  }
  return response;
}

SimulateVariationResponse SimulationRunner::complete(const SimulateVariationRequest& request,
                                                     const Watcher& watcher) {
  Shared shared;
  std::vector<std::string> measures;
  spinning_.run([&] {
    shared.task = toSimulationTask(request, context_.design(), context_.moved(), threads_, memory_limit_);
    shared.snapshot = context_.snapshot();
    shared.evaluator.emplace(context_.evaluator(shared.snapshot));
  });
  for (const std::size_t index : shared.task.options.measures) {
    measures.push_back(shared.snapshot.design.scene.measures[index].name);
  }
  const NameRegistry::Hold hold(names_, "name", shared.task.name, kSimulateVariationService);

  BackgroundRun background([&](RunControl& control) {
    const auto observe = [&](const SimulationProgress& progress) {
      const std::lock_guard<std::mutex> lock(shared.mutex);
      shared.progress = progress;
      return !control.cancelled();
    };
    shared.result = calculateSimulation(shared.task, shared.snapshot, *shared.evaluator, output_, observe);
  });
  while (!background.wait(kLook)) {
    SimulationProgress progress;
    {
      const std::lock_guard<std::mutex> lock(shared.mutex);
      progress = shared.progress;
    }
    if (!watcher(progress, measures) || spinning_.stopped()) background.control().cancel();
  }
  background.finish();

  SimulationResult& result = shared.result;
  if (result.view.markers.markers.empty()) return std::move(result.response);
  bool shown = false;
  spinning_.run([&] {
    shown = result.origin.fits(context_);
    if (!shown) return;
    publisher_.show(result.view.markers, result.view.legend, [this, origin = result.origin] {
      if (!origin.fits(context_)) publisher_.clear();
    });
  });
  if (!shown) {
    result.response.warnings.emplace_back(
        "not shown: the design or the place of a component has changed meanwhile; parts in motion can be "
        "halted "
        "with moving_geometry_node's ~play");
  }
  return std::move(result.response);
}

}  // namespace cable_variation_ros
