#pragma once  // internal to geometry/

#include <optional>
#include <vector>

#include <cable_variation/geometry/mesh/solids.h>
#include <cable_variation/geometry/mesh/triangle_tree.h>
#include <cable_variation/geometry/tube_distance/distance.h>

namespace cable_variation {

struct DistancePart::Impl {
  TriangleTree tree;  ///< of the mesh, all its triangles
  Solids solids;
  std::vector<std::uint32_t> place_in_tree;  ///< of each triangle of the mesh
  std::optional<TriangleTree> welded;        ///< of what bounds solids, unless that is the mesh itself
  std::optional<TriangleTree> caps;          ///< over the rims of what is open

  explicit Impl(const TriangleMesh& mesh);

  /// Of what bounds solids. Its numbers are of Solids::corners.
  const TriangleTree& boundary() const { return welded ? *welded : tree; }
  /// The solid that a triangle of the boundary bounds, or Solids::kNone.
  std::uint32_t solidOf(std::uint32_t triangle) const {
    return solidOfShell(solids.shell[boundary().number[triangle]]);
  }
  /// The solid that a triangle of the mesh's tree bounds, likewise.
  std::uint32_t solidOfTriangle(std::uint32_t triangle) const {
    return solidOfShell(solids.shell_of_triangle[tree.number[triangle]]);
  }
  /// The mesh's triangle that a triangle of the boundary is, is a piece of or is a cap beside.
  std::uint32_t sourceOf(std::uint32_t triangle) const { return solids.source[boundary().number[triangle]]; }

  bool isOpen() const { return solids.open.has_value(); }
  /// What the open shell bounds with its rims closed; Solids::kNone without one.
  std::uint32_t openSolid() const { return isOpen() ? solids.shells[*solids.open].solid : Solids::kNone; }

  /// The solids that x [m, part's frame] lies inside, rims closed.
  std::vector<std::uint32_t> solidsAround(const Eigen::Vector3d& x) const { return around(x).solids; }

  /// What the generalised winding number of the open shell says of x.
  struct Winding {
    double number = 0.0;
    bool clear = true;  ///< within kClearWinding of a whole number, as the same with the rims closed has it
  };
  Winding winding(const Eigen::Vector3d& x) const;

  struct Nearest {
    std::uint32_t triangle = 0;  ///< of the tree
    NearestPoint at;
  };
  /// The nearest point to x on the boundary of a solid, closer than `bound` [m].
  std::optional<Nearest> nearestOn(std::uint32_t solid, const Eigen::Vector3d& x, double bound) const;

  /// On all of the mesh.
  Nearest nearest(const Eigen::Vector3d& x) const;

 private:
  struct Around {
    std::vector<std::uint32_t> solids;
    int open_turns = 0;  // whole winding number of the open shell with its rims closed
  };
  Around around(const Eigen::Vector3d& x) const;
  std::uint32_t solidOfShell(std::uint32_t shell) const {
    return shell == Solids::kNone ? Solids::kNone : solids.shells[shell].solid;
  }
};

/// Calls visit(triangle of the tree) for those whose boxes are within `distance` [m] of x.
template <typename Visit>
void forEachNear(const TriangleTree& tree, const Eigen::Vector3d& x, double distance, Visit&& visit) {
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

/// Whether the surface about at.point, which is nearest to x on its own triangle, comes no nearer to x there.
bool isLocallyNearest(const TriangleTree& tree, const Eigen::Vector3d& x, const NearestPoint& at);

/// The distance of the nearest of the tree's triangles to x [m], or `bound` if none is closer.
double distanceTo(const TriangleTree& tree, const Eigen::Vector3d& x, double bound);

}  // namespace cable_variation
