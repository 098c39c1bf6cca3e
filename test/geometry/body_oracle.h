#pragma once

#include <utility>

#include <geometry/distance_oracle.h>

#include <cable_variation/geometry/body/convex_hull.h>

/// Brute force for convex bodies: every pair of triangles, in extended precision and by other formulae than
/// the library's.
namespace cable_variation::test {

using Corners = std::array<RealVector, 3>;

/// The smallest of a convex f over [0, 1].
template <typename Function>
Real smallestConvex(const Function& f) {
  Real low = 0, high = 1;
  // 2/3 to the power of 60: 3e-11 of the way
  for (int step = 0; step < 60; ++step) {
    const Real p = low + (high - low) / 3, q = high - (high - low) / 3;
    (f(p) < f(q) ? high : low) = f(p) < f(q) ? q : p;
  }
  return std::min({f(0), f(1), f((low + high) / 2)});
}

/// Edges that go through the other, corners over faces, edges over edges.
inline Real pairDistance(const Corners& first, const Corners& second) {
  const auto pierces = [](const RealVector& a, const RealVector& b, const Corners& face) {
    const RealVector u = face[1] - face[0], v = face[2] - face[0], n = u.cross(v);
    const Real from = n.dot(a - face[0]), to = n.dot(b - face[0]);
    if ((from > 0) == (to > 0)) return false;
    return triangleDistance(face, a + from / (from - to) * (b - a)) < 1e-14L;
  };
  Real smallest = std::numeric_limits<Real>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const RealVector &a = first[i], &b = first[(i + 1) % 3];
    if (pierces(a, b, second) || pierces(second[i], second[(i + 1) % 3], first)) return 0;
    smallest = std::min({smallest, triangleDistance(second, a), triangleDistance(first, second[i])});
    for (std::size_t k = 0; k < 3; ++k) {
      smallest = std::min(smallest, smallestConvex([&](Real t) {
                            return segmentDistance(second[k], second[(k + 1) % 3], a + t * (b - a));
                          }));
    }
  }
  return smallest;
}

inline Corners cornersOf(const TriangleMesh& mesh, std::size_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return {mesh.vertices[a].cast<Real>(), mesh.vertices[b].cast<Real>(), mesh.vertices[c].cast<Real>()};
}

/// No two of their points are closer: spheres about the first corners.
inline Real leastPossible(const Corners& first, const Corners& second) {
  const auto reach = [](const Corners& t) { return std::max((t[1] - t[0]).norm(), (t[2] - t[0]).norm()); };
  return (first[0] - second[0]).norm() - reach(first) - reach(second);
}

/// Planes of the facets, from their corners.
inline std::vector<std::pair<RealVector, Real>> facetPlanes(const ConvexHull& hull) {
  std::vector<std::pair<RealVector, Real>> planes;
  for (std::size_t i = 0; i < hull.surface().triangles.size(); ++i) {
    const Corners face = cornersOf(hull.surface(), i);
    const RealVector normal = (face[1] - face[0]).cross(face[2] - face[0]).normalized();
    planes.emplace_back(normal, normal.dot(face[0]));
  }
  return planes;
}

/// Above the highest facet.
inline Real heightAbove(const std::vector<std::pair<RealVector, Real>>& planes, const RealVector& x) {
  Real highest = -std::numeric_limits<Real>::infinity();
  for (const auto& [normal, offset] : planes) highest = std::max(highest, normal.dot(x) - offset);
  return highest;
}

/// Of a triangle's points, the smallest: the height is convex.
inline Real lowestHeight(const ConvexHull& hull, const Corners& triangle) {
  const auto planes = facetPlanes(hull);
  return smallestConvex([&](Real u) {
    const RealVector from = triangle[0] + u * (triangle[1] - triangle[0]);
    const RealVector to = triangle[0] + u * (triangle[2] - triangle[0]);
    return smallestConvex([&](Real v) { return heightAbove(planes, from + v * (to - from)); });
  });
}

/// From the triangle to the rounded body; negative: minus the depth of its deepest point.
inline Real bodyDistance(const RoundedHull& body, const Corners& triangle) {
  Real smallest = std::numeric_limits<Real>::infinity();
  for (std::size_t i = 0; i < body.core.surface().triangles.size(); ++i) {
    const Corners facet = cornersOf(body.core.surface(), i);
    if (leastPossible(facet, triangle) < smallest)
      smallest = std::min(smallest, pairDistance(facet, triangle));
  }
  if (smallest == 0 || heightAbove(facetPlanes(body.core), triangle[0]) < 0)
    smallest = lowestHeight(body.core, triangle);
  return smallest - body.radius;
}

inline RoundedHull randomBody(Chance& chance, std::size_t points, double size, double radius,
                              const Eigen::Vector3d& middle = Eigen::Vector3d::Zero()) {
  std::vector<Eigen::Vector3d> cloud;
  const Eigen::Vector3d extent(size, size * chance.size(0.05, 1.0), size * chance.size(0.05, 1.0));
  const Eigen::Quaterniond turn = chance.orientation();
  for (std::size_t i = 0; i < points; ++i) {
    cloud.push_back(middle + turn * extent.cwiseProduct(chance.inBox(0.5)));
  }
  return {ConvexHull(cloud), radius};
}

inline RoundedHull boxBody(const Eigen::Vector3d& size, double radius,
                           const Eigen::Vector3d& middle = Eigen::Vector3d::Zero()) {
  std::vector<Eigen::Vector3d> corners;
  for (int i = 0; i < 8; ++i) {
    corners.push_back(
        middle + 0.5 * size.cwiseProduct(Eigen::Vector3d(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
  }
  return {ConvexHull(corners), radius};
}

}  // namespace cable_variation::test
