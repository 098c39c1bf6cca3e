#pragma once  // internal to envelope/

#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include <cable_variation/envelope/envelope.h>
#include <cable_variation/envelope/search/place_solver.h>

namespace cable_variation {

/// One random shape looked at, and how far it sticks out of the hulls.
struct RandomShape {
  bool converged = false;
  std::size_t phase = 0;
  SamplePlace place;
  double protrusion = 0.0;  ///< [m]; at most 0: it does not stick out
  std::size_t stretch = 0;  ///< where it sticks out most
  Eigen::Matrix3Xd jump;    ///< FollowedShape::Jump::motion(), if it snapped; else empty
  /// Of a rare shape that sticks out (it snapped, or is on the way of a snap): how far out of the pieces of
  /// those rare shapes that it sticks out of least [m].
  std::optional<double> of_rare;
};

/// Tells how far shapes stick out of the pieces that the searches have found, before inflation.
class ContainmentCheck {
 public:
  /// The searches must outlive it, unchanged.
  explicit ContainmentCheck(const std::vector<PhaseSearch>& phases);

  /// @param place of the shape, and its phase
  RandomShape look(const SamplePlace& place, std::size_t phase, const FollowedShape& followed) const;

 private:
  struct Piece {
    const ConvexHull* hull;
    Eigen::Vector3d low, high;
    double radius;
  };
  static double ofRare(const PhaseSearch& phase, const StretchShape& shape);
  static double ownProtrusion(const PhaseSearch& phase, std::size_t frame, std::size_t stretch,
                              const Eigen::Vector3d& point, double radius, double known);
  double outside(const Eigen::Vector3d& point, double radius, std::size_t frame, double most) const;

  const std::vector<PhaseSearch>* phases_;
  std::vector<std::vector<Piece>> pieces_;  // per frame
};

struct LookOptions {
  SolvedWitness witness;                      ///< told of shapes that the envelope is to hold: of all, ...
  bool only_held = false;                     ///< ... or of those that stick out by no more than ...
  double inflation = 0.0;                     ///< ... this [m]
  std::function<void(std::size_t)> progress;  ///< told how many are done, by any thread; may throw
};

/// Solves places and looks how far their shapes stick out, in parallel.
std::vector<RandomShape> lookAt(const std::vector<PhaseSearch>& phases,
                                const std::vector<SamplePlace>& places, const LookOptions& options);

/// The same for any number of places, a block at a time, so that only those of a block are held.
/// @param draw of each number below `count`
/// @param take given the shapes of each block, and the number of the first
void lookInBlocks(const std::vector<PhaseSearch>& phases, std::size_t count,
                  const std::function<SamplePlace(std::size_t)>& draw, const LookOptions& options,
                  const std::function<void(std::size_t first, const std::vector<RandomShape>& shapes)>& take);

/// Counts what shapes tell of pieces that are rounded by an inflation [m].
class ContainmentCount {
 public:
  explicit ContainmentCount(double inflation) : inflation_(inflation) {}

  void add(const std::vector<RandomShape>& shapes, const std::vector<MaterialStretch>& stretches);
  /// Whether the shape is outside.
  bool isOutside(const RandomShape& shape) const;
  /// @param failures_outside whether those without an equilibrium count as outside
  /// @param confidence of the bound, one-sided
  Containment result(bool failures_outside, double confidence) const;

 private:
  double inflation_;
  double most_ = -std::numeric_limits<double>::infinity();
  Containment counted_;
};

}  // namespace cable_variation
