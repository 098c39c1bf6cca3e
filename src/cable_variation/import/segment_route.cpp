#include <cable_variation/import/segment_route.h>

#include <algorithm>

namespace cable_variation {
namespace {

double distanceToChord(const Eigen::Vector3d& point, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d way = to - from;
  const double squared = way.squaredNorm();
  const double share = squared > 0.0 ? std::clamp((point - from).dot(way) / squared, 0.0, 1.0) : 0.0;
  return (point - from - share * way).norm();
}

}  // namespace

std::vector<Eigen::Vector3d> routePoints(const SegmentCurve& curve, double tolerance) {
  const std::vector<CurvePoint> samples = curve.samples();
  std::vector<std::size_t> chosen{0};
  // From each point as far as the samples passed stay near the chord; at worst to the next sample.
  while (chosen.back() + 1 < samples.size()) {
    const std::size_t from = chosen.back();
    std::size_t to = from + 1;
    const auto isNear = [&](std::size_t next) {
      for (std::size_t i = from + 1; i < next; ++i) {
        if (distanceToChord(samples[i].position, samples[from].position, samples[next].position) > tolerance)
          return false;
      }
      return true;
    };
    while (to + 1 < samples.size() && isNear(to + 1)) ++to;
    chosen.push_back(to);
  }
  std::vector<Eigen::Vector3d> points;
  constexpr double kSame = 1e-8;  // [m] above the rounding of a scene file
  for (const std::size_t index : chosen) {
    const Eigen::Vector3d& point = samples[index].position;
    if (points.empty() || (point - points.back()).norm() > kSame) points.push_back(point);
  }
  return points;
}

}  // namespace cable_variation
