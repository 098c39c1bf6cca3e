#include <cable_variation/geometry/tube_distance/triangle_pair.h>

#include <algorithm>
#include <vector>

#include <Eigen/Geometry>

namespace cable_variation {
namespace {

using Eigen::Vector3d;

Box boxOf(const SurfaceTriangle& triangle) {
  Box box;
  for (const Vector3d& corner : triangle.corners) box.add(corner);
  return box;
}

void take(TrianglePair& best, const Vector3d& on_first, const Vector3d& on_second) {
  const double distance = (on_first - on_second).norm();
  if (distance >= best.distance) return;
  best.distance = distance;
  best.on_first = on_first;
  best.on_second = on_second;
}

// The inner points of two edges that are closest; what is closest at an end the corners find.
void takeEdges(TrianglePair& best, const Vector3d& a, const Vector3d& b, const Vector3d& c,
               const Vector3d& d) {
  constexpr double kParallel = 1e-24;  // squared sine
  const Vector3d u = b - a, v = d - c, w = c - a, across = u.cross(v);
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), squared = across.squaredNorm();
  if (!(squared > kParallel * uu * vv)) return;
  double s = std::clamp(w.cross(v).dot(across) / squared, 0.0, 1.0), t = 0.0;
  // for nearly parallel edges the first s is only nearly right
  for (int round = 0; round < 2; ++round) {
    t = std::clamp(v.dot(a + s * u - c) / vv, 0.0, 1.0);
    s = std::clamp(u.dot(c + t * v - a) / uu, 0.0, 1.0);
  }
  take(best, a + s * u, c + t * v);
}

// Where the edges of `of` go through the plane of `through`; the nearest point of `through` to it.
template <typename Take>
void takeCrossings(const SurfaceTriangle& of, const SurfaceTriangle& through, const Take& taken) {
  if (through.normal.isZero(0.0)) return;
  std::array<double, 3> heights;
  for (std::size_t i = 0; i < 3; ++i) heights[i] = through.normal.dot(of.corners[i] - through.corners[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    if ((heights[i] > 0.0) == (heights[next] > 0.0)) continue;
    const double share = heights[i] / (heights[i] - heights[next]);
    const Vector3d crossing = of.corners[i] + share * (of.corners[next] - of.corners[i]);
    taken(crossing, nearestPoint(through, crossing).point);
  }
}

}  // namespace

TrianglePair closestPoints(const SurfaceTriangle& first, const SurfaceTriangle& second) {
  TrianglePair best;
  best.distance = std::numeric_limits<double>::infinity();
  takeCrossings(first, second, [&](const Vector3d& a, const Vector3d& b) { take(best, a, b); });
  takeCrossings(second, first, [&](const Vector3d& b, const Vector3d& a) { take(best, a, b); });
  if (best.distance == 0.0) return best;
  for (const Vector3d& corner : first.corners) take(best, corner, nearestPoint(second, corner).point);
  for (const Vector3d& corner : second.corners) take(best, nearestPoint(first, corner).point, corner);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      takeEdges(best, first.corners[i], first.corners[(i + 1) % 3], second.corners[k],
                second.corners[(k + 1) % 3]);
    }
  }
  return best;
}

std::optional<TrianglePair> closestPoints(const TriangleTree& first, const TriangleTree& second,
                                          double at_most) {
  struct Open {
    double squared;
    std::uint32_t first, second;
  };
  std::optional<TrianglePair> best;
  double reach = at_most;
  std::vector<Open> open;
  open.reserve(128);
  const auto add = [&](std::uint32_t a, std::uint32_t b) {
    open.push_back({squaredGap(first.nodes[a].box, second.nodes[b].box), a, b});
  };
  add(0, 0);
  while (!open.empty()) {
    const Open next = open.back();
    open.pop_back();
    if (reach < 0.0 || next.squared > reach * reach) continue;
    const TriangleTree::Node& a = first.nodes[next.first];
    const TriangleTree::Node& b = second.nodes[next.second];
    if (a.count > 0 && b.count > 0) {
      for (std::uint32_t i = a.first; i < a.first + a.count; ++i) {
        const Box box = boxOf(first.triangles[i]);
        if (squaredGap(box, b.box) > reach * reach) continue;
        for (std::uint32_t k = b.first; k < b.first + b.count; ++k) {
          if (squaredGap(box, boxOf(second.triangles[k])) > reach * reach) continue;
          TrianglePair pair = closestPoints(first.triangles[i], second.triangles[k]);
          if (pair.distance > reach || (best && pair.distance >= best->distance)) continue;
          pair.first = i;
          pair.second = k;
          best = pair;
          reach = pair.distance;
        }
      }
      continue;
    }
    const std::size_t before = open.size();
    if (b.count > 0 || (a.count == 0 && a.box.largestExtent() > b.box.largestExtent())) {
      add(a.first, next.second);
      add(a.first + 1, next.second);
    } else {
      add(next.first, b.first);
      add(next.first, b.first + 1);
    }
    if (open[before].squared < open[before + 1].squared) std::swap(open[before], open[before + 1]);
  }
  return best;
}

bool comesWithin(const TriangleTree& tree, const SurfaceTriangle& triangle, double distance) {
  const Box box = boxOf(triangle);
  const double squared = distance * distance;
  std::vector<std::uint32_t> open = {0};
  while (!open.empty()) {
    const TriangleTree::Node& node = tree.nodes[open.back()];
    open.pop_back();
    if (squaredGap(node.box, box) > squared) continue;
    if (node.count == 0) {
      open.push_back(node.first);
      open.push_back(node.first + 1);
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      if (squaredGap(boxOf(tree.triangles[i]), box) <= squared &&
          closestPoints(tree.triangles[i], triangle).distance <= distance) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace cable_variation
