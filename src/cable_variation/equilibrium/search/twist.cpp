#include <cable_variation/equilibrium/search/twist.h>

#include <algorithm>
#include <cmath>

#include <cable_variation/math/so3.h>
#include <cable_variation/rod/kernel/element_kernel.h>
#include <cable_variation/rod/profile.h>

namespace cable_variation {
namespace {

bool holdsRoll(const Harness& harness, const Topology& topology, std::size_t index) {
  const Station& station = topology.stations[index];
  const bool is_parent = std::find(topology.joint_parent.begin(), topology.joint_parent.end(), index) !=
                         topology.joint_parent.end();
  if (station.joint || is_parent) return true;
  return station.clip && harness.clips[*station.clip].constraint.rotation[0].kind != ClipFreedom::Kind::free;
}

// About the first one's tangent [rad].
double rollBetween(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  const Eigen::Quaterniond relative = a.conjugate() * b;
  return std::remainder(2.0 * std::atan2(relative.x(), relative.w()), 2.0 * M_PI);
}

double twistOfSpan(const SpanConfiguration& span) {
  double sum = 0.0;
  for (std::size_t i = 1; i < span.orientations.size(); ++i) {
    sum += rollBetween(span.orientations[i - 1], span.orientations[i]);
  }
  return sum;
}

double restTorsion(const RodProfile& profile, double start, double end) {
  constexpr int kSteps = 16;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    sum += profile.at(start + (i + 0.5) / kSteps * (end - start)).rest_curvature.x() * (end - start) / kSteps;
  }
  return sum;
}

Eigen::Quaterniond rolled(const Eigen::Quaterniond& orientation, double angle) {
  return (orientation * so3::exp(Eigen::Vector3d(angle, 0.0, 0.0))).normalized();
}

}  // namespace

std::vector<TwistPiece> twistPieces(const Harness& harness, const Topology& topology,
                                    const Configuration& configuration) {
  std::vector<TwistPiece> pieces;
  for (std::size_t c = 0; c < harness.cables.size(); ++c) {
    const RodProfile profile(harness.cables[c]);
    const std::size_t first = pieces.size();
    bool started = false;
    TwistPiece piece;
    for (std::size_t k = 0; k < topology.cable_stations[c].size(); ++k) {
      const std::size_t station = topology.cable_stations[c][k];
      if (started) {
        const std::size_t span = topology.cable_spans[c][k - 1];
        const Span& of = topology.spans[span];
        piece.twist += twistOfSpan(configuration.spans[span]) -
                       restTorsion(profile, configuration.stations[of.left].arc_length,
                                   configuration.stations[of.right].arc_length);
      }
      if (!holdsRoll(harness, topology, station)) continue;
      if (started) {
        piece.right = station;
        pieces.push_back(piece);
      }
      started = true;
      piece = {c, station, station, 0.0, 0};
    }
    if (pieces.size() == first) continue;
    const auto arcLength = [&](std::size_t station) { return configuration.stations[station].arc_length; };
    const double held = arcLength(pieces.back().right) - arcLength(pieces[first].left);
    for (std::size_t i = first; i < pieces.size(); ++i) {
      const double share = (arcLength(pieces[i].right) - arcLength(pieces[i].left)) / held;
      const double asked = harness.cables[c].twist.value_or(0.0) * share;
      pieces[i].surplus = static_cast<int>(std::lround((pieces[i].twist - asked) / (2.0 * M_PI)));
    }
  }
  return pieces;
}

Configuration withoutSurplus(const Harness& harness, const Topology& topology, const Grid& grid,
                             const Configuration& configuration, const std::vector<TwistPiece>& pieces) {
  Configuration result = configuration;
  for (const TwistPiece& piece : pieces) {
    if (piece.surplus == 0) continue;
    const double start = configuration.stations[piece.left].arc_length;
    const double length = configuration.stations[piece.right].arc_length - start;
    const auto roll = [&](double arc_length) {
      return -2.0 * M_PI * piece.surplus * (arc_length - start) / length;
    };
    bool inside = false;
    const std::vector<std::size_t>& stations = topology.cable_stations[piece.cable];
    for (std::size_t k = 0; k + 1 < stations.size(); ++k) {
      inside = (inside || stations[k] == piece.left) && stations[k] != piece.right;
      if (!inside) continue;
      StationConfiguration& at = result.stations[stations[k]];
      const auto& clip = topology.stations[stations[k]].clip;
      if (stations[k] != piece.left) {
        if (clip && harness.clips[*clip].constraint.holdsRotation()) {
          at.rotation.x() = std::remainder(at.rotation.x() + roll(at.arc_length), 2.0 * M_PI);
        } else {
          at.pose.orientation = rolled(at.pose.orientation, roll(at.arc_length));
        }
      }
      const std::size_t index = topology.cable_spans[piece.cable][k];
      const double left = at.arc_length;
      const double right = result.stations[topology.spans[index].right].arc_length;
      SpanConfiguration& span = result.spans[index];
      for (std::size_t node = 0; node < span.orientations.size(); ++node) {
        const std::size_t element = std::min(node / 3, grid[index].size() - 2);
        const double in_element = element::kNodeAt[node - 3 * element];
        const double fraction =
            grid[index][element] + in_element * (grid[index][element + 1] - grid[index][element]);
        span.orientations[node] = rolled(span.orientations[node], roll(left + fraction * (right - left)));
      }
    }
  }
  placeStations(harness, topology, result);
  return result;
}

double twistOf(const std::vector<TwistPiece>& pieces, std::size_t cable) {
  double sum = 0.0;
  for (const TwistPiece& piece : pieces) {
    if (piece.cable == cable) sum += piece.twist;
  }
  return sum;
}

}  // namespace cable_variation
