// Long work: watched, called off, and never both cancelled and completed.
#include <cable_variation/analysis/background_run.h>

#include <atomic>

#include <gtest/gtest.h>

#include <cable_variation/util/error.h>

namespace cable_variation {
namespace {

using namespace std::chrono_literals;

constexpr auto kLong = 10000ms;

TEST(BackgroundRun, TellsHowFarItIsAndThatItHasEnded) {
  std::promise<void> go_on;
  std::shared_future<void> told = go_on.get_future().share();
  BackgroundRun run([told](RunControl& control) {
    control.report({"shapes", 0.5, 12, 0.25});
    told.wait();
  });
  while (run.control().progress().done == 0) EXPECT_FALSE(run.wait(1ms));
  EXPECT_EQ(run.control().progress().stage, "shapes");
  EXPECT_EQ(run.control().progress().share, 0.5);
  EXPECT_EQ(run.control().progress().time, 0.25);
  go_on.set_value();
  EXPECT_TRUE(run.wait(kLong));
  run.finish();
}

TEST(BackgroundRun, WhatTheWorkThrowsComesOut) {
  BackgroundRun run([](RunControl&) { throw std::invalid_argument("margin: is -1"); });
  ASSERT_TRUE(run.wait(kLong));
  EXPECT_THROW(run.finish(), std::invalid_argument);
}

TEST(BackgroundRun, CancelledWorkLeavesNoTrace) {
  std::atomic<bool> written{false};
  BackgroundRun run([&](RunControl& control) {
    while (!control.cancelled()) std::this_thread::sleep_for(1ms);
    control.complete();
    written = true;
  });
  EXPECT_TRUE(run.control().cancel());
  ASSERT_TRUE(run.wait(kLong));
  EXPECT_THROW(run.finish(), Cancelled);
  EXPECT_FALSE(written);
}

TEST(BackgroundRun, WhatIsBeingCompletedCannotBeCancelled) {
  std::promise<void> completing, go_on;
  std::shared_future<void> told = go_on.get_future().share();
  BackgroundRun run([&completing, told](RunControl& control) {
    control.complete();
    completing.set_value();
    told.wait();
  });
  completing.get_future().wait();
  EXPECT_FALSE(run.control().cancel());
  go_on.set_value();
  ASSERT_TRUE(run.wait(kLong));
  EXPECT_NO_THROW(run.finish());
}

TEST(BackgroundRun, ACalculationOfTheCoreTellsItsShareOfTheWholeAndIsAskedToEnd) {
  RunControl control;
  const cable_variation::ProgressObserver observer = control.observer(0.8);
  EXPECT_TRUE(observer({"shapes", 0.5, 12}));
  EXPECT_EQ(control.progress().stage, "shapes");
  EXPECT_EQ(control.progress().share, 0.4);
  EXPECT_TRUE(control.cancel());
  EXPECT_FALSE(observer({"shapes", 0.6, 13}));
}

TEST(BackgroundRun, GoingAwayCancels) {
  std::atomic<bool> ended{false};
  {
    BackgroundRun run([&](RunControl& control) {
      while (!control.cancelled()) std::this_thread::sleep_for(1ms);
      ended = true;
    });
  }
  EXPECT_TRUE(ended);
}

}  // namespace
}  // namespace cable_variation
