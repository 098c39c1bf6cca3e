// Requests on a thread of their own: who asks does not wait, and of those out of date only the newest is
// done.
#include <rviz_plugins/panel/request_worker.h>

#include <algorithm>
#include <chrono>
#include <future>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace cable_variation_rviz {
namespace {

using Clock = std::chrono::steady_clock;

TEST(RequestWorker, DoesTheNewestOfThoseThatWait) {
  std::vector<int> done;
  std::promise<void> begun, go, all;
  {
    RequestWorker worker;
    worker.post("", [&] {
      begun.set_value();
      go.get_future().wait();
    });
    begun.get_future().wait();
    for (int i = 1; i <= 100; ++i) worker.post("slider", [&, i] { done.push_back(i); });
    worker.post("", [&] { done.push_back(-1); });
    worker.post("other", [&] { done.push_back(-2); });
    worker.post("last", [&] { all.set_value(); });
    go.set_value();
    all.get_future().wait();
  }
  EXPECT_EQ(done.size(), 3u);
  EXPECT_EQ(std::count(done.begin(), done.end(), 100), 1);
}

TEST(RequestWorker, LetsNobodyWaitAndKeepsThePause) {
  std::vector<Clock::time_point> starts;
  std::promise<void> last;
  RequestWorker worker;
  const Clock::time_point before = Clock::now();
  worker.post("", [] { std::this_thread::sleep_for(std::chrono::milliseconds(300)); });
  EXPECT_LT(Clock::now() - before, std::chrono::milliseconds(200));
  for (int i = 0; i < 200; ++i) {
    worker.post("slider", [&, i] {
      starts.push_back(Clock::now());
      if (i == 199) last.set_value();
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(3));
  }
  last.get_future().wait();
  ASSERT_GE(starts.size(), 2u);  // followed on the way, not only at its end
  for (std::size_t i = 1; i < starts.size(); ++i) {
    EXPECT_GE(starts[i] - starts[i - 1], RequestWorker::kPause);
  }
}

TEST(RequestWorker, EndsWithoutWhatHasNotBegun) {
  int done = 0;
  {
    RequestWorker worker;
    std::promise<void> begun;
    worker.post("", [&] {
      begun.set_value();
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    });
    begun.get_future().wait();
    for (int i = 0; i < 10; ++i) worker.post("", [&] { ++done; });
  }
  EXPECT_EQ(done, 0);
}

}  // namespace
}  // namespace cable_variation_rviz
