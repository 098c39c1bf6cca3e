#pragma once

#include <cstdint>
#include <string>

namespace cable_variation {

/// "1 sample", "0 samples", "3 equilibria": a number with what it counts.
/// @param plural empty: `what` with an s
inline std::string countText(std::uint64_t count, const std::string& what, const std::string& plural = "") {
  if (count == 1) return "1 " + what;
  return std::to_string(count) + " " + (plural.empty() ? what + "s" : plural);
}

}  // namespace cable_variation
