#pragma once

#include <array>
#include <cstdint>

namespace cable_variation {

/// Moments of pairs (x, y) up to the fourth order, about their means: streaming, in constant memory, and
/// mergeable. The same order of calls gives the same numbers bit for bit.
class JointMoments {
 public:
  void add(double x, double y);
  void merge(const JointMoments& other);

  std::uint64_t count() const { return count_; }
  double meanX() const { return mean_x_; }
  double meanY() const { return mean_y_; }
  /// Mean of (x - meanX)^i (y - meanY)^j, i + j <= 4; not a number without samples.
  double central(int i, int j) const;

 private:
  static constexpr int kOrder = 4;
  using Sums = std::array<std::array<double, kOrder + 1>, kOrder + 1>;

  void moveTo(double mean_x, double mean_y);

  std::uint64_t count_ = 0;
  double mean_x_ = 0.0, mean_y_ = 0.0;
  Sums sums_ = {};  // of (x - mean_x_)^i (y - mean_y_)^j
};

}  // namespace cable_variation
