#include <cable_variation/geometry/tube_distance/surface_places.h>

#include <algorithm>
#include <cmath>

#include <cable_variation/geometry/tube_distance/distance_part.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;

constexpr double kTouching = 1e-9;  // [m] of a triangle from a place: the place is on it
constexpr double kNearer = 1e-12;   // [m] by which a neighbour must be nearer to count as such
constexpr double kFlat = 1e-12;     // 1 - cosine, between a triangle's normal and the direction to x
// Two places are one that are no further apart, seen in directions of no smaller cosine: rounding tells an
// edge of a flat face from the face beside it only so well.
constexpr double kSame = 1e-6;  // [m]
constexpr double kAlike = 1.0 - 1e-6;

struct Candidate {
  std::uint32_t triangle;
  NearestPoint at;
};

// What the surface about a place on an edge or a corner says: whether it comes no nearer to x, and whether a
// facet there faces x, so that the place is one of a face.
struct About {
  bool nearest = true, face = false;
};

About lookAbout(const TriangleTree& tree, const std::vector<Candidate>& candidates, const Candidate& at) {
  About about;
  for (const Candidate& other : candidates) {
    // all that touch the place are among the candidates: none of them is further from x than the place
    if (other.at.distance > at.at.distance + kTouching) break;
    const SurfaceTriangle& triangle = tree.triangles[other.triangle];
    const bool nearer = other.at.distance < at.at.distance - kNearer;
    const bool faces = std::abs(triangle.normal.dot(at.at.direction)) > 1.0 - kFlat;
    if (!nearer && !faces) continue;
    if (nearestPoint(triangle, at.at.point).distance > kTouching) continue;
    if (nearer) return {false, false};
    about.face = true;
  }
  return about;
}

Eigen::Matrix3d curvatureAt(const NearestPoint& at) {
  Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - at.direction * at.direction.transpose();
  if (at.on == NearestPoint::On::edge) {
    const Vector3d along = at.edge.normalized();
    across -= along * along.transpose();
  }
  return across / at.distance;
}

}  // namespace

void placesNear(const DistancePart& part, const Vector3d& x, double within,
                std::vector<SurfacePlace>& places) {
  const TriangleTree& tree = part.impl().tree;
  std::vector<Candidate> candidates;
  forEachNear(tree, x, within, [&](std::uint32_t i) {
    const NearestPoint at = nearestPoint(tree.triangles[i], x);
    if (at.distance < within) candidates.push_back({i, at});
  });
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return a.at.distance != b.at.distance ? a.at.distance < b.at.distance : a.triangle < b.triangle;
  });
  const std::size_t first = places.size();
  for (const Candidate& candidate : candidates) {
    const NearestPoint& at = candidate.at;
    const bool known = std::any_of(
        places.begin() + static_cast<std::ptrdiff_t>(first), places.end(), [&](const SurfacePlace& other) {
          return (other.point - at.point).norm() < kSame && other.direction.dot(at.direction) > kAlike;
        });
    if (known) continue;
    bool face = at.on == NearestPoint::On::face;
    if (!face) {
      const About about = lookAbout(tree, candidates, candidate);
      if (!about.nearest) continue;
      face = about.face;
    }
    SurfacePlace place;
    place.point = at.point;
    place.direction = at.direction;
    place.distance = at.distance;
    if (!face && at.distance > 0.0) place.curvature = curvatureAt(at);
    places.push_back(place);
  }
}

double surfaceDistance(const DistancePart& part, const Vector3d& x, double within) {
  return distanceTo(part.impl().tree, x, within);
}

}  // namespace cable_variation
