#include <cable_variation/util/thread_limit.h>

#include <algorithm>

#include <tbb/task_arena.h>

namespace cable_variation {

void withThreads(std::size_t threads, const std::function<void()>& work) {
  const auto cores = static_cast<std::size_t>(tbb::task_arena().max_concurrency());
  tbb::task_arena arena(threads == 0 ? tbb::task_arena::automatic
                                     : static_cast<int>(std::min(threads, cores)));
  arena.execute(work);
}

}  // namespace cable_variation
