// One after the other in their order, some wait, the rest is told to be busy.
#include <ros_interface/node/turns.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <future>
#include <list>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <cable_variation/util/error.h>

namespace cable_variation_ros {
namespace {

using cable_variation::Cancelled;

constexpr std::size_t kWaiting = 3;

/// Threads that ask for a turn, and keep it until they are told.
class Askers {
 public:
  ~Askers() { endAll(); }

  /// Another one; returns when it has its turn, has been refused, or surely waits.
  void ask() {
    const int number = static_cast<int>(threads_.size());
    std::promise<void> answered;
    std::future<void> answer = answered.get_future();
    threads_.emplace_back([this, number, answered = std::move(answered)]() mutable {
      try {
        const Turns::Turn turn(turns_);
        if (++at_work_ > 1) ++together_;
        record(served_, number);
        answered.set_value();
        until_.wait();
        --at_work_;
      } catch (const Cancelled& error) {
        message_ = error.what();
        record(refused_, number);
        answered.set_value();
      }
    });
    answer.wait_for(std::chrono::milliseconds(100));
  }

  void endAll() {
    end_.set_value();
    for (std::thread& thread : threads_) thread.join();
    threads_.clear();
    end_ = {};
    until_ = end_.get_future().share();
  }

  std::vector<int> served() { return copy(served_); }
  std::vector<int> refused() { return copy(refused_); }
  int together() const { return together_; }
  const std::string& message() const { return message_; }

 private:
  void record(std::vector<int>& list, int number) {
    const std::lock_guard<std::mutex> lock(mutex_);
    list.push_back(number);
  }
  std::vector<int> copy(const std::vector<int>& list) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return list;
  }

  Turns turns_{kWaiting};
  std::mutex mutex_;
  std::vector<int> served_, refused_;
  std::string message_;
  std::atomic<int> at_work_{0}, together_{0};
  std::promise<void> end_;
  std::shared_future<void> until_ = end_.get_future().share();
  std::list<std::thread> threads_;
};

TEST(Turns, OneIsAtWorkSomeWaitAndTheRestIsRefusedAtOnce) {
  Askers askers;
  for (std::size_t i = 0; i < 1 + kWaiting + 2; ++i) askers.ask();
  EXPECT_EQ(askers.served(), std::vector<int>{0});
  EXPECT_EQ(askers.refused(), (std::vector<int>{4, 5}));
  EXPECT_NE(askers.message().find("busy: a request is at work and 3 wait"), std::string::npos)
      << askers.message();
  askers.endAll();
  EXPECT_EQ(askers.served(), (std::vector<int>{0, 1, 2, 3}));  // in the order they came
  EXPECT_EQ(askers.together(), 0);
}

TEST(Turns, WhenSomeHaveEndedOthersAreServed) {
  Askers askers;
  for (int round = 0; round < 3; ++round) {
    for (std::size_t i = 0; i < 1 + kWaiting; ++i) askers.ask();
    askers.endAll();
  }
  EXPECT_TRUE(askers.refused().empty());
  EXPECT_EQ(askers.served().size(), 3 * (1 + kWaiting));
}

}  // namespace
}  // namespace cable_variation_ros
