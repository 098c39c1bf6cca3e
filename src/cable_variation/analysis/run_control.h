#pragma once

#include <mutex>

#include <cable_variation/util/progress.h>

namespace cable_variation {

/// What long work and those who wait for it tell each other. Cancelling and completing exclude each other:
/// what has been cancelled leaves nothing behind, what completes can no longer be cancelled.
class RunControl {
 public:
  bool cancel();  ///< false: too late, the work is being completed
  bool cancelled() const;

  /// By the work, before it leaves a trace such as a file. Throws Cancelled.
  void complete();
  /// Throws Cancelled.
  void throwIfCancelled() const;

  void report(const Progress& progress);
  Progress progress() const;

  /// What a calculation of the core is to tell of itself and to be asked by. Must not outlive this.
  /// @param stages the share of the whole that its end is, 0 to 1
  ProgressObserver observer(double stages = 1.0);

 private:
  enum class State { running, cancelled, completing };
  mutable std::mutex mutex_;
  State state_ = State::running;
  Progress progress_;
};

}  // namespace cable_variation
