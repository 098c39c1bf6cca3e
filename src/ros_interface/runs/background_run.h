#pragma once

#include <chrono>
#include <exception>
#include <functional>
#include <future>
#include <mutex>
#include <string>
#include <thread>

namespace cable_variation_ros {

struct RunProgress {
  std::string stage;       ///< for a person
  double share = 0.0;      ///< of the whole, 0 to 1
  std::size_t solves = 0;  ///< equilibria so far
  double time = 0.0;       ///< of a motion, reached [s]
};

/// What long work and those who wait for it tell each other. Cancelling and completing exclude each other:
/// what has been cancelled leaves nothing behind, what completes can no longer be cancelled.
class RunControl {
 public:
  bool cancel();  ///< false: too late, the work is being completed
  bool cancelled() const;

  /// By the work, before it leaves a trace such as a file. Throws cable_variation::Cancelled.
  void complete();
  /// Throws cable_variation::Cancelled.
  void throwIfCancelled() const;

  void report(const RunProgress& progress);
  RunProgress progress() const;

 private:
  enum class State { running, cancelled, completing };
  mutable std::mutex mutex_;
  State state_ = State::running;
  RunProgress progress_;
};

/// Work on a thread of its own. Going away cancels it and waits for its end.
class BackgroundRun {
 public:
  explicit BackgroundRun(const std::function<void(RunControl&)>& work);
  ~BackgroundRun();
  BackgroundRun(const BackgroundRun&) = delete;
  BackgroundRun& operator=(const BackgroundRun&) = delete;

  RunControl& control() { return control_; }

  bool wait(std::chrono::milliseconds timeout) const;  ///< whether it has ended
  /// Once it has ended: throws what the work threw.
  void finish();

 private:
  RunControl control_;
  std::future<void> ended_;
  std::thread thread_;
};

}  // namespace cable_variation_ros
