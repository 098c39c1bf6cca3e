#include <cable_variation/geometry/mesh/surface_triangle.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace cable_variation {
namespace {

// Below this [m] the way from the foot to x has lost its direction to rounding.
constexpr double kNoDirection = 1e-13;

}  // namespace

Eigen::Vector3d someNormal(const Eigen::Vector3d& v) {
  Eigen::Index smallest;
  v.cwiseAbs().minCoeff(&smallest);
  const Eigen::Vector3d across = v.cross(Eigen::Vector3d::Unit(smallest));
  const double length = across.norm();
  return length > 0.0 ? Eigen::Vector3d(across / length) : Eigen::Vector3d::UnitZ();
}

SurfaceTriangle::SurfaceTriangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
    : corners{a, b, c} {
  // In extended precision: a sliver's normal comes from a difference of products that nearly agree.
  using Vector = Eigen::Matrix<long double, 3, 1>;
  const std::array<Vector, 3> edges = {b.cast<long double>() - a.cast<long double>(),
                                       c.cast<long double>() - b.cast<long double>(),
                                       a.cast<long double>() - c.cast<long double>()};
  std::array<std::size_t, 3> order = {0, 1, 2};
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return edges[i].squaredNorm() < edges[j].squaredNorm(); });
  // the two shorter ones, in the triangle's sense
  const std::size_t first = (order[0] + 1) % 3 == order[1] ? order[0] : order[1];
  const Vector across = edges[first].cross(edges[(first + 1) % 3]);
  const long double area = across.norm(), longest = edges[order[2]].squaredNorm();
  normal = area > 1e-8L * longest ? Eigen::Vector3d((across / area).cast<double>())
                                  : Eigen::Vector3d(Eigen::Vector3d::Zero());
}

NearestPoint nearestPoint(const SurfaceTriangle& triangle, const Eigen::Vector3d& x) {
  const auto& corners = triangle.corners;
  const Eigen::Vector3d& normal = triangle.normal;
  const std::array<Eigen::Vector3d, 3> away = {x - corners[0], x - corners[1], x - corners[2]};
  const std::array<Eigen::Vector3d, 3> edges = {corners[1] - corners[0], corners[2] - corners[1],
                                                corners[0] - corners[2]};
  const bool flat = normal.squaredNorm() > 0.0;
  NearestPoint nearest;
  bool above_face = flat;
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    // The nearest point lies on an edge that x sees from outside, if there is one.
    if (flat && normal.cross(edges[i]).dot(away[i]) >= 0.0) continue;
    above_face = false;
    const double along = away[i].dot(edges[i]), length = edges[i].squaredNorm();
    NearestPoint::On on = NearestPoint::On::corner;
    std::size_t number = i;
    Eigen::Vector3d offset = away[i];
    Eigen::Vector3d foot = corners[i];
    if (along >= length) {
      number = (i + 1) % 3;
      offset = away[(i + 1) % 3];
      foot = corners[(i + 1) % 3];
    } else if (along > 0.0) {
      on = NearestPoint::On::edge;
      const Eigen::Vector3d way = (along / length) * edges[i];
      offset -= way;
      foot += way;
    }
    const double squared = offset.squaredNorm();
    if (squared < smallest) {
      smallest = squared;
      nearest.on = on;
      nearest.number = number;
      nearest.point = foot;
      nearest.direction = offset;
      nearest.edge = edges[i];
    }
  }
  if (above_face) {
    const double height = normal.dot(away[0]);
    nearest.on = NearestPoint::On::face;
    nearest.distance = std::abs(height);
    nearest.point = x - height * normal;
    nearest.direction = height < 0.0 ? Eigen::Vector3d(-normal) : normal;
    return nearest;
  }
  nearest.distance = std::sqrt(smallest);
  if (nearest.distance > kNoDirection) {
    nearest.direction /= nearest.distance;
  } else {
    nearest.direction = flat ? normal : someNormal(nearest.edge);
  }
  return nearest;
}

}  // namespace cable_variation
