#include <cable_variation/geometry/tube_distance/distance_part.h>

#include <algorithm>
#include <cmath>

#include <cable_variation/geometry/mesh/crossing_ray.h>
#include <cable_variation/geometry/mesh/winding_number.h>

namespace cable_variation {
namespace {

// Whether the ray can meet the box; boxes are padded by more than the rounding of coordinates.
bool meets(const CrossingRay& ray, const Box& box) {
  const Eigen::Array3d origin = ray.origin().array(), direction = ray.direction().array();
  const Eigen::Array3d pad = 1e-12 * (1.0 + box.low.abs().max(box.high.abs()).max(origin.abs()));
  const Eigen::Array3d a = (box.low - pad - origin) / direction, b = (box.high + pad - origin) / direction;
  return std::max(a.min(b).maxCoeff(), 0.0) <= a.max(b).minCoeff();
}

// A shell that a ray crosses.
struct Crossing {
  std::uint32_t shell;
  int turn;  // 1: the ray leaves, -1: it enters
};

// One for each crossing; none if it is unclear.
std::optional<std::vector<Crossing>> crossings(const DistancePart::Impl& part, const CrossingRay& ray) {
  const TriangleTree& tree = part.boundary();
  std::vector<Crossing> crossed;
  std::vector<std::uint32_t> open = {0};
  while (!open.empty()) {
    const TriangleTree::Node& node = tree.nodes[open.back()];
    open.pop_back();
    if (!meets(ray, node.box)) continue;
    if (node.count == 0) {
      open.push_back(node.first);
      open.push_back(node.first + 1);
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const std::uint32_t number = tree.number[i];
      const std::uint32_t shell = part.solids.shell[number];
      if (shell == Solids::kNone) continue;
      switch (ray.crosses(tree.triangles[i].corners, part.solids.corners[number])) {
        case CrossingRay::Answer::unclear:
          return std::nullopt;
        case CrossingRay::Answer::leaves:
          crossed.push_back({shell, 1});
          break;
        case CrossingRay::Answer::enters:
          crossed.push_back({shell, -1});
          break;
        case CrossingRay::Answer::no:
          break;
      }
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
  if (!solids.boundary.triangles.empty()) welded.emplace(solids.boundary);
  if (!solids.caps.triangles.empty()) caps.emplace(solids.caps);
}

DistancePart::Impl::Around DistancePart::Impl::around(const Eigen::Vector3d& x) const {
  Around result;
  if (std::none_of(solids.shells.begin(), solids.shells.end(),
                   [&](const Solids::Shell& shell) { return !shell.cavity && shell.box.contains(x); })) {
    return result;
  }
  for (std::size_t direction = 0; direction < CrossingRay::kDirections; ++direction) {
    std::optional<std::vector<Crossing>> crossed = crossings(*this, CrossingRay(x, direction));
    if (!crossed) continue;
    std::sort(crossed->begin(), crossed->end(),
              [](const Crossing& a, const Crossing& b) { return a.shell < b.shell; });
    std::vector<std::uint32_t> in_cavity;
    for (std::size_t i = 0, end; i < crossed->size(); i = end) {
      const std::uint32_t number = (*crossed)[i].shell;
      int turns = 0;
      for (end = i; end < crossed->size() && (*crossed)[end].shell == number; ++end) {
        turns += (*crossed)[end].turn;
      }
      const bool is_open = solids.open == number;
      if (is_open) result.open_turns = turns;
      if (is_open ? turns == 0 : (end - i) % 2 == 0) continue;
      const Solids::Shell& shell = solids.shells[number];
      (shell.cavity ? in_cavity : result.solids).push_back(shell.solid);
    }
    const auto hollow = [&](std::uint32_t solid) {
      return std::find(in_cavity.begin(), in_cavity.end(), solid) != in_cavity.end();
    };
    result.solids.erase(std::remove_if(result.solids.begin(), result.solids.end(), hollow),
                        result.solids.end());
    return result;
  }
  return result;  // x lies on the surface
}

DistancePart::Impl::Winding DistancePart::Impl::winding(const Eigen::Vector3d& x) const {
  Winding result;
  if (!isOpen()) return result;
  const int turns = around(x).open_turns;
  result.number = turns;
  if (caps) {
    for (const SurfaceTriangle& cap : caps->triangles) result.number -= windingNumber(cap.corners, x);
  }
  const double whole = std::round(result.number);
  result.clear = std::abs(result.number - whole) <= kClearWinding && (whole != 0.0) == (turns != 0);
  return result;
}

std::optional<DistancePart::Impl::Nearest> DistancePart::Impl::nearestOn(std::uint32_t solid,
                                                                         const Eigen::Vector3d& x,
                                                                         double bound) const {
  return nearestAmong(boundary(), x, bound, [&](std::uint32_t i) { return solidOf(i) == solid; });
}

DistancePart::Impl::Nearest DistancePart::Impl::nearest(const Eigen::Vector3d& x) const {
  return *nearestAmong(tree, x, std::numeric_limits<double>::infinity(), [](std::uint32_t) { return true; });
}

bool isLocallyNearest(const TriangleTree& tree, const Eigen::Vector3d& x, const NearestPoint& at) {
  constexpr double kTouching = 1e-9, kNearer = 1e-12;  // [m]
  if (at.on == NearestPoint::On::face) return true;
  bool nearest = true;
  forEachNear(tree, at.point, kTouching, [&](std::uint32_t i) {
    if (nearestPoint(tree.triangles[i], at.point).distance > kTouching) return;
    if (nearestPoint(tree.triangles[i], x).distance < at.distance - kNearer) nearest = false;
  });
  return nearest;
}

double distanceTo(const TriangleTree& tree, const Eigen::Vector3d& x, double bound) {
  const auto nearest = nearestAmong(tree, x, bound, [](std::uint32_t) { return true; });
  return nearest ? nearest->at.distance : bound;
}

DistancePart::DistancePart(const TriangleMesh& mesh) : impl_(std::make_unique<Impl>(mesh)) {}
PartOpenness DistancePart::openness() const { return {impl_->solids.rim_edges, impl_->solids.rim_length}; }
DistancePart::~DistancePart() = default;
DistancePart::DistancePart(DistancePart&&) noexcept = default;
DistancePart& DistancePart::operator=(DistancePart&&) noexcept = default;

}  // namespace cable_variation
