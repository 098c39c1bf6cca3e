#include <cable_variation/envelope/envelope_verification.h>

#include <algorithm>
#include <atomic>
#include <limits>

#include <cable_variation/statistics/confidence.h>

namespace cable_variation {

ContainmentCheck::ContainmentCheck(const std::vector<PhaseSearch>& phases) : phases_(&phases) {
  pieces_.resize(phases.front().follower().reader().frames().size());
  for (const PhaseSearch& phase : phases) {
    for (const PhaseSearch::Cluster& cluster : phase.clusters()) {
      for (std::size_t frame = 0; frame < cluster.hulls.size(); ++frame) {
        for (std::size_t i = 0; i < cluster.hulls[frame].size(); ++i) {
          const ConvexHull& hull = cluster.hulls[frame][i].hull();
          Piece piece{&hull, hull.surface().vertices.front(), hull.surface().vertices.front(),
                      phase.pieceRadius(cluster, i)};
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
  double least = std::numeric_limits<double>::infinity();
  for (const PhaseSearch::Cluster& cluster : phase.clusters()) {
    const double extra = radius - phase.pieceRadius(cluster, stretch);
    const ConvexHull& hull = cluster.hulls[frame][stretch].hull();
    const double height = hull.height(point);
    if (height + extra >= least) continue;
    least = std::min(least, extra + (height <= 0.0 ? height : hull.closest(point).distance));
    if (least <= known) break;
  }
  return least;
}

// Out of the pieces of the rare cluster that the shape as a whole sticks out of least; infinite without one.
double ContainmentCheck::ofRare(const PhaseSearch& phase, const StretchShape& shape) {
  double least = std::numeric_limits<double>::infinity();
  for (const PhaseSearch::Cluster& cluster : phase.clusters()) {
    if (!PhaseSearch::isRare(cluster)) continue;
    double most = 0.0;
    for (std::size_t frame = 0; frame < cluster.hulls.size() && most < least; ++frame) {
      for (std::size_t i = 0; i < shape.radius.size(); ++i) {
        const double extra = shape.radius[i] - phase.pieceRadius(cluster, i);
        for (const Eigen::Vector3d& point : shape.centreline(frame, i))
          most = std::max(most, cluster.hulls[frame][i].hull().closest(point).distance + extra);
      }
    }
    least = std::min(least, most);
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
  // of many phases each has too few rare shapes to tell of others
  if (random.protrusion > 0.0 && phases_->size() == 1 && phase.isRare(shape, followed.jump.has_value())) {
    const double of_rare = ofRare(phase, shape);
    // far from all pieces of rare shapes it is not one of theirs
    constexpr double kOfTheirs = 3.0, kClose = 1e-4;
    if (of_rare <= kOfTheirs * random.protrusion + kClose) random.of_rare = of_rare;
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
    constexpr std::size_t kNowAndThen = 16;
    const std::size_t so_many = ++done;
    if (options.progress && (so_many % kNowAndThen == 0 || so_many == places.size()))
      options.progress(so_many);
  });
  return shapes;
}

void lookInBlocks(const std::vector<PhaseSearch>& phases, std::size_t count,
                  const std::function<SamplePlace(std::size_t)>& draw, const LookOptions& options,
                  const std::function<void(std::size_t, const std::vector<RandomShape>&)>& take) {
  constexpr std::size_t kBlock = 16384;
  for (std::size_t first = 0; first < count; first += kBlock) {
    std::vector<SamplePlace> places;
    for (std::size_t i = first; i < std::min(count, first + kBlock); ++i) places.push_back(draw(i));
    LookOptions of_block = options;
    if (options.progress) of_block.progress = [&](std::size_t done) { options.progress(first + done); };
    take(first, lookAt(phases, places, of_block));
  }
}

bool ContainmentCount::isOutside(const RandomShape& shape) const {
  constexpr double kNone = 1e-9;  // [m]
  return shape.converged && shape.protrusion > inflation_ + kNone;
}

void ContainmentCount::add(const std::vector<RandomShape>& shapes,
                           const std::vector<MaterialStretch>& stretches) {
  counted_.shapes += shapes.size();
  for (const RandomShape& shape : shapes) {
    if (!shape.converged) {
      ++counted_.failed;
      continue;
    }
    if (isOutside(shape)) ++counted_.outside;
    if (shape.protrusion <= most_) continue;
    most_ = shape.protrusion;
    counted_.largest_protrusion = std::max(0.0, shape.protrusion);
    counted_.deviations = shape.place.deviations;
    counted_.time = shape.place.time;
    counted_.cable = stretches[shape.stretch].cable;
    counted_.arc_length = stretches[shape.stretch].start;
  }
}

Containment ContainmentCount::result(bool failures_outside, double confidence) const {
  Containment containment = counted_;
  if (containment.outside > 0) containment.largest_excess = containment.largest_protrusion - inflation_;
  containment.outside_bound =
      failures_outside
          ? shareUpperBound(containment.outside + containment.failed, containment.shapes, confidence)
          : shareUpperBound(containment.outside, containment.shapes - containment.failed, confidence);
  return containment;
}

}  // namespace cable_variation
