// Long runs taken through their steps: which thread does what, cancels at every step, names, folders.
#include <ros_interface/runs/runner.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/time.h>

#include <cable_variation/util/error.h>
#include <cable_variation/util/seconds_since.h>
#include <ros_interface/context/solver_context.h>
#include <ros_interface/node/spinning_thread.h>
#include <ros_interface/request/name_registry.h>
#include <ros_interface/runs/request_runner.h>

#include "envelope/envelope_scenes.h"

namespace cable_variation_ros {
namespace {

using namespace std::chrono_literals;
using cable_variation::Cancelled;
using cable_variation::Clock;
using cable_variation::OutputDirectory;
using cable_variation::Progress;
using cable_variation::RunControl;
using cable_variation::Status;

constexpr double kAtOnce = 0.2;  // that an answer to a cancel may take [s]

/// Counts to a number, a thousand a second at most, and remembers which threads it was on.
class CountingRun : public LongRun {
 public:
  struct Request {
    int count = 0;
    std::string name = {};
    bool keeps = false;
  };
  struct Response {
    Status status;
    int counted = 0;
    std::vector<std::string> warnings;
    std::thread::id prepared_on, calculated_on, shown_on;
  };
  struct Publisher {
    bool fits = true;
    int shown = 0;
  };

  CountingRun(Request request, const RunLimits& /*limits*/, Publisher& publisher)
      : request_(std::move(request)), publisher_(publisher) {}

  void prepare(const SolverContext& /*context*/) override {
    if (request_.count < 0) throw std::invalid_argument("count: is negative");
    response_.prepared_on = std::this_thread::get_id();
  }
  const std::string& name() const override { return request_.name; }
  void calculate(RunControl& control) override {
    response_.calculated_on = std::this_thread::get_id();
    for (int& i = response_.counted; i < request_.count; ++i) {
      control.report({"counting", static_cast<double>(i) / request_.count, static_cast<std::uint64_t>(i)});
      if (!request_.keeps) control.throwIfCancelled();
      if (control.cancelled()) return;
      std::this_thread::sleep_for(1ms);
    }
    control.complete();
  }
  bool keepsWhatWasDone() const override { return request_.keeps; }
  bool show(const SolverContext& /*context*/) override {
    response_.shown_on = std::this_thread::get_id();
    ++publisher_.shown;
    return publisher_.fits;
  }
  void warn(const std::string& warning) override { response_.warnings.push_back(warning); }
  Response takeResponse() { return std::move(response_); }

 private:
  Request request_;
  Publisher& publisher_;
  Response response_;
};

class RunnerTest : public testing::Test {
 protected:
  static void SetUpTestSuite() { ros::Time::init(); }  // a context has a stamp
  ~RunnerTest() override { spinning_.stop(); }

  CountingRun::Response ask(CountingRun::Request request, const Runner::Watcher& watcher) {
    return counting_.run(request, watcher);
  }

  /// Spins, as a node's thread does, while `other` runs on a second one.
  void spinWhile(const std::function<void()>& other) {
    std::atomic<bool> ended{false};
    std::thread thread([&] {
      other();
      ended = true;
    });
    while (!ended) queue_.callAvailable(ros::WallDuration(0.01));
    thread.join();
  }

  SolverContext context_{cable_variation::test::freeRod(0.2, 0.004)};
  ros::CallbackQueue queue_;
  SpinningThread spinning_{queue_};
  NameRegistry names_;
  CountingRun::Publisher publisher_;
  Runner runner_{context_, spinning_, names_, RunLimits{1, 1e9, OutputDirectory("/dev/null/below")}};
  RequestRunner<CountingRun> counting_{runner_, publisher_, "count"};
};

bool always(const Progress& /*progress*/) { return true; }

/// Says no from `moment` on, and tells when that was.
struct Canceller {
  std::function<bool(const Progress&)> moment;
  Clock::time_point since{};
  bool cancelled = false;

  bool operator()(const Progress& progress) {
    if (!cancelled && moment(progress)) {
      cancelled = true;
      since = Clock::now();
    }
    return !cancelled;
  }
  double age() const { return cable_variation::secondsSince(since); }
};

TEST_F(RunnerTest, EachStepIsOnItsThread) {
  CountingRun::Response response;
  std::thread::id asked_on;
  std::vector<double> shares;
  spinWhile([&] {
    asked_on = std::this_thread::get_id();
    response = ask({100}, [&](const Progress& progress) {
      shares.push_back(progress.share);
      return true;
    });
  });
  EXPECT_EQ(response.status.code, Status::SUCCESS);
  EXPECT_EQ(response.counted, 100);
  EXPECT_TRUE(response.warnings.empty());
  EXPECT_EQ(response.prepared_on, std::this_thread::get_id());
  EXPECT_EQ(response.shown_on, std::this_thread::get_id());
  EXPECT_TRUE(response.calculated_on != std::this_thread::get_id() && response.calculated_on != asked_on);
  EXPECT_GT(shares.size(), 2U);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
}

TEST_F(RunnerTest, WhatAStepThrowsIsTheStatus) {
  spinWhile([&] {
    const CountingRun::Response response = ask({-1}, always);
    EXPECT_EQ(response.status.code, Status::INVALID_ARGUMENT);
    EXPECT_EQ(response.status.message, "count: is negative");
  });
}

TEST_F(RunnerTest, ACancelIsAnsweredAtOnceAndEndsTheWork) {
  for (const bool keeps : {false, true}) {
    spinWhile([&] {
      Canceller canceller{[](const Progress& progress) { return progress.done > 20; }};
      const CountingRun::Response response = ask({1000000, "", keeps}, std::ref(canceller));
      EXPECT_LT(canceller.age(), kAtOnce);
      EXPECT_EQ(response.status.code, keeps ? Status::SUCCESS : Status::CANCELLED);
      EXPECT_EQ(response.counted > 20, keeps);
      // the next one waits until the one before has noticed, which it does at its next look
      EXPECT_EQ(ask({1}, always).counted, 1);
      EXPECT_LT(canceller.age(), 2.0 * kAtOnce);
    });
  }
}

TEST_F(RunnerTest, ACancelIsHeardWhileTheNodesThreadIsBusy) {
  // as when it loads a scene: nothing of its queue is called
  Canceller canceller{[](const Progress&) { return true; }};
  EXPECT_EQ(ask({1}, std::ref(canceller)).status.code, Status::CANCELLED);
  EXPECT_LT(canceller.age(), kAtOnce);
  queue_.callAvailable();  // the step that nobody waits for is not taken any more
  EXPECT_EQ(publisher_.shown, 0);
}

TEST_F(RunnerTest, WhatIsFinishedIsAnsweredThoughTheNodesThreadIsBusyThen) {
  std::atomic<bool> prepared{false};
  CountingRun::Response response;
  Canceller canceller{[](const Progress& progress) { return progress.done >= 49; }};
  std::thread asking([&] {
    response = ask({50, "", true}, [&](const Progress& progress) {
      if (progress.done > 0) prepared = true;
      return canceller(progress);
    });
  });
  while (!prepared) queue_.callAvailable(ros::WallDuration(0.001));
  asking.join();  // with nobody spinning
  EXPECT_LT(canceller.age(), 2.0 * kAtOnce);
  EXPECT_GE(response.counted, 49);
  ASSERT_EQ(response.warnings.size(), 1U);
  EXPECT_NE(response.warnings[0].find("not shown"), std::string::npos);
}

TEST_F(RunnerTest, WhatDoesNotFitTheDesignAnyMoreIsToldNotToBeShown) {
  publisher_.fits = false;
  spinWhile([&] {
    const CountingRun::Response response = ask({1}, always);
    EXPECT_EQ(response.status.code, Status::SUCCESS);
    ASSERT_EQ(response.warnings.size(), 1U);
    EXPECT_NE(response.warnings[0].find("not shown"), std::string::npos);
  });
}

TEST_F(RunnerTest, AFolderThatCannotBeWrittenIsToldBeforeTheWork) {
  spinWhile([&] {
    const CountingRun::Response response = ask({1000000, "run_1"}, always);
    EXPECT_EQ(response.status.code, Status::IO_ERROR);
    EXPECT_NE(response.status.message.find("/dev/null/below"), std::string::npos);
    EXPECT_EQ(response.counted, 0);
    EXPECT_EQ(ask({3}, always).counted, 3);  // without a name there are no files
  });
}

TEST_F(RunnerTest, OnlyAsManyAreAtWorkAsMemoryAllows) {
  Runner small{context_, spinning_, names_, RunLimits{1, 2e9, OutputDirectory("/dev/null/below"), 5e9}};
  RequestRunner<CountingRun> counting{small, publisher_, "count"};
  std::atomic<int> at_work{0};
  std::atomic<bool> end{false};
  std::vector<CountingRun::Response> responses(2);
  std::vector<std::thread> threads;
  spinWhile([&] {
    for (CountingRun::Response& response : responses) {
      threads.emplace_back([&] {
        bool told = false;
        response = counting.run({1000000}, [&](const Progress& progress) {
          if (progress.done > 0 && !told) {
            told = true;
            ++at_work;
          }
          return !end;
        });
      });
    }
    while (at_work < 2) std::this_thread::sleep_for(1ms);
    const CountingRun::Response refused = counting.run({1}, always);
    EXPECT_EQ(refused.status.code, Status::OUT_OF_MEMORY);
    for (const char* part : {"busy: runs at work: 2", "2 GB (~memory_limit)", "5 GB (~memory_total)"}) {
      EXPECT_NE(refused.status.message.find(part), std::string::npos) << refused.status.message;
    }
    EXPECT_EQ(refused.counted, 0);
    end = true;
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(counting.run({1}, always).counted, 1);
  });
}

TEST_F(RunnerTest, WhenTheNodeEndsSoDoesARun) {
  spinWhile([&] {
    const CountingRun::Response response = ask({1000000}, [&](const Progress& progress) {
      if (progress.done > 20) spinning_.stop();
      return true;
    });
    EXPECT_EQ(response.status.code, Status::CANCELLED);
    EXPECT_EQ(ask({1}, always).status.code, Status::CANCELLED);
  });
}

}  // namespace
}  // namespace cable_variation_ros
