#include <cable_variation/geometry/mesh/soup_builder.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include <Eigen/Geometry>

namespace cable_variation {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

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
  if (a == b || b == c || c == a) return;
  if (mesh_.triangles.size() == most_triangles_) {
    throw std::invalid_argument("it has more triangles; " + atMost(most_triangles_, "triangles"));
  }
  mesh_.triangles.push_back({a, b, c});
}

// By cutting ears: corners that stick out and whose triangle holds no other corner. If it holds any, it holds
// one that does not stick out: only those are looked at.
void SoupBuilder::polygon(const std::vector<std::uint32_t>& corners) {
  const std::size_t count = corners.size();
  if (count == 3) return triangle(corners[0], corners[1], corners[2]);
  Vector3d normal = Vector3d::Zero();  // Newell's
  const Vector3d& origin = mesh_.vertices[corners[0]];
  for (std::size_t i = 0; i < count; ++i) {
    normal += (mesh_.vertices[corners[i]] - origin).cross(mesh_.vertices[corners[(i + 1) % count]] - origin);
  }
  if (!(normal.norm() > 0.0)) {  // no area: a fan keeps its edges
    for (std::size_t i = 1; i + 1 < count; ++i) triangle(corners[0], corners[i], corners[i + 1]);
    return;
  }
  normal.normalize();
  const Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  std::vector<Vector2d> flat;
  std::vector<std::size_t> before, after, sunken;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3d from = mesh_.vertices[corners[i]] - origin;
    flat.emplace_back(u.dot(from), v.dot(from));
    before.push_back((i + count - 1) % count);
    after.push_back((i + 1) % count);
  }
  const auto sticksOut = [&](std::size_t i) { return cross(flat[before[i]], flat[i], flat[after[i]]) > 0.0; };
  std::vector<bool> is_cut(count, false);
  for (std::size_t i = 0; i < count; ++i) {
    if (!sticksOut(i)) sunken.push_back(i);
  }
  const auto isEar = [&](std::size_t b) {
    const std::size_t a = before[b], c = after[b];
    if (!sticksOut(b)) return false;
    spend(sunken.size());
    return std::none_of(sunken.begin(), sunken.end(), [&](std::size_t other) {
      if (is_cut[other] || corners[other] == corners[a] || corners[other] == corners[b] ||
          corners[other] == corners[c])
        return false;
      return cross(flat[a], flat[b], flat[other]) >= 0.0 && cross(flat[b], flat[c], flat[other]) >= 0.0 &&
             cross(flat[c], flat[a], flat[other]) >= 0.0;
    });
  };
  std::size_t first = 0, at = 0, tried = 0, sunken_cut = 0;
  for (std::size_t left = count; left > 3;) {
    if (tried < left && !isEar(at)) {  // of a polygon that crosses itself, any corner when none is an ear
      spend(1);
      ++tried;
      at = after[at];
      continue;
    }
    const std::size_t a = before[at], c = after[at];
    triangle(corners[a], corners[at], corners[c]);
    is_cut[at] = true;
    after[a] = c;
    before[c] = a;
    if (at == first)
      first = at = c;
    else
      at = a;
    --left;
    tried = 0;
    // those that stick out by now, or are cut
    if (++sunken_cut * 8 < sunken.size()) continue;
    sunken.erase(std::remove_if(sunken.begin(), sunken.end(),
                                [&](std::size_t i) { return is_cut[i] || sticksOut(i); }),
                 sunken.end());
    sunken_cut = 0;
  }
  triangle(corners[before[at]], corners[at], corners[after[at]]);
}

void SoupBuilder::spend(std::size_t tests) {
  constexpr std::size_t kMost = 2'000'000'000;  // some seconds
  tests_ += tests;
  if (tests_ > kMost) {
    throw std::invalid_argument(
        "its polygons have too many corners that turn inwards to be divided; expected "
        "simpler ones, or triangles");
  }
}

}  // namespace cable_variation
