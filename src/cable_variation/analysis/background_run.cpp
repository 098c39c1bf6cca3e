#include <cable_variation/analysis/background_run.h>

namespace cable_variation {

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

}  // namespace cable_variation
