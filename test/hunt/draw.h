#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include <cable_variation/util/counter_random.h>
#include <hunt/rotation.h>

namespace cable_variation::hunt {

/// Random numbers of one harness: the same for the same seed, family and number, whatever else is drawn.
class Draw {
 public:
  Draw(std::uint64_t seed, std::uint32_t family, std::uint64_t number)
      : row_(CounterRandom(seed, family), number) {}

  double between(double low, double high) { return low + (high - low) * row_.uniform(); }
  /// Evenly in the logarithm.
  double logBetween(double low, double high) { return low * std::pow(high / low, row_.uniform()); }
  bool chance(double probability) { return row_.uniform() < probability; }
  /// From 0 to count - 1.
  std::size_t index(std::size_t count) {
    return static_cast<std::size_t>(row_.uniform() * static_cast<double>(count));
  }
  /// From low to high, both included.
  std::size_t count(std::size_t low, std::size_t high) { return low + index(high - low + 1); }
  template <class T>
  T oneOf(const std::vector<T>& list) {
    return list[index(list.size())];
  }
  /// Evenly over the sphere.
  Eigen::Vector3d direction() {
    const double z = between(-1.0, 1.0), azimuth = between(-M_PI, M_PI), r = std::sqrt(1.0 - z * z);
    return {r * std::cos(azimuth), r * std::sin(azimuth), z};
  }
  /// A rotation about a random axis by up to `angle` [rad].
  Eigen::Quaterniond turn(double angle) {
    const Eigen::Vector3d axis = direction();
    return rotationBy(between(0.0, angle) * axis);
  }

 private:
  RandomRow row_;
};

}  // namespace cable_variation::hunt
