#include <cable_variation/geometry/tube_distance/tube_section.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace cable_variation {
namespace {

constexpr double kTurn = 0.35;           // a section turns about by no more [rad]: 20 degrees
constexpr std::size_t kSections = 64;    // and is no longer than this part of the cable
constexpr double kShortest = 1e-12;      // stretches of a piece that are shorter do not count [1]
constexpr std::size_t kMostCuts = 4096;  // of one piece

// Coefficients over u of the polynomial in t, with t = start + u (end - start).
std::array<Eigen::Vector3d, 6> over(const std::array<Eigen::Vector3d, 6>& powers, double start, double end) {
  std::array<Eigen::Vector3d, 6> shifted = powers;
  // Taylor's shift by Horner's scheme
  for (std::size_t i = 0; i < 5; ++i) {
    for (std::size_t k = 5; k-- > i;) shifted[k] += start * shifted[k + 1];
  }
  double scale = 1.0;
  for (std::size_t k = 1; k < 6; ++k) {
    scale *= end - start;
    shifted[k] *= scale;
  }
  return shifted;
}

ControlPoints controlPoints(const std::array<Eigen::Vector3d, 6>& powers) {
  // b_i = sum over k of binomial(i, k) / binomial(5, k) a_k
  static constexpr double kOverBinomial[6] = {1.0, 0.2, 0.1, 0.1, 0.2, 1.0};
  ControlPoints points;
  for (std::size_t k = 0; k < 6; ++k) points[k] = kOverBinomial[k] * powers[k];
  for (std::size_t level = 1; level < 6; ++level) {
    for (std::size_t k = 5; k >= level; --k) points[k] += points[k - 1];
  }
  return points;
}

void setBounds(TubeSection& section) {
  for (const Eigen::Vector3d& point : section.control) section.box.add(point);
  section.middle = section.position(0.5);
  double squared = 0.0;
  for (const Eigen::Vector3d& point : section.control) {
    squared = std::max(squared, (point - section.middle).squaredNorm());
  }
  section.reach = std::sqrt(squared);
}

// At least the angle that the curve turns about [rad]: that of its control polygon.
double turnOf(const ControlPoints& points) {
  std::array<Eigen::Vector3d, 5> legs;
  for (std::size_t i = 0; i < 5; ++i) legs[i] = points[i + 1] - points[i];
  // squared tangents, which are no less than the angles, tell without roots that all turn little
  bool little = true;
  for (std::size_t i = 0; i < 4; ++i) {
    const double along = legs[i].dot(legs[i + 1]);
    little = little && along > 0.0 &&
             16.0 * legs[i].cross(legs[i + 1]).squaredNorm() <= kTurn * kTurn * along * along;
  }
  if (little) return kTurn;
  double turn = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    turn += std::atan2(legs[i].cross(legs[i + 1]).norm(), legs[i].dot(legs[i + 1]));
  }
  return turn;
}

void check(const Centreline& cable, const std::vector<SkippedStretch>& skipped) {
  if (cable.pieces.empty()) throw std::invalid_argument("distance: a centreline without pieces");
  for (std::size_t i = 0; i < cable.pieces.size(); ++i) {
    const Centreline::Piece& piece = cable.pieces[i];
    const auto name = [i] { return "distance: piece " + std::to_string(i) + " of the centreline"; };
    if (!(std::isfinite(piece.start) && std::isfinite(piece.end) && piece.start < piece.end)) {
      throw std::invalid_argument(name() + ": arc lengths from " + std::to_string(piece.start) + " to " +
                                  std::to_string(piece.end) + " m, expected to grow");
    }
    for (const double radius : {piece.start_radius, piece.end_radius}) {
      if (!(std::isfinite(radius) && radius >= 0.0)) {
        throw std::invalid_argument(name() + ": radius " + std::to_string(radius) +
                                    " m, expected a finite one of at least 0");
      }
    }
    for (const Eigen::Vector3d& coefficient : piece.curve.coefficients()) {
      if (!coefficient.allFinite()) throw std::invalid_argument(name() + ": positions that are not finite");
    }
  }
  for (const SkippedStretch& stretch : skipped) {
    if (!(stretch.start <= stretch.end)) {
      throw std::invalid_argument("distance: skipped stretch from " + std::to_string(stretch.start) + " to " +
                                  std::to_string(stretch.end) + " m, expected to grow");
    }
  }
}

struct Range {
  double start, end;  // of t
};

// What of a piece counts, cut where asked for.
void findRanges(const Centreline::Piece& piece, const std::vector<SkippedStretch>& skipped,
                std::optional<double> cut, std::vector<Range>& ranges) {
  const double length = piece.end - piece.start;
  ranges.assign(1, {0.0, 1.0});
  for (const SkippedStretch& stretch : skipped) {
    const double from = (stretch.start - piece.start) / length, to = (stretch.end - piece.start) / length;
    for (std::size_t i = ranges.size(); i-- > 0;) {
      const Range range = ranges[i];
      if (to <= range.start || from >= range.end) continue;
      const auto here = ranges.erase(ranges.begin() + static_cast<std::ptrdiff_t>(i));
      if (range.end - to > kShortest) ranges.insert(here, {to, range.end});
      if (from - range.start > kShortest) {
        ranges.insert(ranges.begin() + static_cast<std::ptrdiff_t>(i), {range.start, from});
      }
    }
  }
  if (!cut) return;
  const double at = (*cut - piece.start) / length;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (at - ranges[i].start > kShortest && ranges[i].end - at > kShortest) {
      ranges.insert(ranges.begin() + static_cast<std::ptrdiff_t>(i) + 1, {at, ranges[i].end});
      ranges[i].end = at;
      break;
    }
  }
}

}  // namespace

std::array<ControlPoints, 2> halves(const ControlPoints& points) {
  ControlPoints left, right = points;
  for (std::size_t level = 0; level < 6; ++level) {
    left[level] = right[0];
    for (std::size_t i = 0; i + level + 1 < 6; ++i) right[i] = 0.5 * (right[i] + right[i + 1]);
  }
  return {left, right};
}

ControlPoints restricted(const ControlPoints& points, double start, double end) {
  // point i is the blossom at 5 - i times start and i times end
  ControlPoints result;
  for (std::size_t i = 0; i < 6; ++i) {
    ControlPoints level = points;
    for (std::size_t k = 0; k < 5; ++k) {
      const double u = k < i ? end : start;
      for (std::size_t j = 0; j + k + 1 < 6; ++j) level[j] = (1.0 - u) * level[j] + u * level[j + 1];
    }
    result[i] = level[0];
  }
  return result;
}

double sagittaBound(const ControlPoints& points) {
  double squared = 0.0;
  for (std::size_t i = 1; i < 5; ++i) {
    const double u = static_cast<double>(i) / 5.0;
    squared = std::max(squared, (points[i] - ((1.0 - u) * points[0] + u * points[5])).squaredNorm());
  }
  return std::sqrt(squared);
}

Eigen::Vector3d TubeSection::position(double u) const {
  Eigen::Vector3d sum = powers[5];
  for (std::size_t k = 5; k-- > 0;) sum = powers[k] + u * sum;
  return sum;
}

TubeSection::Derivatives TubeSection::derivatives(double u) const {
  Eigen::Vector3d sum = powers[5], first = Eigen::Vector3d::Zero(), half_second = Eigen::Vector3d::Zero();
  for (std::size_t k = 5; k-- > 0;) {
    half_second = first + u * half_second;
    first = sum + u * first;
    sum = powers[k] + u * sum;
  }
  return {sum, first, 2.0 * half_second};
}

std::vector<TubeSection> sectionsOf(const Centreline& cable, const Pose& pose,
                                    const std::vector<SkippedStretch>& skipped, std::optional<double> cut) {
  check(cable, skipped);
  const Eigen::Matrix3d back = pose.orientation.normalized().toRotationMatrix().transpose();
  const double longest =
      (cable.pieces.back().end - cable.pieces.front().start) / static_cast<double>(kSections);
  std::vector<TubeSection> sections;
  sections.reserve(cable.pieces.size() + kSections);
  std::vector<Range> counted;
  for (std::size_t i = 0; i < cable.pieces.size(); ++i) {
    const Centreline::Piece& piece = cable.pieces[i];
    TubeSection whole;
    whole.piece = i;
    whole.powers = piece.curve.coefficients();
    whole.powers[0] -= pose.position;
    for (Eigen::Vector3d& power : whole.powers) power = back * power;
    whole.control = controlPoints(whole.powers);
    const double turn = turnOf(whole.control);
    findRanges(piece, skipped, cut, counted);
    for (const Range& range : counted) {
      const double part = range.end - range.start;
      // 1.5: a cable of this many equal pieces is not cut further
      const double cuts = std::max({1.0, std::ceil(part * turn / kTurn),
                                    std::ceil(part * (piece.end - piece.start) / (1.5 * longest))});
      const std::size_t count =
          cuts < static_cast<double>(kMostCuts) ? static_cast<std::size_t>(cuts) : kMostCuts;
      for (std::size_t k = 0; k < count; ++k) {
        TubeSection& section = sections.emplace_back(whole);
        const auto at = [&](std::size_t step) {
          return step == count ? range.end
                               : range.start + part * static_cast<double>(step) / static_cast<double>(count);
        };
        section.t_start = at(k);
        section.t_end = at(k + 1);
        section.start_radius = cable.radius({i, section.t_start});
        section.end_radius = cable.radius({i, section.t_end});
        if (section.t_start != 0.0 || section.t_end != 1.0) {
          section.powers = over(whole.powers, section.t_start, section.t_end);
          section.control = controlPoints(section.powers);
        }
        setBounds(section);
      }
    }
  }
  for (std::size_t i = 0; i + 1 < sections.size(); ++i) {
    const TubeSection &here = sections[i], &next = sections[i + 1];
    sections[i].continued = here.piece == next.piece
                                ? here.t_end == next.t_start
                                : here.piece + 1 == next.piece && here.t_end == 1.0 && next.t_start == 0.0;
  }
  return sections;
}

SectionTree::SectionTree(const std::vector<TubeSection>& sections) {
  nodes.reserve(2 * sections.size());
  if (!sections.empty()) build(sections, 0, sections.size());
}

std::size_t SectionTree::build(const std::vector<TubeSection>& sections, std::size_t first,
                               std::size_t count) {
  const std::size_t index = nodes.size();
  nodes.emplace_back();
  Node node;
  node.first = first;
  node.count = count;
  if (count == 1) {
    node.box = sections[first].box;
    node.largest_radius = sections[first].largestRadius();
  } else {
    node.left = build(sections, first, count / 2);
    node.right = build(sections, first + count / 2, count - count / 2);
    for (const std::size_t child : {node.left, node.right}) {
      node.box.add(nodes[child].box);
      node.largest_radius = std::max(node.largest_radius, nodes[child].largest_radius);
    }
  }
  nodes[index] = node;
  return index;
}

}  // namespace cable_variation
