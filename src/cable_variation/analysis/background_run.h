#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <thread>

#include <cable_variation/analysis/run_control.h>

namespace cable_variation {

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

}  // namespace cable_variation
