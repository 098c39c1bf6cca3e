#include <cable_variation/simulation/simulation_watch.h>

#include <limits>
#include <vector>

namespace cable_variation {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kAsked = 0.05;  // the observer, at most so often [s]

}  // namespace

SimulationWatch::SimulationWatch(const ProgressObserver& observer, const Scene& scene,
                                 const SimulationOptions& options)
    : observer_(observer), start_(Clock::now()) {
  progress_.stage = "times";
  progress_.wanted = options.samples;
  for (const std::size_t index : options.measures)
    progress_.figures.push_back({scene.measures[index].name, kNaN, kNaN});
}

void SimulationWatch::update(const SimulationAccumulator& figures, std::uint64_t wanted) {
  if (!observer_ || secondsSince(start_) < refreshed_ + kAsked) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  refreshed_ = secondsSince(start_);
  progress_.stage = "samples";
  progress_.done = figures.samples();
  progress_.wanted = wanted;
  progress_.share = static_cast<double>(progress_.done) / static_cast<double>(wanted);
  progress_.snapped = figures.count(SampleOutcome::snapped);
  progress_.failed = figures.count(SampleOutcome::not_converged) + figures.count(SampleOutcome::impossible);
  const std::vector<RunningFigures> running = figures.running();
  for (std::size_t i = 0; i < running.size(); ++i) {
    progress_.figures[i].mean = running[i].mean;
    progress_.figures[i].sigma = running[i].sigma;
  }
  if (due()) tell();
}

bool SimulationWatch::goesOn() {
  if (ended_) return false;
  if (!observer_ || !due()) return true;
  const std::unique_lock<std::mutex> lock(mutex_, std::try_to_lock);
  if (lock.owns_lock()) tell();
  return !ended_;
}

bool SimulationWatch::due() const { return secondsSince(start_) > told_ + kAsked; }

void SimulationWatch::tell() {
  told_ = secondsSince(start_);
  if (!ended_) ended_ = !observer_(progress_);
}

}  // namespace cable_variation
