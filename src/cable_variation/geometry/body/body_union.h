#pragma once  // internal to geometry/

#include <vector>

#include <cable_variation/geometry/body/convex_hull.h>
#include <cable_variation/geometry/mesh/box.h>

namespace cable_variation {

/// The smallest of the signed distances from a point to some of several bodies, each with its own radius.
/// Distances to convex bodies are convex: tangents at one place bound them from below everywhere.
class BodyUnion {
 public:
  /// A body as seen from the middle of a cube.
  struct Near {
    std::size_t body = 0;
    double value = 0.0;  ///< signed distance [m]
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();

    double lowerBound(const Eigen::Vector3d& from_middle) const { return value + gradient.dot(from_middle); }
  };

  BodyUnion(const std::vector<const RoundedHull*>& bodies, std::vector<double> radii)
      : bodies_(bodies), radii_(std::move(radii)) {}

  std::vector<Near> all() const;

  /// Of those given, the bodies that can be the closest one of some point of a cube, the closest to its
  /// middle first. At least one.
  std::vector<Near> closestIn(const Eigen::Vector3d& middle, double half_edge,
                              const std::vector<Near>& given) const;

  /// The union's signed distance [m], to the last digit the same for all `near` that have the closest body;
  /// inside of bodies that overlap, minus the largest of their depths.
  double value(const Eigen::Vector3d& point, const Eigen::Vector3d& middle,
               const std::vector<Near>& near) const;

 private:
  /// The body's signed distance [m] if below `bound`; else something that is not.
  double bodyValue(std::size_t body, const Eigen::Vector3d& point, double bound) const;
  Near seenFrom(const Eigen::Vector3d& middle, std::size_t body) const;

  const std::vector<const RoundedHull*>& bodies_;
  std::vector<double> radii_;
};

}  // namespace cable_variation
