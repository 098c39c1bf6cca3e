#include <cable_variation/geometry/body_union.h>

#include <algorithm>
#include <limits>

namespace cable_variation {

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

std::vector<BodyUnion::Near> BodyUnion::closestAbout(const Eigen::Vector3d& middle, double reach,
                                                     const std::vector<Near>& given) const {
  // The closest one at the middle can be overtaken by those that are no more than twice the reach further.
  double smallest = std::numeric_limits<double>::infinity();
  std::vector<Near> near;
  near.reserve(given.size());
  for (const Near& candidate : given) {
    const double bound = smallest + 2.0 * reach;
    const double value = bodyValue(candidate.body, middle, bound);
    if (value > bound) continue;
    near.push_back({candidate.body, value});
    smallest = std::min(smallest, value);
  }
  near.erase(std::remove_if(near.begin(), near.end(),
                            [&](const Near& body) { return body.value > smallest + 2.0 * reach; }),
             near.end());
  std::sort(near.begin(), near.end(), [](const Near& a, const Near& b) {
    return a.value != b.value ? a.value < b.value : a.body < b.body;
  });
  return near;
}

double BodyUnion::value(const Eigen::Vector3d& point, double from_middle,
                        const std::vector<Near>& near) const {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Near& body : near) {
    if (body.value - from_middle >= smallest) break;
    smallest = std::min(smallest, bodyValue(body.body, point, smallest));
  }
  return smallest;
}

}  // namespace cable_variation
