// What the allocator says of the heap grows by what is asked for, in any thread, and falls when it is given
// back.
#include <cable_variation/util/heap_use.h>

#include <algorithm>
#include <memory>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace cable_variation {
namespace {

double growth(std::size_t piece, std::size_t count, bool in_thread) {
  const auto before = heapUse();
  std::vector<std::unique_ptr<char[]>> pieces;
  const auto take = [&] {
    for (std::size_t i = 0; i < count; ++i) pieces.push_back(std::make_unique<char[]>(piece));
  };
  if (in_thread) {
    std::thread(take).join();
  } else {
    take();
  }
  const auto after = heapUse();
  EXPECT_GE(after->held, after->live);
  pieces.clear();
  const double back = static_cast<double>(heapUse()->live) - static_cast<double>(before->live);
  EXPECT_LT(std::abs(back), 2e5) << "is not given back";
  return static_cast<double>(after->live) - static_cast<double>(before->live);
}

TEST(HeapUse, CountsWhatIsAskedForInAnyThread) {
  if (!heapUse()) GTEST_SKIP() << "the C library, or a sanitizer in its place, does not tell";
  for (const bool in_thread : {false, true}) {
    EXPECT_NEAR(growth(1000, 5000, in_thread), 5e6, 1e6) << in_thread;     // of the arenas
    EXPECT_NEAR(growth(10'000'000, 3, in_thread), 3e7, 1e6) << in_thread;  // pages of their own
  }
}

}  // namespace
}  // namespace cable_variation
