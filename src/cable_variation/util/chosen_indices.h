#pragma once

#include <cstddef>
#include <vector>

namespace cable_variation {

/// 0 to count - 1.
std::vector<std::size_t> allIndices(std::size_t count);

/// The chosen ones, or all if none is. Throws std::invalid_argument, which says what `kind` of thing it is
/// about, for an index that is not below `count`.
std::vector<std::size_t> allOrChosen(const std::vector<std::size_t>& chosen, std::size_t count,
                                     const char* kind);

}  // namespace cable_variation
