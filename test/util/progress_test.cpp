// Progress told, time left, and ends asked for.
#include <cable_variation/util/progress.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <cable_variation/util/error.h>

namespace cable_variation {
namespace {

TEST(progress, time_left_goes_by_what_was_done_so_far) {
  EXPECT_DOUBLE_EQ(timeLeft(3.0, 0.25), 9.0);
  EXPECT_DOUBLE_EQ(timeLeft(3.0, 1.0), 0.0);
  EXPECT_TRUE(std::isnan(timeLeft(3.0, 0.0)));
  EXPECT_TRUE(std::isnan(timeLeft(3.0, std::nan(""))));
}

TEST(progress, an_end_asked_for_once_is_an_end_for_all) {
  std::vector<Progress> told;
  const ProgressObserver observer = [&](const Progress& progress) {
    told.push_back(progress);
    return told.size() != 3;
  };
  ProgressReporter report(observer);
  report({"shapes", 0.5, 12, 0.25});
  report.check();  // tells again what is known
  ASSERT_EQ(told.size(), 2U);
  EXPECT_EQ(told[1].stage, "shapes");
  EXPECT_EQ(told[1].done, 12U);
  EXPECT_THROW(report({"containment", 0.6}), Cancelled);
  EXPECT_THROW(report.check(), Cancelled);
  EXPECT_THROW(report({"containment", 0.7}), Cancelled);
  EXPECT_EQ(told.size(), 3U);  // and it is not asked again
}

TEST(progress, one_thread_at_a_time_is_told) {
  std::atomic<int> inside{0}, most{0};
  int calls = 0;  // not atomic: a data race would be seen by a sanitizer, and lose some
  const ProgressObserver observer = [&](const Progress&) {
    most = std::max(most.load(), ++inside);
    ++calls;
    --inside;
    return true;
  };
  ProgressReporter report(observer);
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      for (int k = 0; k < 1000; ++k) report.check();
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(most, 1);
  EXPECT_EQ(calls, 4000);
}

TEST(progress, without_an_observer_nobody_is_asked) {
  const ProgressObserver none;
  ProgressReporter report(none);
  EXPECT_NO_THROW(report({"shapes", 0.5}));
  EXPECT_NO_THROW(report.check());
}

}  // namespace
}  // namespace cable_variation
