#include <ros_interface/runs/runner.h>

#include <string>
#include <utility>

#include <cable_variation/envelope/envelope_memory.h>
#include <cable_variation/util/error.h>
#include <cable_variation/util/seconds_since.h>
#include <ros_interface/node/spinning_thread.h>
#include <ros_interface/request/name_registry.h>

namespace cable_variation_ros {

using cable_variation::Clock;
using cable_variation::Progress;

namespace {

constexpr std::chrono::milliseconds kLook(20);
// What there is of a run that was cancelled is shown if the node's thread has time for it within this [s].
constexpr double kShown = 0.1;

using MemoryTaken = cable_variation::ErrorOf<cable_variation::ErrorKind::out_of_memory>;

}  // namespace

Runner::Place::Place(Runner& runner) : runner_(runner) {
  const RunLimits& limits = runner.limits_;
  const std::lock_guard<std::mutex> lock(runner.mutex_);
  if (static_cast<double>(runner.at_work_ + 1) * limits.memory_limit > limits.memory_total) {
    throw MemoryTaken("busy: runs at work: " + std::to_string(runner.at_work_) + ", each of which may take " +
                      cable_variation::memoryText(limits.memory_limit) +
                      " (~memory_limit); with another one that is more than " +
                      cable_variation::memoryText(limits.memory_total) +
                      " (~memory_total): expected to be asked again when one has ended");
  }
  ++runner.at_work_;
}

Runner::Place::~Place() {
  const std::lock_guard<std::mutex> lock(runner_.mutex_);
  --runner_.at_work_;
}

Runner::Runner(const SolverContext& context, SpinningThread& spinning, NameRegistry& names, RunLimits limits)
    : context_(context), spinning_(spinning), names_(names), limits_(std::move(limits)) {}

void Runner::run(const std::shared_ptr<LongRun>& run, const char* who, const Watcher& watcher) {
  const Place place(*this);
  Progress progress;
  const auto goes_on = [&] { return watcher(progress); };
  // The task owns what it uses: cancelled, this call does not wait for the node's thread.
  spinning_.run([run, &context = context_] { run->prepare(context); }, goes_on);
  const NameRegistry::Hold hold(names_, "name", run->name(), who);
  if (!run->name().empty()) limits_.output.requireWritable();
  awaitCancelled(goes_on);
  progress = calculate(run, watcher);
  show(run, goes_on);
}

Progress Runner::calculate(const std::shared_ptr<LongRun>& run, const Watcher& watcher) {
  auto background = std::make_unique<cable_variation::BackgroundRun>(
      [run](cable_variation::RunControl& control) { run->calculate(control); });
  while (!background->wait(kLook)) {
    if (watcher(background->control().progress()) && !spinning_.stopped()) continue;
    if (!background->control().cancel() || run->keepsWhatWasDone()) continue;
    const std::lock_guard<std::mutex> lock(mutex_);
    cancelled_.push_back(std::move(background));
    throw cable_variation::Cancelled();
  }
  background->finish();
  return background->control().progress();
}

void Runner::awaitCancelled(const std::function<bool()>& goes_on) {
  for (;;) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      cancelled_.remove_if([](const auto& each) { return each->wait(std::chrono::milliseconds(0)); });
      if (cancelled_.empty()) return;
    }
    if (!goes_on() || spinning_.stopped()) throw cable_variation::Cancelled();
    std::this_thread::sleep_for(kLook);
  }
}

void Runner::show(const std::shared_ptr<LongRun>& run, const std::function<bool()>& goes_on) {
  const auto shown = std::make_shared<bool>(false);
  const Clock::time_point calculated = Clock::now();
  const auto wait_on = [&] { return goes_on() || cable_variation::secondsSince(calculated) < kShown; };
  try {
    spinning_.run([run, shown, &context = context_] { *shown = run->show(context); }, wait_on);
  } catch (const NodeEnds&) {
    throw;
  } catch (const cable_variation::Cancelled&) {
    run->warn("not shown: it was cancelled before the node had time for it");
    return;
  }
  if (!*shown) {
    run->warn(
        "not shown: the design or the place of a component has changed meanwhile; parts in motion can be "
        "halted with moving_geometry_node's ~play");
  }
}

}  // namespace cable_variation_ros
