#include <cable_variation/geometry/mesh/soup_builder.h>

#include <stdexcept>
#include <string>

#include <Eigen/Geometry>

namespace cable_variation {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::size_t kMostCorners = 4096;  // ears are looked for among all of them

double cross(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

}  // namespace

std::uint32_t SoupBuilder::vertex(const Vector3d& at) {
  if (!at.allFinite()) throw std::invalid_argument("a vertex is not finite");
  const auto [known, is_new] =
      numbers_.try_emplace({at.x(), at.y(), at.z()}, static_cast<std::uint32_t>(mesh_.vertices.size()));
  if (is_new) mesh_.vertices.push_back(at);
  return known->second;
}

void SoupBuilder::triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  if (a != b && b != c && c != a) mesh_.triangles.push_back({a, b, c});
}

// By cutting ears: corners that stick out and whose triangle holds no other corner.
void SoupBuilder::polygon(const std::vector<std::uint32_t>& corners) {
  if (corners.size() == 3) return triangle(corners[0], corners[1], corners[2]);
  if (corners.size() > kMostCorners) {
    throw std::invalid_argument("a polygon of " + std::to_string(corners.size()) +
                                " corners; expected at most " + std::to_string(kMostCorners));
  }
  Vector3d normal = Vector3d::Zero();  // Newell's
  const Vector3d& origin = mesh_.vertices[corners[0]];
  for (std::size_t i = 0; i < corners.size(); ++i) {
    normal += (mesh_.vertices[corners[i]] - origin)
                  .cross(mesh_.vertices[corners[(i + 1) % corners.size()]] - origin);
  }
  if (!(normal.norm() > 0.0)) {  // no area: a fan keeps its edges
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) triangle(corners[0], corners[i], corners[i + 1]);
    return;
  }
  normal.normalize();
  const Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  std::vector<Vector2d> flat;
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector3d from = mesh_.vertices[corners[i]] - origin;
    flat.emplace_back(u.dot(from), v.dot(from));
    left.push_back(i);
  }
  std::size_t at = 0, tried = 0;
  while (left.size() > 3) {
    const std::size_t n = left.size();
    const std::size_t a = left[(at + n - 1) % n], b = left[at % n], c = left[(at + 1) % n];
    bool ear = cross(flat[a], flat[b], flat[c]) > 0.0;
    for (std::size_t k = 0; k < n && ear; ++k) {
      const std::size_t other = left[k];
      if (corners[other] == corners[a] || corners[other] == corners[b] || corners[other] == corners[c])
        continue;
      ear = !(cross(flat[a], flat[b], flat[other]) >= 0.0 && cross(flat[b], flat[c], flat[other]) >= 0.0 &&
              cross(flat[c], flat[a], flat[other]) >= 0.0);
    }
    if (!ear && tried < n) {  // of a polygon that crosses itself, any corner when none is an ear
      ++tried;
      at = (at + 1) % n;
      continue;
    }
    triangle(corners[a], corners[b], corners[c]);
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(at % n));
    at = at % n == 0 ? 0 : at % n - 1;
    tried = 0;
  }
  triangle(corners[left[0]], corners[left[1]], corners[left[2]]);
}

}  // namespace cable_variation
