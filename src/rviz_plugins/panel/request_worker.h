#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace cable_variation_rviz {

/// A thread that does one task after another, so that who asks never waits. Of tasks with the same key that
/// still wait, only the newest is done, and no two of them start within kPause of each other.
class RequestWorker {
 public:
  static constexpr std::chrono::milliseconds kPause{20};  ///< 50 a second: smooth, and others have a turn

  RequestWorker();
  /// Leaves out what has not begun, and waits for what has.
  ~RequestWorker();
  RequestWorker(const RequestWorker&) = delete;
  RequestWorker& operator=(const RequestWorker&) = delete;

  /// @param key empty: in place of none
  void post(const std::string& key, std::function<void()> task);

 private:
  struct Entry {
    std::string key;
    std::function<void()> task;
  };
  void run();

  std::mutex mutex_;
  std::condition_variable more_;
  std::deque<Entry> waiting_;
  bool ends_ = false;
  std::thread thread_;  ///< last: it uses the rest
};

}  // namespace cable_variation_rviz
