#include <rviz_plugins/panel/request_worker.h>

#include <algorithm>
#include <map>
#include <utility>

namespace cable_variation_rviz {

RequestWorker::RequestWorker() : thread_([this] { run(); }) {}

RequestWorker::~RequestWorker() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ends_ = true;
    waiting_.clear();
  }
  more_.notify_all();
  thread_.join();
}

void RequestWorker::post(const std::string& key, std::function<void()> task) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto older = std::find_if(waiting_.begin(), waiting_.end(),
                                    [&](const Entry& entry) { return !key.empty() && entry.key == key; });
    if (older != waiting_.end()) {
      older->task = std::move(task);
    } else {
      waiting_.push_back({key, std::move(task)});
    }
  }
  more_.notify_all();
}

void RequestWorker::run() {
  using Clock = std::chrono::steady_clock;
  std::map<std::string, Clock::time_point> earliest;
  std::unique_lock<std::mutex> lock(mutex_);
  while (!ends_) {
    const auto due = [&](const Entry& entry) {
      return entry.key.empty() ? Clock::time_point() : earliest[entry.key];
    };
    const auto next = std::min_element(waiting_.begin(), waiting_.end(),
                                       [&](const Entry& a, const Entry& b) { return due(a) < due(b); });
    if (next == waiting_.end()) {
      more_.wait(lock);
      continue;
    }
    const Clock::time_point when = due(*next);
    if (when > Clock::now()) {
      more_.wait_until(lock, when);
      continue;
    }
    const Entry entry = std::move(*next);
    waiting_.erase(next);
    if (!entry.key.empty()) earliest[entry.key] = Clock::now() + kPause;
    lock.unlock();
    entry.task();
    lock.lock();
  }
}

}  // namespace cable_variation_rviz
