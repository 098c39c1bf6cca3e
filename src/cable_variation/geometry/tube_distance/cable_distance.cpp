#include <cable_variation/geometry/tube_distance/distance.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <cable_variation/geometry/tube_distance/closest_cells.h>
#include <cable_variation/geometry/tube_distance/section_pair.h>
#include <cable_variation/geometry/tube_distance/tube_section.h>

namespace cable_variation {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Cell {
  std::size_t first = 0, second = 0;  // sections
  PairMinimum at;
};

using Sections = std::vector<TubeSection>;

double arcLength(const Centreline& cable, const TubeSection& section, double u) {
  return cable.arcLength(section.place(u));
}

// Ways from the joint along the sections, which the joint cuts.
WayCondition conditionOf(const Centreline& cable, const TubeSection& first, const Centreline& other,
                         const TubeSection& second, const JoinedAt& joined) {
  const auto way = [](const Centreline& line, const TubeSection& section, double joint, double u) {
    return std::abs(arcLength(line, section, u) - joint);
  };
  WayCondition condition;
  condition.first_start = way(cable, first, joined.on_cable, 0.0);
  condition.first_slope = way(cable, first, joined.on_cable, 1.0) - condition.first_start;
  condition.second_start = way(other, second, joined.on_other, 0.0);
  condition.second_slope = way(other, second, joined.on_other, 1.0) - condition.second_start;
  condition.shortest = joined.shortest_way;
  return condition;
}

class Walk {
 public:
  Walk(const Centreline& cable, const Sections& first, const Centreline& other, const Sections& second,
       const std::optional<JoinedAt>& joined, double margin)
      : cable_(cable), other_(other), first_(first), second_(second), joined_(joined), margin_(margin) {}

  // The cells within the margin of the smallest, that one first.
  std::vector<Cell> run() {
    const SectionTree first_tree(first_), second_tree(second_);
    struct Pair {
      double squared;
      std::size_t first, second;
    };
    std::vector<Pair> open;
    const auto add = [&](std::size_t first, std::size_t second) {
      open.push_back({squaredGap(first_tree.nodes[first].box, second_tree.nodes[second].box), first, second});
    };
    add(0, 0);
    while (!open.empty()) {
      const Pair pair = open.back();
      open.pop_back();
      const SectionTree::Node& first = first_tree.nodes[pair.first];
      const SectionTree::Node& second = second_tree.nodes[pair.second];
      const double reach = best_ + margin_ + first.largest_radius + second.largest_radius;
      if (reach <= 0.0 || pair.squared >= reach * reach) continue;
      const bool first_leaf = first.count == 1, second_leaf = second.count == 1;
      if (first_leaf && second_leaf) {
        evaluate(first.first, second.first);
        continue;
      }
      const std::size_t before = open.size();
      if (second_leaf || (!first_leaf && first.box.largestExtent() > second.box.largestExtent())) {
        add(first.left, pair.second);
        add(first.right, pair.second);
      } else {
        add(pair.first, second.left);
        add(pair.first, second.right);
      }
      if (open[before].squared < open[before + 1].squared) std::swap(open[before], open[before + 1]);
    }
    return closestFirst(std::move(cells_), best_ + margin_);
  }

 private:
  void evaluate(std::size_t first, std::size_t second) {
    WayCondition condition;
    if (joined_) condition = conditionOf(cable_, first_[first], other_, second_[second], *joined_);
    const auto minimum = smallest(first_[first], second_[second], condition, best_ + margin_);
    if (!minimum) return;
    best_ = std::min(best_, minimum->value);
    cells_.push_back({first, second, *minimum});
  }

  const Centreline& cable_;
  const Centreline& other_;
  const Sections& first_;
  const Sections& second_;
  const std::optional<JoinedAt>& joined_;
  double margin_;
  double best_ = kInfinity;
  std::vector<Cell> cells_;
};

// Whether the value falls where the neighbour of a section goes on from its place u.
bool fallsBeyond(const Sections& sections, std::size_t number, double u, const Eigen::Vector3d& direction) {
  const auto falls = [&](const TubeSection& next, double at, double sense) {
    const Eigen::Vector3d first = next.derivatives(at).first;
    const double slope = direction.dot(first) - (next.end_radius - next.start_radius);
    return sense * slope < -1e-9 * first.norm();
  };
  if (u == 1.0 && sections[number].continued) return falls(sections[number + 1], 0.0, 1.0);
  if (u == 0.0 && number > 0 && sections[number - 1].continued) return falls(sections[number - 1], 1.0, -1.0);
  return false;
}

double runnerUp(const Centreline& cable, const Sections& first, const Centreline& other,
                const Sections& second, const std::vector<Cell>& cells) {
  const Cell& best = cells.front();
  const auto apart = [](const Centreline& line, const TubeSection& a, double u, const TubeSection& b,
                        double v) {
    return std::abs(arcLength(line, a, u) - arcLength(line, b, v)) > 2.0 * a.radius(u);
  };
  for (const Cell& cell : cells) {
    const bool elsewhere = apart(cable, first[best.first], best.at.u, first[cell.first], cell.at.u) ||
                           apart(other, second[best.second], best.at.v, second[cell.second], cell.at.v) ||
                           (cell.at.direction - best.at.direction).norm() > kOtherDirection;
    if (elsewhere && !fallsBeyond(first, cell.first, cell.at.u, cell.at.direction) &&
        !fallsBeyond(second, cell.second, cell.at.v, -cell.at.direction)) {
      return cell.at.value;
    }
  }
  return kInfinity;
}

}  // namespace

std::optional<ClosestPair> distance(const Centreline& cable, const Centreline& other,
                                    const std::optional<JoinedAt>& joined, double margin) {
  if (!(std::isfinite(margin) && margin >= 0.0)) {
    throw std::invalid_argument("distance: margin " + std::to_string(margin) +
                                " m, expected a finite one of at least 0");
  }
  if (joined && !(std::isfinite(joined->on_cable) && std::isfinite(joined->on_other) &&
                  std::isfinite(joined->shortest_way))) {
    throw std::invalid_argument("distance: a joint's arc lengths are not finite");
  }
  std::optional<double> cut, other_cut;
  if (joined) {
    cut = joined->on_cable;
    other_cut = joined->on_other;
  }
  // about the middle of one of them, so that a place far from the origin costs no digits
  Pose origin;
  if (!cable.pieces.empty()) origin.position = cable.pieces[cable.pieces.size() / 2].curve.position(0.0);
  const Sections first = sectionsOf(cable, origin, {}, cut);
  const Sections second = sectionsOf(other, origin, {}, other_cut);
  const std::vector<Cell> cells = Walk(cable, first, other, second, joined, margin).run();
  if (cells.empty()) return std::nullopt;

  const Cell& best = cells.front();
  ClosestPair pair;
  pair.distance = best.at.value;
  pair.contact = pair.distance < 0.0 ? ClosestPair::Contact::overlap : ClosestPair::Contact::clear;
  pair.place = first[best.first].place(best.at.u);
  pair.other_place = second[best.second].place(best.at.v);
  pair.on_cable = origin.position + first[best.first].position(best.at.u);
  pair.on_other = origin.position + second[best.second].position(best.at.v);
  pair.direction = best.at.direction;
  pair.runner_up = runnerUp(cable, first, other, second, cells);
  return pair;
}

}  // namespace cable_variation
