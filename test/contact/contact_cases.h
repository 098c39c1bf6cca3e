#pragma once

// Parts to touch, and harnesses that touch them.

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>

#include <cable_variation/contact/part_surface.h>
#include <cable_variation/geometry/mesh/triangle_mesh.h>
#include <equilibrium/cases.h>

namespace cable_variation::test {

/// A rectangle in the plane z = 0, of `columns` by `rows` fields of two triangles each, normals up.
inline TriangleMesh rectangle(const Eigen::Vector2d& low, const Eigen::Vector2d& high, int columns = 1,
                              int rows = 1) {
  TriangleMesh mesh;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      const Eigen::Vector2d share(static_cast<double>(i) / columns, static_cast<double>(j) / rows);
      const Eigen::Vector2d at = low + share.cwiseProduct(high - low);
      mesh.vertices.emplace_back(at.x(), at.y(), 0.0);
    }
  }
  const auto corner = [&](int i, int j) { return static_cast<std::uint32_t>(j * (columns + 1) + i); };
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      mesh.triangles.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)});
      mesh.triangles.push_back({corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)});
    }
  }
  return mesh;
}

/// A box about the origin, closed.
inline TriangleMesh box(const Eigen::Vector3d& size) {
  TriangleMesh mesh;
  for (int k = 0; k < 8; ++k) {
    const Eigen::Vector3d sign((k & 1) != 0 ? 0.5 : -0.5, (k & 2) != 0 ? 0.5 : -0.5,
                               (k & 4) != 0 ? 0.5 : -0.5);
    mesh.vertices.emplace_back(sign.cwiseProduct(size));
  }
  const std::uint32_t faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                     {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& f : faces) {
    mesh.triangles.push_back({f[0], f[1], f[2]});
    mesh.triangles.push_back({f[0], f[2], f[3]});
  }
  return mesh;
}

/// A cylinder about the z axis, closed, of so many flat sides, whose edges lie at `radius`.
inline TriangleMesh cylinder(double radius, double height, int sides) {
  TriangleMesh mesh;
  mesh.vertices.emplace_back(0.0, 0.0, -0.5 * height);
  mesh.vertices.emplace_back(0.0, 0.0, 0.5 * height);
  for (int i = 0; i < sides; ++i) {
    const double angle = 2.0 * M_PI * i / sides;
    for (const double z : {-0.5, 0.5})
      mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z * height);
  }
  const auto at = [&](int i, int top) { return static_cast<std::uint32_t>(2 + 2 * (i % sides) + top); };
  for (int i = 0; i < sides; ++i) {
    mesh.triangles.push_back({at(i, 0), at(i + 1, 0), at(i + 1, 1)});
    mesh.triangles.push_back({at(i, 0), at(i + 1, 1), at(i, 1)});
    mesh.triangles.push_back({0, at(i + 1, 0), at(i, 0)});
    mesh.triangles.push_back({1, at(i, 1), at(i + 1, 1)});
  }
  return mesh;
}

/// The harness's first cable touches a part with this mesh.
inline PartContact contactWith(const std::string& part, const TriangleMesh& mesh, const Pose& pose = {},
                               double stand_off = 0.0) {
  PartContact contact;
  contact.part = part;
  contact.surface = makePartSurface(mesh);
  contact.pose = pose;
  contact.stand_off = stand_off;
  return contact;
}

/// Of all forces of contact.
inline Eigen::Vector3d contactForce(const Equilibrium& result) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const ContactInterval& interval : result.contacts) sum += interval.force;
  return sum;
}

}  // namespace cable_variation::test
