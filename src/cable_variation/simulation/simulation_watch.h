#pragma once  // internal to simulation/

#include <atomic>
#include <cstdint>
#include <mutex>

#include <cable_variation/scene/scene.h>
#include <cable_variation/simulation/simulation.h>
#include <cable_variation/util/progress.h>
#include <cable_variation/util/seconds_since.h>

namespace cable_variation {

/// Tells the observer of a simulation, one thread at a time, and remembers when it wants an end.
class SimulationWatch {
 public:
  /// @param observer must outlive the watch @param options with all measures named
  SimulationWatch(const ProgressObserver& observer, const Scene& scene, const SimulationOptions& options);

  bool ended() const { return ended_; }
  void update(const SimulationAccumulator& figures, std::uint64_t wanted);
  /// By any thread; whether the work goes on.
  bool goesOn();

 private:
  bool due() const;
  void tell();

  const ProgressObserver& observer_;
  Clock::time_point start_;
  std::mutex mutex_;
  Progress progress_;
  double refreshed_ = 0.0;  // the figures in it [s]; told or not, for others tell in between
  std::atomic<double> told_{0.0};
  std::atomic<bool> ended_{false};
};

}  // namespace cable_variation
