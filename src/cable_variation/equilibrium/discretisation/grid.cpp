#include <cable_variation/equilibrium/discretisation/grid.h>

#include <algorithm>
#include <cmath>

#include <cable_variation/rod/kernel/element_kernel.h>

namespace cable_variation {
namespace {

using element::kNodeAt;
using element::kNodes;

Pose interpolate(const SpanConfiguration& span, const std::vector<double>& boundaries, double fraction) {
  const auto after = std::upper_bound(boundaries.begin(), boundaries.end(), fraction);
  const auto e = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(
      after - boundaries.begin() - 1, 0, static_cast<std::ptrdiff_t>(boundaries.size()) - 2));
  const double xi = (fraction - boundaries[e]) / (boundaries[e + 1] - boundaries[e]);
  Pose pose;
  Eigen::Vector4d q = Eigen::Vector4d::Zero();
  const Eigen::Vector4d first = span.orientations[3 * e].coeffs();
  for (std::size_t a = 0; a < kNodes; ++a) {
    double weight = 1.0;
    for (std::size_t b = 0; b < kNodes; ++b) {
      if (b != a) weight *= (xi - kNodeAt[b]) / (kNodeAt[a] - kNodeAt[b]);
    }
    pose.position += weight * span.positions[3 * e + a];
    const Eigen::Vector4d node = span.orientations[3 * e + a].coeffs();
    q += (node.dot(first) < 0.0 ? -weight : weight) * node;
  }
  pose.orientation = Eigen::Quaterniond(q).normalized();
  return pose;
}

}  // namespace

namespace {

// The length of a cable over the one at which its weight and its bending stiffness balance.
double bendingLengths(const Harness& harness, std::size_t cable) {
  const Section section = sectionAt(harness.cables[cable], 0.5 * harness.cables[cable].length);
  const double weight = section.mass_per_length * harness.gravity.norm();
  return harness.cables[cable].length * std::cbrt(weight / std::min(section.EI_y, section.EI_z));
}

}  // namespace

Grid startGrid(const Harness& harness, const Topology& topology) {
  constexpr double kElementsPerCable = 4.0;
  // A heavy soft cable bends within a few times the length at which weight and bending balance.
  constexpr double kBendingLengths = 4.0;  // of an element
  constexpr double kMostForWeight = 32.0;
  // Turns about a straight centreline do not move it, so its error would not ask for more elements; and a
  // preformed cable must be able to take its form.
  constexpr double kLargestTurn = 1.6;  // of an element [rad]: leaves 1e-5 of the torque
  std::vector<double> turns;
  for (const Cable& cable : harness.cables) {
    double turn = std::abs(cable.twist.value_or(0.0));
    for (std::size_t i = 0; i < cable.rest_curvature.size(); ++i) {
      const bool last = i + 1 == cable.rest_curvature.size();
      const double end = last ? cable.length : cable.rest_curvature[i + 1].arc_length;
      turn += cable.rest_curvature[i].curvature.norm() * (end - cable.rest_curvature[i].arc_length);
    }
    turns.push_back(turn);
  }
  Grid grid;
  for (const Span& span : topology.spans) {
    const double elements =
        std::max({kElementsPerCable, turns[span.cable] / kLargestTurn,
                  std::min(kMostForWeight, bendingLengths(harness, span.cable) / kBendingLengths)});
    const double length = topology.stations[span.right].arc_length - topology.stations[span.left].arc_length;
    const double share = length / harness.cables[span.cable].length;
    const int pairs = std::max(1, static_cast<int>(std::ceil(0.5 * elements * share - 1e-9)));
    std::vector<double> boundaries;
    for (int i = 0; i <= 2 * pairs; ++i) boundaries.push_back(0.5 * i / pairs);
    grid.push_back(boundaries);
  }
  return grid;
}

Grid refine(const Grid& grid, const std::vector<std::vector<bool>>& marked) {
  Grid fine;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    std::vector<double> boundaries{0.0};
    for (std::size_t e = 0; e + 1 < grid[i].size(); ++e) {
      if (marked[i][e / 2]) boundaries.push_back(0.5 * (grid[i][e] + grid[i][e + 1]));
      boundaries.push_back(grid[i][e + 1]);
    }
    fine.push_back(boundaries);
  }
  return fine;
}

Grid coarsen(const Grid& grid) {
  Grid coarse;
  for (const auto& boundaries : grid) {
    std::vector<double> kept;
    for (std::size_t e = 0; e < boundaries.size(); e += 2) kept.push_back(boundaries[e]);
    coarse.push_back(kept);
  }
  return coarse;
}

Configuration transfer(const Configuration& configuration, const Grid& from, const Grid& to) {
  Configuration result;
  result.stations = configuration.stations;
  result.spans.resize(to.size());
  for (std::size_t i = 0; i < to.size(); ++i) {
    SpanConfiguration& span = result.spans[i];
    const std::size_t count = 3 * (to[i].size() - 1) + 1;
    span.positions.reserve(count);
    span.orientations.reserve(count);
    for (std::size_t e = 0; e + 1 < to[i].size(); ++e) {
      for (std::size_t a = e == 0 ? 0 : 1; a < kNodes; ++a) {
        const double fraction = to[i][e] + kNodeAt[a] * (to[i][e + 1] - to[i][e]);
        const Pose pose = interpolate(configuration.spans[i], from[i], fraction);
        span.positions.push_back(pose.position);
        span.orientations.push_back(pose.orientation);
      }
    }
    span.positions.back() = configuration.spans[i].positions.back();
    span.orientations.back() = configuration.spans[i].orientations.back();
  }
  return result;
}

}  // namespace cable_variation
