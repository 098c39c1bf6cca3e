// How far cables may move without passing through a part.
#include <algorithm>
#include <cmath>

#include <cable_variation/equilibrium/discretisation/contact_system.h>
#include <cable_variation/equilibrium/discretisation/rod_system.h>

namespace cable_variation {

using Eigen::Vector3d;
using element::kNodes;

namespace {

// Of the tube's radius: places looked at are no further apart, the centreline between two comes no nearer to
// the surface than the difference of floor and half of that, and within the last of these it is as good as
// through.
constexpr double kApart = 0.4, kFloor = 0.6, kThrough = 0.2;
// How much longer a piece of the curve may be than the undeformed one.
constexpr double kStretched = 1.2;

std::vector<Vector3d> inFrame(const Pose& pose, const std::vector<Vector3d>& positions) {
  const Pose into = pose.inverse();
  std::vector<Vector3d> result;
  result.reserve(positions.size());
  for (const Vector3d& x : positions) result.push_back(into * x);
  return result;
}

// How far a point is from a surface, as it goes along: what is known of the place before bounds the next.
class DistanceAlong {
 public:
  /// @param sight what is further away counts as that far [m]
  DistanceAlong(const ContactSurface& surface, double sight) : surface_(surface), sight_(sight) {}

  /// Not more than the distance there [m].
  double atLeast(const Vector3d& x) const { return known_ - (x - seen_).norm(); }
  double operator()(const Vector3d& x) {
    constexpr double kMore = 1e-9;  // of rounding
    const double most = is_exact_ ? (1.0 + kMore) * (known_ + (x - seen_).norm()) : sight_;
    known_ = surface_.distance(x, std::min(sight_, most));
    is_exact_ = known_ < sight_;
    seen_ = x;
    return known_;
  }

 private:
  const ContactSurface& surface_;
  double sight_;
  double known_ = -INFINITY;
  bool is_exact_ = false;
  Vector3d seen_ = Vector3d::Zero();
};

}  // namespace

// A place as the way looks at it.
struct ContactSystem::OnTheWay {
  std::size_t element = 0;
  std::array<double, kNodes> weight{};
  double reach = 0.0;

  Vector3d of(const std::vector<Vector3d>& nodes) const {
    Vector3d x = Vector3d::Zero();
    for (std::size_t a = 0; a < kNodes; ++a) x += weight[a] * nodes[3 * element + a];
    return x;
  }
};

ContactSystem::OnTheWay ContactSystem::onTheWay(std::size_t index, std::size_t contact, double share) const {
  const std::vector<double>& grid = spans_[index].grid;
  const Span& span = topology_.spans[index];
  OnTheWay place;
  place.element =
      static_cast<std::size_t>(std::upper_bound(grid.begin() + 1, grid.end() - 1, share) - grid.begin()) - 1;
  const double start = grid[place.element], end = grid[place.element + 1];
  const double at = std::clamp((share - start) / (end - start), 0.0, 1.0);
  for (std::size_t a = 0; a < kNodes; ++a) {
    place.weight[a] = 1.0;
    for (std::size_t b = 0; b < kNodes; ++b) {
      if (b != a) place.weight[a] *= (at - element::kNodeAt[b]) / (element::kNodeAt[a] - element::kNodeAt[b]);
    }
  }
  const double left = topology_.stations[span.left].arc_length;
  const double length = topology_.stations[span.right].arc_length - left;
  place.reach = profiles_[span.cable].at(left + share * length).radius + harness_.contacts[contact].stand_off;
  return place;
}

double ContactSystem::freeShare(std::size_t index, std::size_t contact, const Configuration& at,
                                const std::vector<Vector3d>& from, const std::vector<Vector3d>& to,
                                double most) const {
  const PartContact& of = harness_.contacts[contact];
  const std::vector<CableStretch> stretches = skipped(of, at);
  double furthest = 0.0;
  for (std::size_t n = 0; n < from.size(); ++n) furthest = std::max(furthest, (to[n] - from[n]).norm());
  furthest *= kStretched;  // between nodes a cubic goes a little further
  const double length = kStretched * (arcLength(index, 1.0, at) - arcLength(index, 0.0, at));
  DistanceAlong distance_along(*of.surface, furthest + 10.0 * onTheWay(index, contact, 0.0).reach);
  double share = 0.0;
  while (share <= 1.0) {
    const OnTheWay place = onTheWay(index, contact, std::min(share, 1.0));
    double next = kApart * place.reach;
    const Vector3d x = place.of(from);
    const Vector3d way = place.of(to) - x;
    const double way_length = way.norm();
    const bool free = distance_along.atLeast(x) - kFloor * place.reach >= most * way_length;
    if (!free && counts(stretches, arcLength(index, share, at))) {
      double distance = distance_along(x);
      next = std::max(next, distance - furthest - kFloor * place.reach);
      const double floor = std::min(kFloor * place.reach, 0.9 * distance);
      DistanceAlong ahead = distance_along;
      // conservative advancement: as far as the distance allows, from there again
      constexpr int kSteps = 200;
      constexpr double kStuck = 1e-3;
      double gone = 0.0;
      for (int step = 0; step < kSteps && gone < most; ++step) {
        const double room = distance - floor;
        if (room >= (most - gone) * way_length) {
          gone = most;
          break;
        }
        gone += std::max(room, 0.0) / way_length;
        if (room < kStuck * place.reach) break;
        distance = ahead(x + gone * way);
      }
      most = std::min(most, gone);
    }
    if (share >= 1.0) break;
    share = std::min(1.0, share + next / length);
  }
  return most;
}

std::array<double, 2> ContactSystem::energyAlong(const NodalField& motion) const {
  std::array<double, 2> energy{};
  for (const Pressing& at : pressing_) {
    double opened = 0.0;
    for (std::size_t a = 0; a < kNodes; ++a) {
      const auto node = static_cast<Eigen::Index>(3 * at.element + a);
      opened += at.weight[a] * at.direction.dot(motion.spans[at.span].col(node).head<3>());
    }
    energy[0] -= at.force * opened;
    energy[1] += 0.5 * at.stiffness * opened * opened;
  }
  return energy;
}

// By the gaps of the last evaluation: none is closed by much, places are near each other, and the way is
// short.
bool ContactSystem::isShort(std::size_t index, const NodalField& motion) const {
  constexpr double kShort = 0.1, kNear = 0.5;  // of a reach
  const SpanPlaces& span = spans_[index];
  double smallest = INFINITY;
  for (const std::size_t c : span.contacts)
    for (const Place& place : span.places) smallest = std::min(smallest, reach(c, place));
  if (worst_gap_ > kShort * smallest) return false;
  const auto& nodes = motion.spans[index];
  if (kStretched * nodes.topRows<3>().colwise().norm().maxCoeff() > kShort * smallest) return false;
  const Span& of = topology_.spans[index];
  const double length = topology_.stations[of.right].arc_length - topology_.stations[of.left].arc_length;
  for (std::size_t i = 1; i < span.places.size(); ++i) {
    const double apart = kStretched * length * (span.places[i].share - span.places[i - 1].share);
    if (apart > kNear * kStretched * smallest) return false;
  }
  return true;
}

double ContactSystem::freeShare(const Configuration& configuration, const NodalField& motion) const {
  double most = 1.0;
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    if (spans_[i].contacts.empty() || isShort(i, motion)) continue;
    for (const std::size_t c : spans_[i].contacts) {
      const Pose& pose = harness_.contacts[c].pose;
      const std::vector<Vector3d> from = inFrame(pose, configuration.spans[i].positions);
      std::vector<Vector3d> to = configuration.spans[i].positions;
      for (std::size_t n = 0; n < to.size(); ++n)
        to[n] += motion.spans[i].col(static_cast<Eigen::Index>(n)).head<3>();
      most = freeShare(i, c, configuration, from, inFrame(pose, to), most);
    }
  }
  return most;
}

bool ContactSystem::isFree(const std::vector<PartContact>& before, const Configuration& from,
                           const Configuration& to) const {
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    for (const std::size_t c : spans_[i].contacts) {
      const std::vector<Vector3d> start = inFrame(before[c].pose, from.spans[i].positions);
      const std::vector<Vector3d> end = inFrame(harness_.contacts[c].pose, to.spans[i].positions);
      if (freeShare(i, c, to, start, end, 1.0) < 1.0) return false;
    }
  }
  return true;
}

std::optional<std::size_t> ContactSystem::crossed(const Configuration& configuration) const {
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    for (const std::size_t c : spans_[i].contacts) {
      const PartContact& of = harness_.contacts[c];
      const std::vector<CableStretch> stretches = skipped(of, configuration);
      const std::vector<Vector3d> nodes = inFrame(of.pose, configuration.spans[i].positions);
      const double length =
          kStretched * (arcLength(i, 1.0, configuration) - arcLength(i, 0.0, configuration));
      DistanceAlong distance_along(*of.surface, 20.0 * onTheWay(i, c, 0.0).reach);
      double share = 0.0;
      while (share <= 1.0) {
        const OnTheWay place = onTheWay(i, c, share);
        double next = kApart * place.reach;
        if (counts(stretches, arcLength(i, share, configuration))) {
          const double distance = distance_along(place.of(nodes));
          if (distance < kThrough * place.reach) return c;
          next = std::max(next, distance - kThrough * place.reach);
        }
        if (share >= 1.0) break;
        share = std::min(1.0, share + next / length);
      }
    }
  }
  return std::nullopt;
}

}  // namespace cable_variation
