#include <cable_variation/variation/envelope_verification.h>

#include <algorithm>
#include <atomic>
#include <limits>

#include <cable_variation/variation/confidence.h>

namespace cable_variation {

ContainmentCheck::ContainmentCheck(const std::vector<PhaseSearch>& phases) : phases_(&phases) {
  pieces_.resize(phases.front().follower().reader().frames().size());
  for (const PhaseSearch& phase : phases) {
    for (const PhaseSearch::Cluster& cluster : phase.clusters()) {
      for (std::size_t frame = 0; frame < cluster.hulls.size(); ++frame) {
        for (std::size_t i = 0; i < cluster.hulls[frame].size(); ++i) {
          const ConvexHull& hull = cluster.hulls[frame][i].hull();
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
  for (const PhaseSearch::Cluster& cluster : phase.clusters()) {
    const ConvexHull& hull = cluster.hulls[frame][stretch].hull();
    const double height = hull.height(point);
    if (height + extra >= least) continue;
    least = std::min(least, extra + (height <= 0.0 ? height : hull.closest(point).distance));
    if (least <= known) break;
  }
  return least;
}

RandomShape ContainmentCheck::look(const SamplePlace& place, std::size_t phase_index,
                                   const FollowedShape& followed) const {
  RandomShape random;
  random.place = place;
  random.phase = phase_index;
  random.converged = followed.converged;
  if (!followed.converged) return random;
  if (followed.jump) random.jump = followed.jump->motion();
  const PhaseSearch& phase = (*phases_)[phase_index];
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

std::vector<RandomShape> lookAt(const std::vector<PhaseSearch>& phases,
                                const std::vector<SamplePlace>& places, const LookOptions& options) {
  const ContainmentCheck check(phases);
  const ToleranceSpace& tolerances = phases.front().follower().reader().space().tolerances();
  std::vector<RandomShape> shapes(places.size());
  std::atomic<std::size_t> done{0};
  solvePlaces(phases, places, [&](std::size_t index, std::size_t phase, const FollowedShape& followed) {
    RandomShape& shape = shapes[index];
    shape = check.look(places[index], phase, followed);
    if (!options.only_held) {
      tellOf(followed, tolerances, options.witness);
    } else if (options.witness && shape.converged && shape.protrusion <= options.inflation) {
      options.witness(shape.place, followed.harness, followed.equilibrium);
    }
    if (options.progress) options.progress(++done);
  });
  return shapes;
}

Containment containmentOf(const std::vector<RandomShape>& shapes,
                          const std::vector<MaterialStretch>& stretches, double inflation,
                          bool failures_outside, double confidence) {
  constexpr double kNone = 1e-9;  // [m]
  Containment containment;
  containment.shapes = shapes.size();
  double most = -std::numeric_limits<double>::infinity();
  for (const RandomShape& shape : shapes) {
    if (!shape.converged) {
      ++containment.failed;
      continue;
    }
    if (shape.protrusion > inflation + kNone) ++containment.outside;
    if (shape.protrusion <= most) continue;
    most = shape.protrusion;
    containment.largest_protrusion = std::max(0.0, shape.protrusion);
    containment.deviations = shape.place.deviations;
    containment.time = shape.place.time;
    containment.cable = stretches[shape.stretch].cable;
    containment.arc_length = stretches[shape.stretch].start;
  }
  if (containment.outside > 0) containment.largest_excess = containment.largest_protrusion - inflation;
  containment.outside_bound =
      failures_outside
          ? shareUpperBound(containment.outside + containment.failed, containment.shapes, confidence)
          : shareUpperBound(containment.outside, containment.shapes - containment.failed, confidence);
  return containment;
}

}  // namespace cable_variation
