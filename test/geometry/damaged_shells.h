#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include <cable_variation/geometry/body/primitives.h>
#include <cable_variation/geometry/mesh/triangle_mesh.h>
#include <cable_variation/geometry/tube_distance/tube.h>
#include <geometry/distance_oracle.h>

/// Closed shells, and what exporters do to them: damage that leaves the solid what it was.
namespace cable_variation::test {

inline double diagonal(const TriangleMesh& mesh) {
  Eigen::Vector3d low = mesh.vertices.front(), high = low;
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    low = low.cwiseMin(vertex);
    high = high.cwiseMax(vertex);
  }
  return (high - low).norm();
}

/// Every facet divided into four.
inline TriangleMesh refined(const TriangleMesh& mesh) {
  TriangleMesh fine;
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(fine.vertices.size());
    const Eigen::Vector3d &p = mesh.vertices[a], &q = mesh.vertices[b], &r = mesh.vertices[c];
    for (const Eigen::Vector3d& at : {p, q, r, Eigen::Vector3d(0.5 * (p + q)), Eigen::Vector3d(0.5 * (q + r)),
                                      Eigen::Vector3d(0.5 * (r + p))}) {
      fine.vertices.push_back(at);
    }
    for (const auto& [i, j, k] : {std::array{0u, 3u, 5u}, {3u, 1u, 4u}, {5u, 4u, 2u}, {3u, 4u, 5u}}) {
      fine.triangles.push_back({first + i, first + j, first + k});
    }
  }
  return fine;
}

/// A shell that faces outwards, of any size, turned and moved.
inline TriangleMesh randomShell(Chance& chance) {
  TriangleMesh mesh;
  switch (chance.below(4)) {
    case 0:
      mesh = boxMesh({chance.between(0.3, 1.0), chance.between(0.3, 1.0), chance.between(0.3, 1.0)});
      break;
    case 1:
      mesh = cylinderMesh(chance.between(0.2, 0.6), chance.between(0.3, 1.0));
      break;
    case 2:
      mesh = sphereMesh(chance.between(0.3, 0.6));
      break;
    default: {
      std::vector<Pose> path(24);
      for (std::size_t i = 0; i < path.size(); ++i) {
        path[i].orientation =
            Eigen::AngleAxisd(2.0 * M_PI * static_cast<double>(i) / 24.0, Eigen::Vector3d::UnitZ());
        path[i].position = path[i].orientation * Eigen::Vector3d(0.0, -0.5, 0.0);
      }
      mesh = tubeMesh(path, 0.25, 10, true);
    }
  }
  if (mesh.triangles.size() < 100 && chance.oneOf(2)) mesh = refined(mesh);
  const double size = chance.size(0.005, 2.0);
  const Pose pose{chance.inBox(chance.oneOf(3) ? 3.0 : 0.1) * size, chance.orientation()};
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex = pose * Eigen::Vector3d(size * vertex);
  return mesh;
}

/// A mesh while it is damaged: facets with corners of their own.
struct LooseFacets {
  std::vector<std::array<Eigen::Vector3d, 3>> facets;

  explicit LooseFacets(const TriangleMesh& mesh) {
    for (const auto& [a, b, c] : mesh.triangles) {
      facets.push_back({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
    }
  }
  TriangleMesh mesh() const {
    TriangleMesh made;
    for (const auto& facet : facets) {
      const auto first = static_cast<std::uint32_t>(made.vertices.size());
      made.vertices.insert(made.vertices.end(), facet.begin(), facet.end());
      made.triangles.push_back({first, first + 1, first + 2});
    }
    return made;
  }

  /// Each corner by itself; 0: to the next single-precision number.
  void jitter(Chance& chance, double by) {
    for (auto& facet : facets) {
      for (Eigen::Vector3d& corner : facet) {
        corner = by > 0.0 ? Eigen::Vector3d(corner + chance.inBox(by))
                          : Eigen::Vector3d(corner.cast<float>().cast<double>());
        if (by > 0.0 || !chance.oneOf(4)) continue;
        for (double& coordinate : corner) {
          coordinate = static_cast<double>(std::nextafter(static_cast<float>(coordinate), 1e9f));
        }
      }
    }
  }
  /// A facet of no area along an edge, beside the rest.
  void addSliver(Chance& chance) {
    const auto facet = facets[chance.below(facets.size())];
    const std::size_t i = chance.below(3);
    const Eigen::Vector3d &a = facet[i], &b = facet[(i + 1) % 3];
    const Eigen::Vector3d on = a + (chance.oneOf(4) ? 0.0 : chance.between(0.0, 1.0)) * (b - a);
    facets.push_back({a, on, b});
  }
  void doubleOne(Chance& chance) {
    auto facet = facets[chance.below(facets.size())];
    if (chance.oneOf(2)) std::swap(facet[0], facet[1]);
    facets.push_back(facet);
  }
  /// A T-junction: one facet alone is divided at a point of its edge.
  void divideOne(Chance& chance) {
    const std::size_t which = chance.below(facets.size()), i = chance.below(3);
    const auto facet = facets[which];
    const Eigen::Vector3d &a = facet[i], &b = facet[(i + 1) % 3], &c = facet[(i + 2) % 3];
    const Eigen::Vector3d on = a + chance.between(0.1, 0.9) * (b - a);
    facets[which] = {a, on, c};
    facets.push_back({on, b, c});
  }
  void flipOne(Chance& chance) {
    auto& facet = facets[chance.below(facets.size())];
    std::swap(facet[0], facet[1]);
  }
  void shuffle(Chance& chance) {
    for (std::size_t i = facets.size(); i > 1; --i) std::swap(facets[i - 1], facets[chance.below(i)]);
  }
};

/// Winding number of any triangles about x in long double, by projection onto the sphere as Girard has it:
/// half the sum of the angles less two right ones (another formula than the library's).
inline double oracleWinding(const TriangleMesh& mesh, const Eigen::Vector3d& x) {
  Real sum = 0;
  for (const auto& corners : mesh.triangles) {
    std::array<RealVector, 3> to;
    for (std::size_t i = 0; i < 3; ++i) {
      to[i] = (mesh.vertices[corners[i]].cast<Real>() - x.cast<Real>()).normalized();
    }
    const Real volume = to[0].dot(to[1].cross(to[2]));
    if (std::abs(volume) < 1e-17L) continue;
    Real angles = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const RealVector u = to[i].cross(to[(i + 1) % 3]), v = to[i].cross(to[(i + 2) % 3]);
      angles += std::atan2(u.cross(v).norm(), u.dot(v));
    }
    sum += std::copysign(angles - static_cast<Real>(M_PI), volume);
  }
  return static_cast<double>(sum / (4 * static_cast<Real>(M_PI)));
}

}  // namespace cable_variation::test
