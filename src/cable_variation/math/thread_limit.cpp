#include <cable_variation/math/thread_limit.h>

#include <algorithm>
#include <limits>

#include <tbb/task_arena.h>

namespace cable_variation {

void withThreads(std::size_t threads, const std::function<void()>& work) {
  constexpr auto kMost = static_cast<std::size_t>(std::numeric_limits<int>::max());
  tbb::task_arena arena(threads == 0 ? tbb::task_arena::automatic
                                     : static_cast<int>(std::min(threads, kMost)));
  arena.execute(work);
}

}  // namespace cable_variation
