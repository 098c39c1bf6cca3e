#include <cable_variation/geometry/tube_distance/parallel_bound.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cable_variation {
namespace {

constexpr int kFootSteps = 6;          // of Newton's method: any v will do, a foot is best
constexpr double kShortestMap = 1e-6;  // of v: below, it stays at an end of the section

constexpr std::array<double, 5> kChoose4 = {1.0, 4.0, 6.0, 4.0, 1.0};
constexpr std::array<double, 6> kChoose5 = {1.0, 5.0, 10.0, 10.0, 5.0, 1.0};
constexpr std::array<double, 10> kChoose9 = {1.0, 9.0, 36.0, 84.0, 126.0, 126.0, 84.0, 36.0, 9.0, 1.0};
constexpr std::array<double, 11> kChoose10 = {1.0,   10.0,  45.0, 120.0, 210.0, 252.0,
                                              210.0, 120.0, 45.0, 10.0,  1.0};

double footOn(const TubeSection& section, const Eigen::Vector3d& x, double v) {
  for (int step = 0; step < kFootSteps; ++step) {
    const TubeSection::Derivatives curve = section.derivatives(v);
    const Eigen::Vector3d apart = curve.position - x;
    const double bend = curve.first.squaredNorm() + apart.dot(curve.second);
    if (bend <= 0.0) break;
    v = std::clamp(v - apart.dot(curve.first) / bend, 0.0, 1.0);
  }
  return v;
}

// Of half the squared distance to the section's places, over v, from below, for all x of a ball.
double smallestBend(const TubeSection& section, const Eigen::Vector3d& centre, double ball) {
  const ControlPoints& e = section.control;
  const Eigen::Vector3d chord = e[5] - e[0];
  const double length = chord.norm();
  if (length == 0.0) return 0.0;
  double slowest = std::numeric_limits<double>::infinity(), sharpest = 0.0;
  for (std::size_t i = 0; i < 5; ++i) slowest = std::min(slowest, 5.0 * chord.dot(e[i + 1] - e[i]) / length);
  for (std::size_t i = 0; i < 4; ++i) {
    sharpest = std::max(sharpest, 20.0 * (e[i + 2] - 2.0 * e[i + 1] + e[i]).norm());
  }
  if (slowest <= 0.0) return 0.0;
  const double furthest = (section.middle - centre).norm() + section.reach + ball;
  return slowest * slowest - furthest * sharpest;
}

}  // namespace

std::optional<double> parallelBound(const TubeSection& first, const ControlPoints& part,
                                    const TubeSection& second) {
  const double m = smallestBend(second, first.middle, first.reach);
  if (m <= 0.0) return std::nullopt;
  const double start = footOn(second, part[0], 0.5), end = footOn(second, part[5], start);
  if (std::abs(end - start) < kShortestMap) return std::nullopt;
  const ControlPoints beside = restricted(second.control, start, end);

  ControlPoints apart;
  std::array<Eigen::Vector3d, 5> slope;  // of q over v
  for (std::size_t i = 0; i < 6; ++i) apart[i] = part[i] - beside[i];
  for (std::size_t i = 0; i < 5; ++i) slope[i] = 5.0 * (beside[i + 1] - beside[i]) / (end - start);
  std::array<double, 11> squared{};
  std::array<double, 10> along{};
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) squared[i + j] += kChoose5[i] * kChoose5[j] * apart[i].dot(apart[j]);
    for (std::size_t j = 0; j < 5; ++j) along[i + j] += kChoose5[i] * kChoose4[j] * apart[i].dot(slope[j]);
  }
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
  for (std::size_t k = 0; k < 11; ++k) least = std::min(least, squared[k] / kChoose10[k]);
  for (std::size_t k = 0; k < 10; ++k) most = std::max(most, std::abs(along[k]) / kChoose9[k]);
  return std::sqrt(std::max(0.0, least - most * most / m));
}

}  // namespace cable_variation
