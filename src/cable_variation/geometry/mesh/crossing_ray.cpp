#include <cable_variation/geometry/mesh/crossing_ray.h>

#include <utility>

namespace cable_variation {
namespace {

// None along an axis, a diagonal or another plane that parts are modelled in; z is the largest component.
constexpr double kTilts[CrossingRay::kDirections][2] = {
    {0.2371, 0.4127}, {-0.5113, 0.1873}, {0.3319, -0.6221}, {-0.1423, -0.3917},
    {0.7193, 0.0917}, {-0.6637, 0.5471}, {0.0719, -0.8111}, {-0.8529, -0.7331}};

// Twice the area of origin, from and to in the plane; exactly opposite for the edge taken the other way.
double edgeArea(const Eigen::Vector3d& from, const Eigen::Vector3d& to, std::uint32_t from_number,
                std::uint32_t to_number) {
  const auto area = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return a.x() * b.y() - a.y() * b.x();
  };
  return from_number < to_number ? area(from, to) : -area(to, from);
}

}  // namespace

CrossingRay::CrossingRay(const Eigen::Vector3d& origin, std::size_t direction)
    : origin_(origin),
      direction_(kTilts[direction][0], kTilts[direction][1], direction % 2 == 0 ? 1.0 : -1.0) {}

CrossingRay::Answer CrossingRay::crosses(const std::array<Eigen::Vector3d, 3>& corners,
                                         const std::array<std::uint32_t, 3>& numbers) const {
  std::array<Eigen::Vector3d, 3> sheared;
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d away = corners[i] - origin_;
    const double along = away.z() / direction_.z();
    sheared[i] = {away.x() - along * direction_.x(), away.y() - along * direction_.y(), along};
  }
  const double a = edgeArea(sheared[1], sheared[2], numbers[1], numbers[2]);
  const double b = edgeArea(sheared[2], sheared[0], numbers[2], numbers[0]);
  const double c = edgeArea(sheared[0], sheared[1], numbers[0], numbers[1]);
  if ((a < 0.0 || b < 0.0 || c < 0.0) && (a > 0.0 || b > 0.0 || c > 0.0)) return Answer::no;
  if (sheared[0].z() < 0.0 && sheared[1].z() < 0.0 && sheared[2].z() < 0.0) return Answer::no;
  if (a == 0.0 || b == 0.0 || c == 0.0) return Answer::unclear;
  const double along = (a * sheared[0].z() + b * sheared[1].z() + c * sheared[2].z()) / (a + b + c);
  if (along == 0.0) return Answer::unclear;
  if (along < 0.0) return Answer::no;
  // the shear turns space over where z counts backwards
  return (a + b + c > 0.0) == (direction_.z() > 0.0) ? Answer::leaves : Answer::enters;
}

}  // namespace cable_variation
