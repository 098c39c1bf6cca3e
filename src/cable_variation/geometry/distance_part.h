#pragma once

#include <optional>
#include <vector>

#include <cable_variation/geometry/distance.h>
#include <cable_variation/geometry/solids.h>
#include <cable_variation/geometry/triangle_tree.h>

namespace cable_variation {

struct DistancePart::Impl {
  TriangleTree tree;
  Solids solids;
  std::vector<std::uint32_t> place_in_tree;  ///< of each triangle of the mesh

  explicit Impl(const TriangleMesh& mesh);

  /// A closed shell's solid, or Solids::kOpen, that a triangle of the tree bounds.
  std::uint32_t solidOf(std::uint32_t triangle) const {
    const std::uint32_t shell = solids.shell[tree.number[triangle]];
    return shell == Solids::kOpen ? Solids::kOpen : solids.shells[shell].solid;
  }

  /// The solids that x [m, part's frame] lies inside.
  std::vector<std::uint32_t> solidsAround(const Eigen::Vector3d& x) const;

  struct Nearest {
    std::uint32_t triangle = 0;  ///< of the tree
    NearestPoint at;
  };
  /// The nearest point to x on the surface of a solid, closer than `bound` [m].
  std::optional<Nearest> nearestOn(std::uint32_t solid, const Eigen::Vector3d& x, double bound) const;

  /// On all of the surface.
  Nearest nearest(const Eigen::Vector3d& x) const;

  /// Whether the surface about at.point, which is nearest to x on its own triangle, comes no nearer to x
  /// there.
  bool isLocallyNearest(const Eigen::Vector3d& x, const NearestPoint& at) const;

  /// Calls visit(triangle of the tree) for those whose boxes are within `distance` [m] of x.
  template <typename Visit>
  void forEachNear(const Eigen::Vector3d& x, double distance, Visit&& visit) const {
    std::vector<std::uint32_t> open = {0};
    while (!open.empty()) {
      const TriangleTree::Node& node = tree.nodes[open.back()];
      open.pop_back();
      if (squaredGap(node.box, x) > distance * distance) continue;
      if (node.count == 0) {
        open.push_back(node.first);
        open.push_back(node.first + 1);
      }
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) visit(i);
    }
  }
};

}  // namespace cable_variation
