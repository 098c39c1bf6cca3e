#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include <cable_variation/math/so3.h>

namespace cable_variation {

/// The bytes of an input, one after another made numbers; beyond the end they are 0.
class FuzzBytes {
 public:
  FuzzBytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  bool empty() const { return at_ >= size_; }
  unsigned byte() { return empty() ? 0U : data_[at_++]; }
  unsigned below(unsigned count) { return byte() % count; }
  bool chance(unsigned of) { return byte() % of == of - 1; }

  /// Evenly spread over [low, high]; one in 128 is a number that nobody means.
  double number(double low, double high) {
    constexpr double kMost = 65535.0;
    const unsigned first = byte(), second = byte();
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    constexpr double kStrange[] = {
        std::numeric_limits<double>::quiet_NaN(), kInfinity, -kInfinity, 1e300, -1e300, 5e-324, 0.0, -1.0};
    if (first == 255 && second >= 128) return kStrange[second % 8];
    return low + (high - low) * (256 * first + second) / kMost;
  }

  Eigen::Vector3d vector(double most) {
    const double x = number(-most, most), y = number(-most, most), z = number(-most, most);
    return {x, y, z};
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
  std::size_t at_ = 0;
};

}  // namespace cable_variation
