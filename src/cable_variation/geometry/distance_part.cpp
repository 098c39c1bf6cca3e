#include <cable_variation/geometry/distance_part.h>

#include <algorithm>
#include <cmath>

#include <cable_variation/geometry/crossing_ray.h>

namespace cable_variation {
namespace {

// Whether the ray can meet the box; boxes are padded by more than the rounding of coordinates.
bool meets(const CrossingRay& ray, const Box& box) {
  const Eigen::Array3d origin = ray.origin().array(), direction = ray.direction().array();
  const Eigen::Array3d pad = 1e-12 * (1.0 + box.low.abs().max(box.high.abs()).max(origin.abs()));
  const Eigen::Array3d a = (box.low - pad - origin) / direction, b = (box.high + pad - origin) / direction;
  return std::max(a.min(b).maxCoeff(), 0.0) <= a.max(b).minCoeff();
}

// Numbers of the shells that a ray crosses, once for each crossing; none if it is unclear.
std::optional<std::vector<std::uint32_t>> crossings(const DistancePart::Impl& part, const CrossingRay& ray) {
  std::vector<std::uint32_t> crossed, open = {0};
  while (!open.empty()) {
    const TriangleTree::Node& node = part.tree.nodes[open.back()];
    open.pop_back();
    if (!meets(ray, node.box)) continue;
    if (node.count == 0) {
      open.push_back(node.first);
      open.push_back(node.first + 1);
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const std::uint32_t number = part.tree.number[i];
      const std::uint32_t shell = part.solids.shell[number];
      if (shell == Solids::kOpen) continue;
      const auto answer = ray.crosses(part.tree.triangles[i].corners, part.solids.corners[number]);
      if (answer == CrossingRay::Answer::unclear) return std::nullopt;
      if (answer == CrossingRay::Answer::yes) crossed.push_back(shell);
    }
  }
  return crossed;
}

// The nearest point to x on the triangles that count, closer than `bound`.
template <typename Counts>
std::optional<DistancePart::Impl::Nearest> nearestAmong(const TriangleTree& tree, const Eigen::Vector3d& x,
                                                        double bound, const Counts& counts) {
  std::optional<DistancePart::Impl::Nearest> nearest;
  struct Open {
    double squared;
    std::uint32_t node;
  };
  std::vector<Open> open;
  open.reserve(64);
  open.push_back({squaredGap(tree.nodes[0].box, x), 0});
  while (!open.empty()) {
    const Open next = open.back();
    open.pop_back();
    if (next.squared >= bound * bound) continue;
    const TriangleTree::Node& node = tree.nodes[next.node];
    if (node.count == 0) {
      Open left{squaredGap(tree.nodes[node.first].box, x), node.first};
      Open right{squaredGap(tree.nodes[node.first + 1].box, x), node.first + 1};
      if (left.squared < right.squared) std::swap(left, right);
      open.push_back(left);
      open.push_back(right);
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      if (!counts(i)) continue;
      const NearestPoint at = nearestPoint(tree.triangles[i], x);
      if (at.distance >= bound) continue;
      bound = at.distance;
      nearest = {i, at};
    }
  }
  return nearest;
}

}  // namespace

DistancePart::Impl::Impl(const TriangleMesh& mesh) : tree(mesh), solids(mesh) {
  place_in_tree.resize(tree.number.size());
  for (std::uint32_t i = 0; i < tree.number.size(); ++i) place_in_tree[tree.number[i]] = i;
}

std::vector<std::uint32_t> DistancePart::Impl::solidsAround(const Eigen::Vector3d& x) const {
  if (std::none_of(solids.shells.begin(), solids.shells.end(),
                   [&](const Solids::Shell& shell) { return !shell.cavity && shell.box.contains(x); })) {
    return {};
  }
  for (std::size_t direction = 0; direction < CrossingRay::kDirections; ++direction) {
    std::optional<std::vector<std::uint32_t>> crossed = crossings(*this, CrossingRay(x, direction));
    if (!crossed) continue;
    std::sort(crossed->begin(), crossed->end());
    std::vector<std::uint32_t> around, in_cavity;
    for (std::size_t i = 0, end; i < crossed->size(); i = end) {
      const std::uint32_t number = (*crossed)[i];
      for (end = i + 1; end < crossed->size() && (*crossed)[end] == number;) ++end;
      if ((end - i) % 2 == 0) continue;
      const Solids::Shell& shell = solids.shells[number];
      (shell.cavity ? in_cavity : around).push_back(shell.solid);
    }
    const auto hollow = [&](std::uint32_t solid) {
      return std::find(in_cavity.begin(), in_cavity.end(), solid) != in_cavity.end();
    };
    around.erase(std::remove_if(around.begin(), around.end(), hollow), around.end());
    return around;
  }
  return {};  // x lies on the surface
}

std::optional<DistancePart::Impl::Nearest> DistancePart::Impl::nearestOn(std::uint32_t solid,
                                                                         const Eigen::Vector3d& x,
                                                                         double bound) const {
  return nearestAmong(tree, x, bound, [&](std::uint32_t i) { return solidOf(i) == solid; });
}

DistancePart::Impl::Nearest DistancePart::Impl::nearest(const Eigen::Vector3d& x) const {
  return *nearestAmong(tree, x, std::numeric_limits<double>::infinity(), [](std::uint32_t) { return true; });
}

bool DistancePart::Impl::isLocallyNearest(const Eigen::Vector3d& x, const NearestPoint& at) const {
  constexpr double kTouching = 1e-9, kNearer = 1e-12;  // [m]
  if (at.on == NearestPoint::On::face) return true;
  bool nearest = true;
  forEachNear(at.point, kTouching, [&](std::uint32_t i) {
    if (nearestPoint(tree.triangles[i], at.point).distance > kTouching) return;
    if (nearestPoint(tree.triangles[i], x).distance < at.distance - kNearer) nearest = false;
  });
  return nearest;
}

DistancePart::DistancePart(const TriangleMesh& mesh) : impl_(std::make_unique<Impl>(mesh)) {}
DistancePart::~DistancePart() = default;
DistancePart::DistancePart(DistancePart&&) noexcept = default;
DistancePart& DistancePart::operator=(DistancePart&&) noexcept = default;

}  // namespace cable_variation
