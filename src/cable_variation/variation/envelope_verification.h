#pragma once

#include <cstdint>
#include <vector>

#include <cable_variation/variation/envelope.h>
#include <cable_variation/variation/phase_search.h>

namespace cable_variation {

/// One random shape looked at, and how far it sticks out of the hulls.
struct RandomShape {
  bool converged = false;
  std::size_t phase = 0;
  SamplePlace place;
  double protrusion = 0.0;  ///< [m]; at most 0: it does not stick out
  std::size_t stretch = 0;  ///< where it sticks out most
};

/// Draws shape number `index` of a sequence: a time evenly over the motion, and deviations evenly within the
/// tolerances (even numbers) or spread over their limits (odd).
SamplePlace drawPlace(const SampleSpace& space, double from, double to, const CounterRandom& random,
                      std::uint64_t index);

/// Index of the phase that a time of the motions [s] belongs to.
std::size_t phaseAt(const std::vector<PhaseSearch>& phases, double time);

/// Tells how far shapes stick out of the pieces that the searches have found.
class ContainmentCheck {
 public:
  /// The searches must outlive it, unchanged.
  explicit ContainmentCheck(const std::vector<PhaseSearch>& phases);

  RandomShape look(const SamplePlace& place) const;

 private:
  struct Piece {
    const ConvexHull* hull;
    Eigen::Vector3d low, high;
    double radius;
  };
  static double ownProtrusion(const PhaseSearch& phase, std::size_t frame, std::size_t stretch,
                              const Eigen::Vector3d& point, double radius, double known);
  double outside(const Eigen::Vector3d& point, double radius, std::size_t frame, double most) const;

  const std::vector<PhaseSearch>* phases_;
  std::vector<std::vector<Piece>> pieces_;  // per frame
};

}  // namespace cable_variation
