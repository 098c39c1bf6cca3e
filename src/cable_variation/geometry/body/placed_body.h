#pragma once  // internal to geometry/

#include <mutex>
#include <optional>

#include <cable_variation/geometry/body/convex_hull.h>
#include <cable_variation/geometry/mesh/box.h>
#include <cable_variation/geometry/mesh/surface_triangle.h>
#include <cable_variation/geometry/mesh/triangle_tree.h>
#include <cable_variation/math/pose.h>

namespace cable_variation {

/// A rounded hull in another frame, made ready for depths below its core's facets. May be shared by threads.
class PlacedBody {
 public:
  /// @param pose of the frame that the body is given in
  PlacedBody(const RoundedHull& body, const Pose& pose);

  double radius() const { return radius_; }
  const std::vector<Eigen::Vector3d>& vertices() const { return core_.vertices; }  ///< of the core
  const Eigen::Vector3d& centre() const { return centre_; }                        ///< within the core
  const Box& box() const { return box_; }                                          ///< of the core
  Eigen::Vector3d normal(std::size_t facet) const {
    return planes_.col(static_cast<Eigen::Index>(facet)).head<3>();
  }

  struct Height {
    double height = 0.0;  ///< above the facet [m]; negative: below all of them
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    std::size_t facet = 0;  ///< of the core, as its surface has them
  };
  /// Of a point above the facet that it is highest above, see ConvexHull::height().
  Height height(const Eigen::Vector3d& point) const;
  /// No point of the box has a smaller height.
  double lowestPossible(const Box& box) const;
  /// No point of the triangle has a smaller height.
  double lowestPossible(const SurfaceTriangle& triangle) const;
  /// The point of the triangle whose height is smallest, to 1e-12 of the sizes.
  Height lowest(const SurfaceTriangle& triangle) const;
  /// The point of another body's core whose height is smallest, likewise.
  Height lowest(const PlacedBody& other) const;

  double reach() const { return reach_; }  ///< of the core from its centre [m]
  /// Facets of the core below boxes. Not cheap: made when first asked for.
  const TriangleTree& facets() const;

 private:
  TriangleMesh core_;
  ConvexHull::Planes planes_;
  double radius_;
  Eigen::Vector3d centre_;
  Box box_;
  double reach_ = 0.0;
  mutable std::once_flag made_;
  mutable std::optional<TriangleTree> facets_;
};

/// A point within the core: the mean of its vertices.
Eigen::Vector3d centreOf(const ConvexHull& core);

}  // namespace cable_variation
