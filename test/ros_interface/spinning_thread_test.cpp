// Tasks handed to the thread that spins.
#include <ros_interface/node/spinning_thread.h>

#include <atomic>
#include <thread>

#include <gtest/gtest.h>
#include <ros/callback_queue.h>

namespace cable_variation_ros {
namespace {

/// A queue spun by the test's own thread while `other` runs on a second one.
void spinWhile(ros::CallbackQueue& queue, const std::function<void()>& other) {
  std::atomic<bool> ended{false};
  std::thread thread([&] {
    other();
    ended = true;
  });
  while (!ended) queue.callAvailable(ros::WallDuration(0.01));
  thread.join();
}

TEST(SpinningThread, RunsTasksThereAndWaitsForThem) {
  ros::CallbackQueue queue;
  SpinningThread spinning(queue);
  std::thread::id ran_on;
  spinWhile(queue, [&] {
    spinning.run([&] { ran_on = std::this_thread::get_id(); });
    EXPECT_EQ(ran_on == std::this_thread::get_id(), false);
  });
  EXPECT_EQ(ran_on, std::this_thread::get_id());
}

TEST(SpinningThread, HandsOnWhatATaskThrows) {
  ros::CallbackQueue queue;
  SpinningThread spinning(queue);
  spinWhile(queue, [&] {
    EXPECT_THROW(spinning.run([] { throw std::invalid_argument("no cable"); }), std::invalid_argument);
  });
}

TEST(SpinningThread, WhoeverWaitsNoLongerIsLetGoAndTheTaskIsNotBegun) {
  ros::CallbackQueue queue;
  SpinningThread spinning(queue);
  const auto ran = std::make_shared<bool>(false);
  int asked = 0;
  EXPECT_THROW(spinning.run([ran] { *ran = true; }, [&] { return ++asked < 3; }), cable_variation::Cancelled);
  EXPECT_EQ(asked, 3);
  queue.callAvailable();
  EXPECT_FALSE(*ran);
}

TEST(SpinningThread, WhoeverWaitsNoLongerIsLetGoInTheMiddleOfTheTaskToo) {
  ros::CallbackQueue queue;
  SpinningThread spinning(queue);
  const auto begun = std::make_shared<std::atomic<bool>>(false);
  const auto left = std::make_shared<std::atomic<bool>>(false);
  std::thread waiting([&] {
    EXPECT_THROW(spinning.run(
                     [begun, left] {
                       *begun = true;
                       while (!*left) std::this_thread::yield();
                     },
                     [&] { return !*begun; }),
                 cable_variation::Cancelled);
    *left = true;
  });
  while (!*begun) queue.callAvailable(ros::WallDuration(0.01));
  waiting.join();
}

TEST(SpinningThread, WhoeverWaitsWhenItStopsIsToldAndTheTaskIsNotRun) {
  ros::CallbackQueue queue;
  SpinningThread spinning(queue);
  bool ran = false;
  std::thread waiting([&] { EXPECT_THROW(spinning.run([&] { ran = true; }), NodeEnds); });
  while (queue.isEmpty()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  spinning.stop();
  waiting.join();
  queue.callAvailable();
  EXPECT_FALSE(ran);
  EXPECT_THROW(spinning.run([&] { ran = true; }), NodeEnds);
}

}  // namespace
}  // namespace cable_variation_ros
