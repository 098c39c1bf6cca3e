#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <cable_variation/tracking/stretch_shape.h>

namespace cable_variation {

/// A sample's shape, reached from the design's along a straight line of deviations and time.
struct FollowedShape {
  bool converged = false;
  std::string message;  ///< for a person, unless converged
  Harness harness;
  Equilibrium equilibrium;
  StretchShape shape;

  /// The cables jumped on the way; the last jump counts, of followClosely() the first.
  struct Jump {
    StretchShape before, after;
    Harness harness_before, harness_after;
    Equilibrium equilibrium_before, equilibrium_after;
    std::size_t stretch = 0;  ///< that moved most
    double distance = 0.0;    ///< by how much [m]

    /// Of the ends of all stretches, seen from the world [m].
    Eigen::Matrix3Xd motion() const { return after.ends[0] - before.ends[0]; }
  };
  std::optional<Jump> jump;

  /// Shapes on the way, if it jumped and rates were asked for: within the tolerances as the last one is, and
  /// of a kind that is hard to come by.
  struct OnTheWay {
    StretchShape shape;
    bool beyond = false;  ///< the last jump
  };
  std::vector<OnTheWay> on_the_way;
};

/// Told of a harness within the tolerances and its equilibrium, by any thread.
using SolvedWitness = std::function<void(const SamplePlace&, const Harness&, const Equilibrium&)>;
/// Tells of the shape and, if it jumped, of those on both sides of the jump that `tolerances` contain.
void tellOf(const FollowedShape& followed, const ToleranceSpace& tolerances, const SolvedWitness& witness);

/// Follows the shape of one phase's reference to samples around it. const: may be shared by threads.
class ShapeFollower {
 public:
  /// @param solver with the shape of the design at `reference_time`, to which `harness` and `equilibrium`
  /// belong
  ShapeFollower(const StretchReader& reader, EquilibriumSolver solver, const Harness& harness,
                const Equilibrium& equilibrium, double reference_time);

  const StretchShape& reference() const { return reference_; }
  const EquilibriumSolver& solver() const { return solver_; }  ///< has the reference's shape
  const StretchReader& reader() const { return *reader_; }
  double referenceTime() const { return reference_time_; }
  Eigen::VectorXd coordinates(const SamplePlace& place) const {
    return reader_->space().coordinates(place, reference_time_);
  }

  FollowedShape follow(const SamplePlace& place, bool with_rates) const;

  /// In steps so small that no jump of some hundredths of the cables' length goes unseen, wherever the way
  /// ends: what follow() tries first, one leap to the end, can land on another branch of equilibria near
  /// where the first-order response happens to point. A change that is steep, but goes back the way it came,
  /// is no jump.
  FollowedShape followClosely(const SamplePlace& place) const;

  /// As followClosely(), but in one leap where that is sure to be no jump: the responses at both ends of the
  /// way, and the shape in its middle, lie on one smooth path.
  FollowedShape followWatchfully(const SamplePlace& place) const;

  /// How far the shape is expected to move, at most, to first order, as a share of the longest cable [1].
  double expectedMotion(const SamplePlace& place) const;

 private:
  enum class Pace { usual, close };
  FollowedShape followInSteps(const SamplePlace& place, bool with_rates, Pace pace) const;
  double closeStep(const StretchShape& here, const SamplePlace& from, const SamplePlace& end,
                   double left) const;
  bool isSmoothTo(const StretchShape& there, const EquilibriumSolver& solver) const;
  bool goesBack(const StretchShape& here, const SamplePlace& from, EquilibriumSolver ahead) const;
  void keepOnTheWay(const StretchShape& shape, FollowedShape& followed) const;

  const StretchReader* reader_;
  EquilibriumSolver solver_;
  double reference_time_;
  StretchShape reference_;
  double length_ = 0.0;  ///< of the longest cable [m]
};

}  // namespace cable_variation
