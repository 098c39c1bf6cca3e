#pragma once

#include <cstddef>
#include <functional>

namespace cable_variation {

/// Calls `work` so that what it does in parallel is done by at most so many threads, the caller among them;
/// never by more than there are cores, and with 0 by as many. What `work` throws comes through.
void withThreads(std::size_t threads, const std::function<void()>& work);

}  // namespace cable_variation
