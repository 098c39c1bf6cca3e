// One run at a time writes the files of a name.
#include <ros_interface/request/name_registry.h>

#include <atomic>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace cable_variation_ros {
namespace {

TEST(NameRegistry, ASecondRunOfANameIsRefusedWhoeverAsks) {
  NameRegistry registry;
  std::optional<NameRegistry::Hold> first(std::in_place, registry, "name", "run_1", "generate_envelope");
  const NameRegistry::Hold other(registry, "name", "run_2", "simulate_variation");
  try {
    const NameRegistry::Hold second(registry, "report", "run_1", "analyze_stability");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()),
              "report: 'run_1' is what a run of ~generate_envelope is writing now; expected another name, or "
              "wait until that has ended");
  }
  first.reset();
  EXPECT_NO_THROW(NameRegistry::Hold(registry, "report", "run_1", "analyze_stability"));
}

TEST(NameRegistry, WithoutANameNothingIsHeld) {
  NameRegistry registry;
  const NameRegistry::Hold first(registry, "name", "", "generate_envelope");
  EXPECT_NO_THROW(NameRegistry::Hold(registry, "name", "", "generate_envelope"));
}

TEST(NameRegistry, OfManyThreadsOneHoldsAName) {
  NameRegistry registry;
  std::atomic<int> inside{0}, most{0}, held{0};
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      for (int round = 0; round < 2000; ++round) {
        try {
          const NameRegistry::Hold hold(registry, "name", "run_1", "simulate_variation");
          const int now = ++inside;
          if (now > most) most = now;
          ++held;
          std::this_thread::yield();
          --inside;
        } catch (const std::invalid_argument&) {
          std::this_thread::yield();
        }
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(most, 1);
  EXPECT_GT(held, 100);
}

}  // namespace
}  // namespace cable_variation_ros
