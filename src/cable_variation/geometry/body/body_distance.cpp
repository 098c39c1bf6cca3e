#include <cable_variation/geometry/body/body_distance.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <cable_variation/geometry/body/body_search.h>
#include <cable_variation/geometry/body/placed_body.h>
#include <cable_variation/geometry/tube_distance/distance_part.h>
#include <cable_variation/geometry/tube_distance/triangle_pair.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;
using Part = DistancePart::Impl;

constexpr double kTouching = 1e-9;  // nearer than this a core may be partly inside a solid [m]

// The point of the part's surface that is deepest in the core; none if no point is inside.
struct DeepestPoint {
  PlacedBody::Height at;
  std::uint32_t triangle = 0;  // of the tree
};
std::optional<DeepestPoint> deepestWithin(const PlacedBody& body, const TriangleTree& tree) {
  struct Open {
    double bound;
    std::uint32_t node;
  };
  std::optional<DeepestPoint> deepest;
  double best = 0.0;
  std::vector<Open> open;
  const auto add = [&](std::uint32_t node) {
    if (squaredGap(tree.nodes[node].box, body.box()) > 0.0) return;
    open.push_back({body.lowestPossible(tree.nodes[node].box), node});
  };
  add(0);
  while (!open.empty()) {
    const Open next = open.back();
    open.pop_back();
    if (next.bound >= best) continue;
    const TriangleTree::Node& node = tree.nodes[next.node];
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      if (body.lowestPossible(tree.triangles[i]) >= best) continue;
      const PlacedBody::Height at = body.lowest(tree.triangles[i]);
      if (at.height >= best) continue;
      best = at.height;
      deepest = {at, i};
    }
    if (node.count > 0) continue;
    const std::size_t before = open.size();
    add(node.first);
    add(node.first + 1);
    if (open.size() == before + 2 && open[before].bound < open[before + 1].bound) {
      std::swap(open[before], open[before + 1]);
    }
  }
  return deepest;
}

// Whether a box of the tree's leaves is within `distance` of a box.
bool anyWithin(const TriangleTree& tree, const Box& box, double distance) {
  if (distance < 0.0) return false;
  std::vector<std::uint32_t> open = {0};
  while (!open.empty()) {
    const TriangleTree::Node& node = tree.nodes[open.back()];
    open.pop_back();
    if (squaredGap(node.box, box) > distance * distance) continue;
    if (node.count > 0) return true;
    open.push_back(node.first);
    open.push_back(node.first + 1);
  }
  return false;
}

// The corner of the core that is deepest within a solid of the part. What is open counts where its winding
// number is clear.
std::optional<BodyPair> deepestCorner(const PlacedBody& body, const Part& part,
                                      std::atomic<bool>& undecided) {
  std::optional<BodyPair> deepest;
  for (const Vector3d& corner : body.vertices()) {
    for (const std::uint32_t solid : part.solidsAround(corner)) {
      const Part::Nearest nearest = *part.nearestOn(solid, corner, std::numeric_limits<double>::infinity());
      const double value = -nearest.at.distance - body.radius();
      if (deepest && value >= deepest->distance) continue;
      if (solid == part.openSolid() && !part.winding(corner).clear) {
        undecided = true;
        continue;
      }
      deepest = BodyPair();
      deepest->distance = value;
      deepest->on_body = corner + body.radius() * nearest.at.direction;
      deepest->on_other = nearest.at.point;
      deepest->facet = body.height(corner).facet;
      deepest->triangle = part.sourceOf(nearest.triangle);
    }
  }
  return deepest;
}

// Of the surfaces alone, as they are to each other.
BodyPair fromSurfaces(const PlacedBody& body, const Part& part, const TrianglePair& pair) {
  constexpr double kNoDirection = 1e-13;  // [m]
  BodyPair result;
  result.facet = body.facets().number[pair.first];
  result.triangle = part.tree.number[pair.second];
  result.distance = pair.distance - body.radius();
  const Vector3d direction = pair.distance > kNoDirection
                                 ? Vector3d((pair.on_second - pair.on_first) / pair.distance)
                                 : body.normal(result.facet);
  result.on_body = pair.on_first + body.radius() * direction;
  result.on_other = pair.on_second;
  return result;
}

BodyPair fromDepth(const PlacedBody& body, const Part& part, const DeepestPoint& deepest) {
  BodyPair result;
  result.facet = deepest.at.facet;
  result.triangle = part.tree.number[deepest.triangle];
  result.distance = deepest.at.height - body.radius();
  result.on_body = deepest.at.point - result.distance * body.normal(result.facet);
  result.on_other = deepest.at.point;
  return result;
}

// Up to `cutoff`. @param inside the core's centre lies in a solid
std::optional<BodyPair> closestPlaces(const PlacedBody& body, const Part& part, bool inside, double cutoff,
                                      std::atomic<bool>& undecided) {
  const double reach = cutoff + body.radius();
  if (!inside && !anyWithin(part.tree, body.box(), std::max(reach, 0.0)) &&
      !(part.caps && anyWithin(*part.caps, body.box(), 0.0))) {
    return std::nullopt;
  }
  std::optional<BodyPair> closest;
  // through an open rim a core may reach inside without touching the surface
  bool crosses = part.caps && anyWithin(*part.caps, body.box(), 0.0);
  if (const auto deepest = deepestWithin(body, part.tree)) {
    crosses = true;
    closest = fromDepth(body, part, *deepest);
  } else if (reach >= 0.0) {
    if (const auto pair = closestPoints(body.facets(), part.tree, reach)) {
      crosses = crosses || pair->distance < kTouching;
      closest = fromSurfaces(body, part, *pair);
    }
  }
  if (part.solids.count > 0 && (inside || crosses)) {
    const auto corner = deepestCorner(body, part, undecided);
    if (corner && (!closest || corner->distance < closest->distance)) closest = corner;
  }
  if (closest && closest->distance > cutoff) return std::nullopt;
  return closest;
}

Pose checked(const Pose& pose) {
  if (!(pose.position.allFinite() && pose.orientation.coeffs().allFinite() &&
        pose.orientation.norm() > 0.0)) {
    throw std::invalid_argument("distance: the part's pose is not finite");
  }
  return {pose.position, pose.orientation.normalized()};
}

}  // namespace

std::optional<BodyPair> distance(const std::vector<const RoundedHull*>& bodies, const DistancePart& part,
                                 const Pose& pose) {
  const Pose placed = checked(pose), to_part = placed.inverse();
  const Part& impl = part.impl();
  std::vector<Candidate> candidates(bodies.size());
  std::vector<char> inside(bodies.size(), 0);
  tbb::parallel_for(std::size_t{0}, bodies.size(), [&](std::size_t i) {
    const Vector3d centre = centreOf(bodies[i]->core);
    double reach = 0.0;
    for (const Vector3d& vertex : bodies[i]->core.surface().vertices) {
      reach = std::max(reach, (vertex - centre).norm());
    }
    const Vector3d there = to_part * centre;
    const double away = impl.nearest(there).at.distance;
    inside[i] = impl.solidsAround(there).empty() ? 0 : 1;
    const double key = away - reach - bodies[i]->radius;
    const bool may_be_inside = inside[i] != 0 || (impl.solids.count > 0 && away < reach) ||
                               (impl.caps && distanceTo(*impl.caps, there, reach) < reach);
    candidates[i] = {i, key, may_be_inside ? -away - reach - bodies[i]->radius : key};
  });
  std::atomic<bool> undecided{false};
  auto closest = closestOf(std::move(candidates), [&](std::size_t i, double cutoff) {
    return closestPlaces(PlacedBody(*bodies[i], to_part), impl, inside[i] != 0, cutoff, undecided);
  });
  if (closest) {
    closest->undecided = undecided || !impl.winding(closest->on_body).clear;
    closest->on_body = placed * closest->on_body;
    closest->on_other = placed * closest->on_other;
  }
  return closest;
}

std::vector<std::uint32_t> enteringTriangles(const std::vector<const RoundedHull*>& bodies,
                                             const DistancePart& part, const Pose& pose) {
  const Pose to_part = checked(pose).inverse();
  const TriangleTree& tree = part.impl().tree;
  std::vector<std::atomic<bool>> enters(tree.triangles.size());
  tbb::parallel_for(std::size_t{0}, bodies.size(), [&](std::size_t b) {
    const PlacedBody body(*bodies[b], to_part);
    const double radius = body.radius();
    std::vector<std::uint32_t> open = {0};
    while (!open.empty()) {
      const TriangleTree::Node& node = tree.nodes[open.back()];
      open.pop_back();
      if (squaredGap(node.box, body.box()) > radius * radius || body.lowestPossible(node.box) > radius) {
        continue;
      }
      if (node.count == 0) {
        open.push_back(node.first);
        open.push_back(node.first + 1);
      }
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        const SurfaceTriangle& triangle = tree.triangles[i];
        if (enters[i] || body.lowestPossible(triangle) > radius) continue;
        if (body.height(triangle.corners[0]).height <= 0.0 || comesWithin(body.facets(), triangle, radius)) {
          enters[i] = true;
        }
      }
    }
  });
  std::vector<std::uint32_t> entering;
  for (std::size_t i = 0; i < enters.size(); ++i) {
    if (enters[i]) entering.push_back(tree.number[i]);
  }
  std::sort(entering.begin(), entering.end());
  return entering;
}

}  // namespace cable_variation
