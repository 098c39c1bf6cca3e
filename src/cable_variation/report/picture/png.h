#pragma once  // internal to report/

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace cable_variation {

/// A picture, row by row from the top, four bytes a pixel: red, green, blue, opacity (not multiplied in).
struct Pixels {
  std::size_t width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

/// As a PNG file's bytes. Throws std::invalid_argument unless there are width × height × 4 of them, one pixel
/// at least.
std::string png(const Pixels& pixels);

}  // namespace cable_variation
