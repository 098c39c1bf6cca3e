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

Vector3d pointOf(const std::vector<Vector3d>& nodes, std::size_t element,
                 const std::array<double, kNodes>& weights) {
  Vector3d x = Vector3d::Zero();
  for (std::size_t a = 0; a < kNodes; ++a) x += weights[a] * nodes[3 * element + a];
  return x;
}

std::vector<Vector3d> inFrame(const Pose& pose, const std::vector<Vector3d>& positions) {
  const Pose into = pose.inverse();
  std::vector<Vector3d> result;
  result.reserve(positions.size());
  for (const Vector3d& x : positions) result.push_back(into * x);
  return result;
}

}  // namespace

double ContactSystem::freeShare(std::size_t index, std::size_t contact, const Configuration& at,
                                const std::vector<Vector3d>& from, const std::vector<Vector3d>& to,
                                double most) const {
  const PartContact& of = harness_.contacts[contact];
  const std::vector<CableStretch> stretches = skipped(of, at);
  double furthest = 0.0;
  for (std::size_t n = 0; n < from.size(); ++n) furthest = std::max(furthest, (to[n] - from[n]).norm());
  furthest *= kStretched;  // between nodes a cubic goes a little further
  const double length = kStretched * (arcLength(index, 1.0, at) - arcLength(index, 0.0, at));
  double share = 0.0;
  while (share <= 1.0) {
    const Place place = makePlace(index, std::min(share, 1.0), false);
    const double reach = this->reach(contact, place);
    double next = kApart * reach;
    if (counts(stretches, arcLength(index, place.share, at))) {
      const Vector3d x = pointOf(from, place.element, place.weight);
      const Vector3d way = pointOf(to, place.element, place.weight) - x;
      const double sight = furthest + 10.0 * reach;
      double distance = of.surface->distance(x, sight);
      next = std::max(next, distance - furthest - kFloor * reach);
      const double floor = std::min(kFloor * reach, 0.9 * distance), way_length = way.norm();
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
        if (room < kStuck * reach) break;
        distance = of.surface->distance(x + gone * way, sight);
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
      double share = 0.0;
      while (share <= 1.0) {
        const Place place = makePlace(i, share, false);
        const double reach = this->reach(c, place);
        double next = kApart * reach;
        if (counts(stretches, arcLength(i, share, configuration))) {
          const double distance =
              of.surface->distance(pointOf(nodes, place.element, place.weight), 20.0 * reach);
          if (distance < kThrough * reach) return c;
          next = std::max(next, distance - kThrough * reach);
        }
        if (share >= 1.0) break;
        share = std::min(1.0, share + next / length);
      }
    }
  }
  return std::nullopt;
}

}  // namespace cable_variation
