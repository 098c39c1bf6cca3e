#include <cable_variation/variation/envelope_verification.h>

#include <algorithm>
#include <limits>

namespace cable_variation {

SamplePlace drawPlace(const SampleSpace& space, double from, double to, const CounterRandom& random,
                      std::uint64_t index) {
  RandomRow numbers(random, index);
  SamplePlace place;
  place.time = from + numbers.uniform() * (to - from);
  place.deviations =
      index % 2 == 0 ? space.tolerances().random(numbers) : space.tolerances().randomNearLimits(numbers);
  return place;
}

std::size_t phaseAt(const std::vector<PhaseSearch>& phases, double time) {
  const auto after = std::find_if(phases.begin(), phases.end(),
                                  [&](const PhaseSearch& phase) { return time <= phase.times().back(); });
  return after == phases.end() ? phases.size() - 1 : static_cast<std::size_t>(after - phases.begin());
}

ContainmentCheck::ContainmentCheck(const std::vector<PhaseSearch>& phases) : phases_(&phases) {
  pieces_.resize(phases.front().follower().reader().frames().size());
  for (const PhaseSearch& phase : phases) {
    for (const PhaseSearch::Branch& branch : phase.branches()) {
      for (std::size_t frame = 0; frame < branch.hulls.size(); ++frame) {
        for (std::size_t i = 0; i < branch.hulls[frame].size(); ++i) {
          const ConvexHull& hull = branch.hulls[frame][i].hull();
          Piece piece{&hull, hull.surface().vertices.front(), hull.surface().vertices.front(),
                      phase.radius()[i]};
          for (const Eigen::Vector3d& vertex : hull.surface().vertices) {
            piece.low = piece.low.cwiseMin(vertex);
            piece.high = piece.high.cwiseMax(vertex);
          }
          pieces_[frame].push_back(piece);
        }
      }
    }
  }
}

// The distance of the sphere's surface from the union of all pieces, no more than `most`.
double ContainmentCheck::outside(const Eigen::Vector3d& point, double radius, std::size_t frame,
                                 double most) const {
  double least = most;
  for (const Piece& piece : pieces_[frame]) {
    const double extra = radius - piece.radius;
    const double to_box = (piece.low - point).cwiseMax(point - piece.high).cwiseMax(0.0).norm();
    if (to_box + extra >= least || piece.hull->height(point) + extra >= least) continue;
    least = std::min(least, piece.hull->closest(point).distance + extra);
    if (least <= 0.0) break;
  }
  return least;
}

// How far the sphere sticks out of the stretch's own pieces; `known` or less is as good as `known`.
double ContainmentCheck::ownProtrusion(const PhaseSearch& phase, std::size_t frame, std::size_t stretch,
                                       const Eigen::Vector3d& point, double radius, double known) {
  const double extra = radius - phase.radius()[stretch];
  double least = std::numeric_limits<double>::infinity();
  for (const PhaseSearch::Branch& branch : phase.branches()) {
    const ConvexHull& hull = branch.hulls[frame][stretch].hull();
    const double height = hull.height(point);
    if (height + extra >= least) continue;
    least = std::min(least, extra + (height <= 0.0 ? height : hull.closest(point).distance));
    if (least <= known) break;
  }
  return least;
}

RandomShape ContainmentCheck::look(const SamplePlace& place) const {
  RandomShape random;
  random.place = place;
  random.phase = phaseAt(*phases_, place.time);
  const PhaseSearch& phase = (*phases_)[random.phase];
  const FollowedShape followed = phase.follower().follow(place, false);
  random.converged = followed.converged;
  if (!followed.converged) return random;
  random.protrusion = -std::numeric_limits<double>::infinity();
  const StretchShape& shape = followed.shape;
  for (std::size_t frame = 0; frame < pieces_.size(); ++frame) {
    for (std::size_t i = 0; i < shape.radius.size(); ++i) {
      for (const Eigen::Vector3d& point : shape.centreline(frame, i)) {
        double protrusion = ownProtrusion(phase, frame, i, point, shape.radius[i], random.protrusion);
        if (protrusion <= random.protrusion) continue;
        if (protrusion > 0.0) protrusion = outside(point, shape.radius[i], frame, protrusion);
        if (protrusion <= random.protrusion) continue;
        random.protrusion = protrusion;
        random.stretch = i;
      }
    }
  }
  return random;
}

}  // namespace cable_variation
