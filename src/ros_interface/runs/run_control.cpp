#include <ros_interface/runs/run_control.h>

#include <cable_variation/util/error.h>

namespace cable_variation_ros {

using cable_variation::Progress;

bool RunControl::cancel() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (state_ == State::running) state_ = State::cancelled;
  return state_ == State::cancelled;
}

bool RunControl::cancelled() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return state_ == State::cancelled;
}

void RunControl::complete() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (state_ == State::cancelled) throw cable_variation::Cancelled();
  state_ = State::completing;
}

void RunControl::throwIfCancelled() const {
  if (cancelled()) throw cable_variation::Cancelled();
}

void RunControl::report(const Progress& progress) {
  const std::lock_guard<std::mutex> lock(mutex_);
  progress_ = progress;
}

Progress RunControl::progress() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return progress_;
}

cable_variation::ProgressObserver RunControl::observer(double stages) {
  return [this, stages](Progress progress) {
    progress.share *= stages;
    const std::lock_guard<std::mutex> lock(mutex_);
    progress_ = std::move(progress);
    return state_ != State::cancelled;
  };
}

}  // namespace cable_variation_ros
