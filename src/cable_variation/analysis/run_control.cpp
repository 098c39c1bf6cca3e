#include <cable_variation/analysis/run_control.h>

#include <cable_variation/util/error.h>

namespace cable_variation {

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
  if (state_ == State::cancelled) throw Cancelled();
  state_ = State::completing;
}

void RunControl::throwIfCancelled() const {
  if (cancelled()) throw Cancelled();
}

void RunControl::report(const Progress& progress) {
  const std::lock_guard<std::mutex> lock(mutex_);
  progress_ = progress;
}

Progress RunControl::progress() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return progress_;
}

ProgressObserver RunControl::observer(double stages) {
  return [this, stages](Progress progress) {
    progress.share *= stages;
    const std::lock_guard<std::mutex> lock(mutex_);
    progress_ = std::move(progress);
    return state_ != State::cancelled;
  };
}

}  // namespace cable_variation
