#pragma once

#include <chrono>

namespace cable_variation {

using Clock = std::chrono::steady_clock;

/// From `start` until now [s].
inline double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace cable_variation
