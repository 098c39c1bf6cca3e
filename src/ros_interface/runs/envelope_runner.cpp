#include <ros_interface/runs/envelope_runner.h>

#include <cable_variation/util/error.h>
#include <ros_interface/node/names.h>
#include <ros_interface/node/spinning_thread.h>
#include <ros_interface/request/name_registry.h>
#include <ros_interface/request/request_status.h>
#include <ros_interface/runs/envelope_calculation.h>

namespace cable_variation_ros {

using cable_variation::GenerateEnvelopeRequest;
using cable_variation::GenerateEnvelopeResponse;
using cable_variation::Status;

namespace {

constexpr std::chrono::milliseconds kLook(20);

}  // namespace

EnvelopeRunner::EnvelopeRunner(SolverContext& context, EnvelopePublisher& publisher, SpinningThread& spinning,
                               const OutputDirectory& output, NameRegistry& names, std::size_t threads,
                               double memory_limit)
    : context_(context),
      publisher_(publisher),
      spinning_(spinning),
      output_(output),
      names_(names),
      threads_(threads),
      memory_limit_(memory_limit) {}

GenerateEnvelopeResponse EnvelopeRunner::run(const GenerateEnvelopeRequest& request, const Watcher& watcher) {
  GenerateEnvelopeResponse response;
  const Status status = runRequest([&] { response = complete(request, watcher); });
  if (status.code != Status::SUCCESS) response.status = status;
  return response;
}

GenerateEnvelopeResponse EnvelopeRunner::complete(const GenerateEnvelopeRequest& request,
                                                  const Watcher& watcher) {
  EnvelopeTask task;
  std::shared_ptr<const SolverContext::Snapshot> snapshot;
  spinning_.run([&] {
    task = toEnvelopeTask(request, context_.design(), context_.moved(), threads_, memory_limit_);
    snapshot = std::make_shared<SolverContext::Snapshot>(context_.snapshot());
  });

  const NameRegistry::Hold hold(names_, "name", task.name, kGenerateEnvelopeService);

  // What the run uses is shared with it: cancelled, it outlives this call.
  const auto outcome = std::make_shared<EnvelopeOutcome>();
  auto background =
      std::make_unique<BackgroundRun>([outcome, task, snapshot, output = output_](RunControl& control) {
        *outcome = calculateEnvelope(task, *snapshot, output, control);
      });
  while (!background->wait(kLook)) {
    const bool go_on = watcher(background->control().progress()) && !spinning_.stopped();
    if (!go_on && background->control().cancel()) {
      leave(std::move(background));
      throw cable_variation::Cancelled();
    }
  }
  background->finish();
  bool shown = false;
  spinning_.run([&] { shown = publisher_.show(std::move(outcome->view), context_); });
  if (!shown) {
    outcome->response.warnings.emplace_back(
        "not shown: the design or the place of a component has changed meanwhile; parts in motion can be "
        "halted "
        "with moving_geometry_node's ~play");
  }
  return std::move(outcome->response);
}

void EnvelopeRunner::leave(std::unique_ptr<BackgroundRun> cancelled) {
  const std::lock_guard<std::mutex> lock(mutex_);
  cancelled_.remove_if([](const auto& each) { return each->wait(std::chrono::milliseconds(0)); });
  cancelled_.push_back(std::move(cancelled));
}

}  // namespace cable_variation_ros
