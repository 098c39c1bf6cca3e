#include <cable_variation/geometry/body/body_union.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cable_variation {
namespace {

// Bodies are left out of what they cannot decide by more than rounding: so it never matters which were.
constexpr double kRounding = 1e-12;  // [m]
// Closer to a core, the way to it is not sure of its direction; a facet's plane is.
constexpr double kNoDirection = 1e-9;  // [m]

}  // namespace

std::vector<BodyUnion::Near> BodyUnion::all() const {
  std::vector<Near> near(bodies_.size());
  for (std::size_t i = 0; i < near.size(); ++i) near[i].body = i;
  return near;
}

double BodyUnion::bodyValue(std::size_t body, const Eigen::Vector3d& point, double bound) const {
  const ConvexHull& core = bodies_[body]->core;
  const double height = core.height(point);
  if (height <= 0.0 || height - radii_[body] >= bound) return height - radii_[body];
  return core.closest(point).distance - radii_[body];
}

BodyUnion::Near BodyUnion::seenFrom(const Eigen::Vector3d& middle, std::size_t body) const {
  const ConvexHull& core = bodies_[body]->core;
  const ConvexHull::Closest closest = core.closest(middle);
  Near near;
  near.body = body;
  near.value = closest.distance - radii_[body];
  if (closest.distance > kNoDirection) {
    near.gradient = (middle - closest.point) / closest.distance;
  } else {
    const auto plane = core.planes().col(static_cast<Eigen::Index>(closest.triangle));
    near.gradient = plane.head<3>();
    near.value = near.gradient.dot(middle) - plane[3] - radii_[body];
  }
  return near;
}

std::vector<BodyUnion::Near> BodyUnion::closestIn(const Eigen::Vector3d& middle, double half_edge,
                                                  const std::vector<Near>& given) const {
  // The closest one at the middle can be overtaken by those that are no more than twice the reach further.
  const double reach = std::sqrt(3.0) * half_edge;
  double smallest = std::numeric_limits<double>::infinity();
  std::vector<Near> near;
  near.reserve(given.size());
  for (const Near& candidate : given) {
    const double bound = smallest + 2.0 * reach + kRounding;
    if (bodies_[candidate.body]->core.height(middle) - radii_[candidate.body] > bound) continue;
    near.push_back(seenFrom(middle, candidate.body));
    smallest = std::min(smallest, near.back().value);
  }
  std::sort(near.begin(), near.end(), [](const Near& a, const Near& b) {
    return a.value != b.value ? a.value < b.value : a.body < b.body;
  });

  // What is above the first one in all corners, by its tangent, is above it everywhere in between, where the
  // first one is below its own interpolation.
  std::array<Eigen::Vector3d, 8> corners;
  std::array<double, 8> first;
  for (std::size_t i = 0; i < 8; ++i) {
    corners[i] = half_edge * Eigen::Vector3d(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0);
    first[i] = bodyValue(near.front().body, middle + corners[i], std::numeric_limits<double>::infinity());
  }
  near.erase(std::remove_if(near.begin() + 1, near.end(),
                            [&](const Near& body) {
                              for (std::size_t i = 0; i < 8; ++i) {
                                if (body.lowerBound(corners[i]) <= first[i] + kRounding) return false;
                              }
                              return true;
                            }),
             near.end());
  return near;
}

double BodyUnion::value(const Eigen::Vector3d& point, const Eigen::Vector3d& middle,
                        const std::vector<Near>& near) const {
  const Eigen::Vector3d from_middle = point - middle;
  const auto lowest = std::min_element(near.begin(), near.end(), [&](const Near& a, const Near& b) {
    return a.lowerBound(from_middle) < b.lowerBound(from_middle);
  });
  double smallest = bodyValue(lowest->body, point, std::numeric_limits<double>::infinity());
  for (auto body = near.begin(); body != near.end(); ++body) {
    if (body == lowest || body->lowerBound(from_middle) >= smallest + kRounding) continue;
    smallest = std::min(smallest, bodyValue(body->body, point, smallest));
  }
  return smallest;
}

}  // namespace cable_variation
