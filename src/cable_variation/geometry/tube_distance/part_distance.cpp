#include <cable_variation/geometry/tube_distance/distance.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <cable_variation/geometry/tube_distance/closest_cells.h>
#include <cable_variation/geometry/tube_distance/depth.h>
#include <cable_variation/geometry/tube_distance/distance_part.h>
#include <cable_variation/geometry/tube_distance/part_vicinity.h>
#include <cable_variation/geometry/tube_distance/section_minimum.h>
#include <cable_variation/geometry/tube_distance/tube_section.h>

namespace cable_variation {
namespace {

using Part = DistancePart::Impl;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kTouching = 2e-9;  // the centreline meets the surface: twice a minimum's error [m]

// A section's closest place to a triangle of the tree.
struct Cell {
  std::size_t section = 0;
  std::uint32_t triangle = 0;
  SectionMinimum at;
};

// Walks the cable's tree and one of triangles, nearest boxes first.
class Walk {
 public:
  /// @param places of the tree's triangles in the part's own; null: it is the part's own
  /// @param limit of the values that are looked for
  Walk(const std::vector<TubeSection>& sections, const SectionTree& cable, const TriangleTree& tree,
       const std::vector<std::uint32_t>* places, double limit, double margin)
      : sections_(sections), cable_(cable), tree_(tree), places_(places), best_(limit), margin_(margin) {}

  // The cells within the margin of the smallest, that one first.
  std::vector<Cell> run() {
    struct Pair {
      double squared;
      std::uint32_t cable, part;
    };
    std::vector<Pair> open;
    open.reserve(256);
    const auto add = [&](std::uint32_t cable, std::uint32_t part) {
      open.push_back({squaredGap(cable_.nodes[cable].box, tree_.nodes[part].box), cable, part});
    };
    add(0, 0);
    while (!open.empty()) {
      const Pair pair = open.back();
      open.pop_back();
      const SectionTree::Node& cable = cable_.nodes[pair.cable];
      const TriangleTree::Node& part = tree_.nodes[pair.part];
      const double reach = best_ + margin_ + cable.largest_radius;
      if (reach <= 0.0 || pair.squared >= reach * reach) continue;
      const bool cable_leaf = cable.count == 1, part_leaf = part.count > 0;
      if (cable_leaf && part_leaf) {
        for (std::uint32_t i = part.first; i < part.first + part.count; ++i) evaluate(cable.first, i);
        continue;
      }
      if (part_leaf && !anyWithin(part, cable.box, reach)) continue;
      const std::size_t before = open.size();
      if (part_leaf || (!cable_leaf && cable.box.largestExtent() > part.box.largestExtent())) {
        add(static_cast<std::uint32_t>(cable.left), pair.part);
        add(static_cast<std::uint32_t>(cable.right), pair.part);
      } else {
        add(pair.cable, part.first);
        add(pair.cable, part.first + 1);
      }
      if (open[before].squared < open[before + 1].squared) std::swap(open[before], open[before + 1]);
    }
    return closestFirst(std::move(cells_), best_ + margin_);
  }

 private:
  // Whether a triangle of the leaf may be within `reach` of the box, as its plane tells: the box of a large
  // triangle that lies askew holds much that the triangle is far from.
  bool anyWithin(const TriangleTree::Node& leaf, const Box& box, double reach) const {
    const Eigen::Vector3d centre = 0.5 * (box.low + box.high).matrix();
    const Eigen::Vector3d half = 0.5 * (box.high - box.low).matrix();
    for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
      const SurfaceTriangle& triangle = tree_.triangles[i];
      const double height = std::abs(triangle.normal.dot(centre - triangle.corners[0]));
      if (height < reach + triangle.normal.cwiseAbs().dot(half)) return true;
    }
    return false;
  }

  void evaluate(std::size_t section, std::uint32_t triangle) {
    const auto minimum = smallest(sections_[section], tree_.triangles[triangle], best_ + margin_);
    if (!minimum) return;
    best_ = std::min(best_, minimum->value);
    cells_.push_back({section, places_ == nullptr ? triangle : (*places_)[triangle], *minimum});
  }

  const std::vector<TubeSection>& sections_;
  const SectionTree& cable_;
  const TriangleTree& tree_;
  const std::vector<std::uint32_t>* places_;
  double best_, margin_;
  std::vector<Cell> cells_;
};

// Neither the place on the cable nor the point on the part can be moved to come closer.
bool isLocalMinimum(const std::vector<TubeSection>& sections, const Part& part, const Cell& cell) {
  const TubeSection& section = sections[cell.section];
  const NearestPoint& nearest = cell.at.nearest;
  const auto descends = [&](const TubeSection& next, double u, double sense) {
    const Eigen::Vector3d first = next.derivatives(u).first;
    const double slope = nearest.direction.dot(first) - (next.end_radius - next.start_radius);
    return sense * slope < -1e-9 * first.norm();
  };
  const double u = cell.at.u;
  if ((u < 1.0 && descends(section, u, 1.0)) || (u > 0.0 && descends(section, u, -1.0))) return false;
  if (u == 1.0 && section.continued && descends(sections[cell.section + 1], 0.0, 1.0)) return false;
  if (u == 0.0 && cell.section > 0 && sections[cell.section - 1].continued &&
      descends(sections[cell.section - 1], 1.0, -1.0)) {
    return false;
  }
  return isLocallyNearest(part.tree, section.position(cell.at.u), nearest);
}

double runnerUp(const Centreline& cable, const std::vector<TubeSection>& sections, const Part& part,
                const std::vector<Cell>& cells, double margin) {
  const Cell& best = cells.front();
  const Centreline::Place place = sections[best.section].place(best.at.u);
  const double arc_length = cable.arcLength(place), apart = 2.0 * cable.radius(place);
  const auto elsewhere = [&](const Cell& cell) {
    return std::abs(cable.arcLength(sections[cell.section].place(cell.at.u)) - arc_length) > apart ||
           (cell.at.nearest.direction - best.at.nearest.direction).norm() > kOtherDirection;
  };
  const double largest = best.at.value + margin;
  double smallest = kInfinity;
  for (const Cell& cell : cells) {
    if (cell.at.value >= smallest) break;
    const TubeSection& section = sections[cell.section];
    const SurfaceTriangle& triangle = part.tree.triangles[cell.triangle];
    // an arch over a face comes down at both ends
    for (const SectionMinimum& at :
         {cell.at, valueAt(section, triangle, 0.0), valueAt(section, triangle, 1.0)}) {
      const Cell here{cell.section, cell.triangle, at};
      if (at.value < smallest && at.value <= largest && elsewhere(here) &&
          isLocalMinimum(sections, part, here))
        smallest = at.value;
    }
  }
  return std::max(smallest, best.at.value);
}

std::optional<std::size_t> sectionAt(const std::vector<TubeSection>& sections,
                                     const Centreline::Place& place) {
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const TubeSection& section = sections[i];
    if (section.piece == place.piece && section.t_start <= place.t && place.t <= section.t_end) return i;
  }
  return std::nullopt;
}

// The solids that the centreline touches or pierces.
std::vector<std::uint32_t> solidsTouched(const Part& part, std::vector<TubeSection> sections, bool& touches) {
  for (TubeSection& section : sections) section.start_radius = section.end_radius = 0.0;
  const SectionTree tree(sections);
  std::vector<std::uint32_t> solids;
  for (const Cell& cell : Walk(sections, tree, part.tree, nullptr, kTouching, kTouching).run()) {
    if (cell.at.value > kTouching) continue;
    touches = true;
    solids.push_back(part.solidOfTriangle(cell.triangle));
  }
  return solids;
}

// Whether the centreline crosses a rim that has no facet beyond it.
bool crossesCaps(const Part& part, std::vector<TubeSection> sections) {
  if (!part.caps) return false;
  for (TubeSection& section : sections) section.start_radius = section.end_radius = 0.0;
  return !Walk(sections, SectionTree(sections), *part.caps, nullptr, 0.0, kTouching).run().empty();
}

// The solids that hold one of the unbroken stretches wholly, and those that are touched.
std::vector<std::uint32_t> solidsEntered(const Part& part, const std::vector<TubeSection>& sections,
                                         double value, bool& touches) {
  std::vector<std::uint32_t> solids;
  if (value < 0.0) solids = solidsTouched(part, sections, touches);
  if (crossesCaps(part, sections)) solids.push_back(part.openSolid());
  for (std::size_t first = 0, last; first < sections.size(); first = last + 1) {
    for (last = first; sections[last].continued;) ++last;
    for (const std::uint32_t solid : part.solidsAround(sections[(first + last) / 2].middle)) {
      solids.push_back(solid);
    }
  }
  std::sort(solids.begin(), solids.end());
  solids.erase(std::unique(solids.begin(), solids.end()), solids.end());
  if (!solids.empty() && solids.back() == Solids::kNone) solids.pop_back();
  return solids;
}

// The value at the hint's section and triangle: none is larger that matters.
double knownValue(const std::vector<TubeSection>& sections, const Part& part, const ClosestPair* near) {
  if (near == nullptr || near->triangle >= part.place_in_tree.size()) return kInfinity;
  const auto section = sectionAt(sections, near->place);
  if (!section) return kInfinity;
  const SurfaceTriangle& triangle = part.tree.triangles[part.place_in_tree[near->triangle]];
  const auto minimum = smallest(sections[*section], triangle, kInfinity);
  return minimum ? minimum->value : kInfinity;
}

// The cells within the margin of the smallest, that one first; none beyond the search's limit.
std::vector<Cell> closestCells(const Centreline& cable, const std::vector<TubeSection>& sections,
                               const Part& part, const Pose& pose, double margin,
                               const DistanceSearch& search) {
  // Not below 0: a cable that pierces may be deeper than its surface tells. And a little more than what is
  // known, which is to be found again.
  const double limit =
      std::min(std::max(search.limit, 0.0), knownValue(sections, part, search.near) + kTouching);
  const PartVicinity* vicinity = search.vicinity;
  if (vicinity != nullptr && limit + margin < vicinity->completeWithin(cable, pose)) {
    if (!vicinity->tree()) return {};
    return Walk(sections, SectionTree(sections), *vicinity->tree(), &vicinity->places(), limit, margin).run();
  }
  return Walk(sections, SectionTree(sections), part.tree, nullptr, limit, margin).run();
}

// Nothing of the part was near the cable, and is not now either.
bool nothingWithin(const Centreline& cable, const Pose& pose, double margin, const DistanceSearch& search) {
  const PartVicinity* vicinity = search.vicinity;
  if (vicinity == nullptr || vicinity->tree() || !vicinity->outside() || cable.pieces.empty()) return false;
  return std::max(search.limit, 0.0) + margin < vicinity->completeWithin(cable, pose);
}

ClosestPair inWorld(const Pose& pose, const TubeSection& section, double u, const NearestPoint& nearest,
                    std::uint32_t triangle) {
  const Eigen::Matrix3d turn = pose.orientation.normalized().toRotationMatrix();
  ClosestPair pair;
  pair.place = section.place(u);
  pair.on_cable = pose.position + turn * section.position(u);
  pair.on_other = pose.position + turn * nearest.point;
  pair.direction = turn * nearest.direction;
  pair.triangle = triangle;
  return pair;
}

}  // namespace

std::optional<ClosestPair> distance(const Centreline& cable, const DistancePart& part, const Pose& pose,
                                    const std::vector<SkippedStretch>& skipped, double margin,
                                    const DistanceSearch& search) {
  if (!(std::isfinite(margin) && margin >= 0.0)) {
    throw std::invalid_argument("distance: margin " + std::to_string(margin) +
                                " m, expected a finite one of at least 0");
  }
  if (!(pose.position.allFinite() && pose.orientation.coeffs().allFinite() &&
        pose.orientation.norm() > 0.0)) {
    throw std::invalid_argument("distance: the part's pose is not finite");
  }
  if (nothingWithin(cable, pose, margin, search)) return std::nullopt;
  const Part& impl = part.impl();
  const std::vector<TubeSection> sections = sectionsOf(cable, pose, skipped);
  if (sections.empty()) return std::nullopt;
  const std::vector<Cell> cells = closestCells(cable, sections, impl, pose, margin, search);
  bool touches = false;
  const std::vector<std::uint32_t> solids =
      solidsEntered(impl, sections, cells.empty() ? 0.0 : cells.front().at.value, touches);

  std::optional<Deepest> deep;
  std::optional<Part::Winding> undecided;
  for (const std::uint32_t solid : solids) {
    std::optional<Deepest> in = deepest(impl, solid, sections, margin);
    if (!in) continue;
    if (solid == impl.openSolid() && !in->winding.clear) {
      undecided = in->winding;
      continue;
    }
    if (deep) {
      Deepest& other = in->value < deep->value ? *deep : *in;
      Deepest& first = in->value < deep->value ? *in : *deep;
      if (other.value <= first.value + margin) first.runner_up = std::min(first.runner_up, other.value);
      deep = first;
    } else {
      deep = in;
    }
  }
  const auto tell = [&](ClosestPair& pair, const Part::Winding& winding) {
    if (!impl.isOpen()) return;
    const Part::Winding& said = undecided ? *undecided : winding;
    pair.winding = said.number;
    pair.side = said.clear ? ClosestPair::Side::wound : ClosestPair::Side::undecided;
  };
  if (deep) {
    ClosestPair pair = inWorld(pose, sections[deep->section], deep->u, deep->nearest.at,
                               impl.sourceOf(deep->nearest.triangle));
    pair.distance = deep->value;
    pair.direction = -pair.direction;
    pair.contact = ClosestPair::Contact::pierced;
    pair.is_depth = true;
    pair.runner_up = deep->runner_up;
    tell(pair, deep->winding);
    return pair;
  }
  if (cells.empty()) return std::nullopt;
  const Cell& best = cells.front();
  ClosestPair pair =
      inWorld(pose, sections[best.section], best.at.u, best.at.nearest, impl.tree.number[best.triangle]);
  pair.distance = best.at.value;
  pair.contact = touches               ? ClosestPair::Contact::pierced
                 : pair.distance < 0.0 ? ClosestPair::Contact::overlap
                                       : ClosestPair::Contact::clear;
  pair.runner_up = runnerUp(cable, sections, impl, cells, margin);
  if (impl.isOpen()) tell(pair, impl.winding(sections[best.section].position(best.at.u)));
  return pair;
}

}  // namespace cable_variation
