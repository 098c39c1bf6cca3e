#pragma once

#include <cstddef>
#include <functional>
#include <list>
#include <memory>
#include <mutex>

#include <cable_variation/analysis/background_run.h>
#include <ros_interface/runs/long_run.h>

namespace cable_variation_ros {

class NameRegistry;
class SolverContext;
class SpinningThread;

/// Takes long runs through their steps, for services and actions: the node answers others meanwhile.
class Runner {
 public:
  /// All must outlive it. @param names of the files that are being written
  Runner(const SolverContext& context, SpinningThread& spinning, NameRegistry& names, RunLimits limits);

  const RunLimits& limits() const { return limits_; }

  /// Told how far a run is, some fifty times a second; false: cancel it.
  using Watcher = cable_variation::ProgressObserver;

  /// Not from the spinning thread. Returns some 20 ms after it is cancelled, or as soon as a run that has an
  /// answer even then gives it. What is cancelled goes on to where it notices; the next run waits for that.
  /// @param who asks, such as "generate_envelope": told to others who want to write files of the same name
  /// Throws, before all, an out_of_memory Error: with it, runs would be at work that may take more than
  /// RunLimits::memory_total; what the steps throw; std::invalid_argument: another run writes files of the
  /// name; cable_variation::FileError: none can be written into the folder, told before anything is
  /// calculated; cable_variation::Cancelled.
  void run(const std::shared_ptr<LongRun>& run, const char* who, const Watcher& watcher);

 private:
  /// Among the runs at work, from before the first step to after the last.
  class Place {
   public:
    explicit Place(Runner& runner);
    ~Place();
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;

   private:
    Runner& runner_;
  };

  void awaitCancelled(const std::function<bool()>& goes_on);
  cable_variation::Progress calculate(const std::shared_ptr<LongRun>& run, const Watcher& watcher);
  void show(const std::shared_ptr<LongRun>& run, const std::function<bool()>& goes_on);

  const SolverContext& context_;
  SpinningThread& spinning_;
  NameRegistry& names_;
  RunLimits limits_;
  std::mutex mutex_;
  std::size_t at_work_ = 0;
  std::list<std::unique_ptr<cable_variation::BackgroundRun>> cancelled_;  ///< that have not noticed yet
};

}  // namespace cable_variation_ros
