#pragma once  // internal to geometry/

#include <array>
#include <cstddef>
#include <cstdint>

#include <Eigen/Core>

namespace cable_variation {

/// A half line that counts how often it crosses a closed surface. Triangles that share an edge agree exactly
/// on which side of it the line passes, so that none is missed or counted twice; a line through a corner or
/// along an edge says so, and another direction is tried. (The test of Woop, Benthin and Wald, Watertight
/// ray/triangle intersection, 2013: corners are sheared so that the line becomes an axis.)
class CrossingRay {
 public:
  enum class Answer { no, leaves, enters, unclear };  ///< leaves: through a facet from behind
  static constexpr std::size_t kDirections = 8;
  static constexpr int kUnclear = -1;

  /// @param direction number of one of kDirections fixed directions
  CrossingRay(const Eigen::Vector3d& origin, std::size_t direction);

  /// @param numbers of the corners: edges are told apart by them
  Answer crosses(const std::array<Eigen::Vector3d, 3>& corners,
                 const std::array<std::uint32_t, 3>& numbers) const;

  const Eigen::Vector3d& origin() const { return origin_; }
  const Eigen::Vector3d& direction() const { return direction_; }

 private:
  Eigen::Vector3d origin_, direction_;
};

/// Whether the number of crossings that count(ray) gives (kUnclear: none) is odd. A point on the surface
/// itself, of which no direction tells, counts as outside.
template <typename Count>
bool oddCrossings(const Eigen::Vector3d& origin, Count&& count) {
  for (std::size_t i = 0; i < CrossingRay::kDirections; ++i) {
    const int crossings = count(CrossingRay(origin, i));
    if (crossings != CrossingRay::kUnclear) return crossings % 2 != 0;
  }
  return false;
}

}  // namespace cable_variation
