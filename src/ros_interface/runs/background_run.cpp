#include <ros_interface/runs/background_run.h>

#include <cable_variation/util/error.h>

namespace cable_variation_ros {

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

void RunControl::report(const RunProgress& progress) {
  const std::lock_guard<std::mutex> lock(mutex_);
  progress_ = progress;
}

RunProgress RunControl::progress() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return progress_;
}

BackgroundRun::BackgroundRun(const std::function<void(RunControl&)>& work) {
  std::packaged_task<void()> task([this, work] { work(control_); });
  ended_ = task.get_future();
  thread_ = std::thread(std::move(task));
}

BackgroundRun::~BackgroundRun() {
  control_.cancel();
  thread_.join();
}

bool BackgroundRun::wait(std::chrono::milliseconds timeout) const {
  return ended_.wait_for(timeout) == std::future_status::ready;
}

void BackgroundRun::finish() { ended_.get(); }

}  // namespace cable_variation_ros
