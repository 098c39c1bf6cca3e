#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include <cable_variation/geometry/mesh/surface_triangle.h>
#include <cable_variation/geometry/mesh/triangle_mesh.h>

namespace cable_variation {

/// The convex hull of points. Immutable; may be shared by threads. Copies share what they are made of.
class ConvexHull {
 public:
  /// Points that lie in a plane, on a line or on each other (to 1e-8 of their extent) get a body by added
  /// vertices, off their middle by 1e-6 m or 1e-7 of their extent, whichever is more. Throws
  /// std::invalid_argument: no points, or one that is not finite.
  explicit ConvexHull(const std::vector<Eigen::Vector3d>& points);

  /// Outward facets over the hull's vertices only [m]; closed. Facets of more corners are cut into triangles.
  const TriangleMesh& surface() const { return data_->surface; }
  /// Per vertex: the point it comes from, by index; kAdded: none, it gives a flat hull a body.
  const std::vector<std::size_t>& sources() const { return data_->sources; }
  static constexpr std::size_t kAdded = static_cast<std::size_t>(-1);
  /// Per triangle: unit outward normal and offset, so that normal · x <= offset inside.
  /// Row by row in memory, so that heights are taken several at a time.
  using Planes = Eigen::Matrix<double, 4, Eigen::Dynamic, Eigen::RowMajor>;
  const Planes& planes() const { return data_->planes; }

  /// Per triangle: those across the edges from each corner to the next.
  const std::vector<std::array<std::uint32_t, 3>>& neighbours() const { return data_->neighbours; }

  /// The largest of normal · point - offset [m]: inside and above a facet's inner part the signed distance
  /// itself, elsewhere less than the distance.
  double height(const Eigen::Vector3d& point) const;

  /// The signed distance [m], and the closest point of the surface.
  struct Closest {
    double distance = 0.0;  ///< negative inside
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    std::size_t triangle = 0;
  };
  Closest closest(const Eigen::Vector3d& point) const;

  double volume() const;  ///< [m³]

 private:
  NearestPoint nearestOn(std::size_t triangle, const Eigen::Vector3d& point) const;
  /// Walks over the surface, always nearer to a point outside, from the triangle `at`.
  NearestPoint descend(const Eigen::Vector3d& point, std::size_t& at) const;
  NearestPoint nearestOfAll(const Eigen::Vector3d& point, std::size_t& at) const;

  struct Data {
    TriangleMesh surface;
    std::vector<std::size_t> sources;
    Planes planes;
    std::vector<std::array<std::uint32_t, 3>> neighbours;
  };
  std::shared_ptr<const Data> data_;
};

/// A convex body: all that is within `radius` of the hull.
struct RoundedHull {
  ConvexHull core;
  double radius = 0.0;  ///< [m]
};

}  // namespace cable_variation
