#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <cable_variation/geometry/body/convex_hull.h>
#include <cable_variation/geometry/mesh/box.h>

namespace cable_variation {

/// The voxels of a grid that belong to a union of bodies: those whose middle does. Voxels of bodies that
/// reach beyond the grid are left out there. One thread at a time; sets of several are united.
class VoxelSet {
 public:
  static constexpr std::uint64_t kMost = std::uint64_t{1} << 32;  ///< voxels of a grid, half a GiB

  /// @param box [m]
  /// @param edge of a voxel [m]
  /// Throws std::invalid_argument: an empty box, no edge, more than kMost voxels.
  VoxelSet(const Box& box, double edge);

  /// All within `radius` of the segment [m].
  void addCapsule(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius);
  /// Capsules from point to point.
  void addTube(const std::vector<Eigen::Vector3d>& centreline, double radius);
  void addBody(const RoundedHull& body);

  /// Throws std::invalid_argument unless on the same grid.
  void unite(const VoxelSet& other);

  std::uint64_t count() const;
  double volume() const;  ///< [m³]

  bool contains(std::size_t x, std::size_t y, std::size_t z) const;
  const std::array<std::size_t, 3>& size() const { return size_; }
  Eigen::Vector3d middle(std::size_t x, std::size_t y, std::size_t z) const;

 private:
  struct Range {
    std::int64_t first = 0, last = -1;  // inclusive
  };
  /// Voxels along an axis whose middles lie between two coordinates, within the grid.
  Range between(int axis, double low, double high) const;
  template <class Line>
  void addLines(const Box& box, const Line& line);

  Eigen::Vector3d origin_;
  double edge_;
  std::array<std::size_t, 3> size_;
  std::size_t words_;  ///< per line along x
  std::vector<std::uint64_t> bits_;
};

}  // namespace cable_variation
