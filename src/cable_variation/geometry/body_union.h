#pragma once

#include <vector>

#include <cable_variation/geometry/box.h>
#include <cable_variation/geometry/convex_hull.h>

namespace cable_variation {

/// The smallest of the distances from a point to some of several bodies, each with its own radius.
class BodyUnion {
 public:
  /// A body, and its value in the middle of a region.
  struct Near {
    std::size_t body = 0;
    double value = 0.0;  ///< [m]; or more than some bound
  };

  BodyUnion(const std::vector<const RoundedHull*>& bodies, std::vector<double> radii)
      : bodies_(bodies), radii_(std::move(radii)) {}

  std::vector<Near> all() const;

  /// Of those given, the bodies that can be the closest one of some point within `reach` [m] of `middle`, the
  /// closest to the middle first.
  std::vector<Near> closestAbout(const Eigen::Vector3d& middle, double reach,
                                 const std::vector<Near>& given) const;

  /// Signed distance of the union [m]: exact where one of `near` is the closest body; inside of bodies that
  /// overlap, minus the largest of their depths.
  /// @param from_middle distance of the point from the middle that `near` belongs to [m]
  double value(const Eigen::Vector3d& point, double from_middle, const std::vector<Near>& near) const;

 private:
  /// The body's signed distance [m] if below `bound`; else something that is not.
  double bodyValue(std::size_t body, const Eigen::Vector3d& point, double bound) const;

  const std::vector<const RoundedHull*>& bodies_;
  std::vector<double> radii_;
};

}  // namespace cable_variation
