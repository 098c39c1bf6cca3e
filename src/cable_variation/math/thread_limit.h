#pragma once

#include <cstddef>
#include <functional>

namespace cable_variation {

/// Calls `work` so that what it does in parallel is done by at most so many threads, the caller among them;
/// 0, and no more than: as many as there are cores. What `work` throws comes through.
void withThreads(std::size_t threads, const std::function<void()>& work);

}  // namespace cable_variation
