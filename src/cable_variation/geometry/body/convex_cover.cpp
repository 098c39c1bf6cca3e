#include <cable_variation/geometry/body/convex_cover.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace cable_variation {
namespace {

constexpr double kRounding = 1e-7;  // room for coordinates of 24 bits, as files have them [m]

using Points = std::vector<Eigen::Vector3d>;

// The corners of an icosahedron and the middles of its edges, about a ball of the radius 1.
Points aroundUnitBall() {
  const double golden = 0.5 * (1.0 + std::sqrt(5.0));
  Points corners;
  for (const double a : {-1.0, 1.0}) {
    for (const double b : {-golden, golden}) {
      corners.push_back(Eigen::Vector3d(0.0, a, b).normalized());
      corners.push_back(Eigen::Vector3d(a, b, 0.0).normalized());
      corners.push_back(Eigen::Vector3d(b, 0.0, a).normalized());
    }
  }
  Points all = corners;
  const ConvexHull icosahedron(corners);
  for (const auto& [a, b, c] : icosahedron.surface().triangles) {
    // each edge from one of its triangles
    if (a < b) all.push_back((corners[a] + corners[b]).normalized());
    if (b < c) all.push_back((corners[b] + corners[c]).normalized());
    if (c < a) all.push_back((corners[c] + corners[a]).normalized());
  }
  const double inner_radius = ConvexHull(all).planes().row(3).minCoeff();
  for (Eigen::Vector3d& corner : all) corner /= inner_radius;
  return all;
}

// From the closest of the bodies, or of their cores [m].
double distanceFromClosest(const Eigen::Vector3d& point, const std::vector<const RoundedHull*>& bodies,
                           bool cores) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const RoundedHull* body : bodies) {
    const double radius = cores ? 0.0 : body->radius;
    if (body->core.height(point) - radius >= smallest) continue;
    smallest = std::min(smallest, body->core.closest(point).distance - radius);
  }
  return smallest;
}

double distanceOfMiddles(const TriangleMesh& surface, const std::vector<const RoundedHull*>& bodies,
                         bool cores) {
  double largest = 0.0;
  for (const auto& [a, b, c] : surface.triangles) {
    const Eigen::Vector3d middle = (surface.vertices[a] + surface.vertices[b] + surface.vertices[c]) / 3.0;
    largest = std::max(largest, distanceFromClosest(middle, bodies, cores));
  }
  return largest;
}

ConvexHull commonCore(const std::vector<const RoundedHull*>& bodies) {
  if (bodies.empty()) throw std::invalid_argument("convex cover of no bodies; expected one at least");
  Points cores;
  for (const RoundedHull* body : bodies) {
    const Points& vertices = body->core.surface().vertices;
    cores.insert(cores.end(), vertices.begin(), vertices.end());
  }
  return ConvexHull(cores);
}

}  // namespace

ConvexCover convexCover(const std::vector<const RoundedHull*>& bodies) {
  const ConvexHull core = commonCore(bodies);
  static const Points around = aroundUnitBall();
  double radius = 0.0;
  for (const RoundedHull* body : bodies) radius = std::max(radius, body->radius);
  Points sums;
  for (const Eigen::Vector3d& vertex : core.surface().vertices) {
    for (const Eigen::Vector3d& corner : around) sums.push_back(vertex + (radius + kRounding) * corner);
  }

  ConvexCover cover = {ConvexHull(sums), 0.0};
  const TriangleMesh& surface = cover.hull.surface();
  cover.excess = distanceOfMiddles(surface, bodies, false);
  for (const Eigen::Vector3d& vertex : surface.vertices) {
    cover.excess = std::max(cover.excess, distanceFromClosest(vertex, bodies, false));
  }
  return cover;
}

double mergingExcess(const std::vector<const RoundedHull*>& bodies) {
  return distanceOfMiddles(commonCore(bodies).surface(), bodies, true);
}

}  // namespace cable_variation
