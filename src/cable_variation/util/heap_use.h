#pragma once

#include <cstddef>
#include <optional>

namespace cable_variation {

/// Memory of this process as its allocator counts it [B].
struct HeapUse {
  std::size_t live =
      0;  ///< asked for and not given back, what threads keep at hand for their next request included
  std::size_t held = 0;  ///< got from the system: that, and what is free
};

/// Of all threads' arenas together, by malloc_info(); none: the C library does not tell.
std::optional<HeapUse> heapUse();

}  // namespace cable_variation
