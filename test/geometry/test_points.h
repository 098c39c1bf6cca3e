#pragma once

#include <random>
#include <vector>

#include <Eigen/Core>

namespace cable_variation {

using Points = std::vector<Eigen::Vector3d>;

/// In the cube from -1 to 1.
inline Eigen::Vector3d randomPoint(std::mt19937_64& random) {
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  return {coordinate(random), coordinate(random), coordinate(random)};
}

}  // namespace cable_variation
