#pragma once  // internal to equilibrium/

#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include <cable_variation/equilibrium/discretisation/contact_result.h>
#include <cable_variation/equilibrium/discretisation/contact_system.h>
#include <cable_variation/equilibrium/discretisation/discretisation.h>
#include <cable_variation/equilibrium/discretisation/problem.h>
#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/equilibrium/search/minimise.h>

namespace cable_variation {

/// One branch of equilibria of a harness: a shape on a grid, brought to rest, refined, and followed to other
/// harnesses of the same structure. What the steps cost and find is put down in an Equilibrium.
class Branch {
 public:
  /// On the start grid, without a shape. Throws std::invalid_argument (makeTopology()).
  Branch(const Harness& harness, const EquilibriumOptions& options);
  /// A copy has the shape of the original to follow and goes its own way from there.
  Branch(const Branch& other);
  Branch& operator=(const Branch&) = delete;

  Problem& problem() { return problem_; }
  const Problem& problem() const { return problem_; }
  /// Of the calls from now on.
  void setOptions(const EquilibriumOptions& options) { options_ = options; }
  /// The shape at hand is merely stationary.
  bool unstable() const { return unstable_; }
  void setUnstable(bool unstable) { unstable_ = unstable; }

  /// Without its dead moments, from here on.
  void dropMoments();
  /// From the configuration on the start grid, wherever it is, to a minimum near by with softened stretch
  /// where the cables are slender, else with their own.
  bool letGo(Equilibrium& result);
  /// From a minimum on the start grid with softened stretch (RodSystem::soften()) to one of the cable's own.
  bool tighten(Equilibrium& result);
  /// Dead moments without a potential leave no energy to descend: the shape without them is followed while
  /// they grow to those of `harness`, and is stable as long as it passes no singular point. Else says in the
  /// result what happened.
  bool growMoments(const Harness& harness, Equilibrium& result);
  /// Refines until the estimated errors are below the accuracies asked for, of forces and directions as far
  /// as rounding lets it. The system ends with its gradient at the configuration, and the result with the
  /// shapes there.
  bool adaptGrid(Equilibrium& result);
  /// To the shape of `harness`, which differs from the one at hand in numbers only; it has been checked that
  /// `topology` is alike. False: the branch ends on the way.
  bool follow(const Harness& harness, const Topology& topology, Equilibrium& result);
  /// What parts press in one point moves along the cable from now on, as it does when the shape changes
  /// (ContactSystem::letPointsMove()); the shape is brought to rest with it, on the same grid, and gaps
  /// closed to a thousandth of kGapTolerance if all that press move. Where it finds no rest all stays as it
  /// was. For a copy that is looked at, not followed.
  void letPointsMove();
  /// Completes the result: reactions, energies, the smallest eigenvalue, and whether the shape is one that a
  /// cable can take.
  void finish(Equilibrium& result);

 private:
  bool descend(bool settle, StartStress stress, Equilibrium& result,
               int most_iterations = std::numeric_limits<int>::max());
  bool descendInContact(bool settle, StartStress stress, int iterations, Equilibrium& result);
  bool isClear(const Equilibrium& result);
  ExactGap exactGapOf(const std::vector<CableShape>& shapes);
  bool followInContact(const Harness& harness, const Topology& topology, int pieces, Equilibrium& result);
  bool describeContact(Equilibrium& result);
  bool adaptGrid(double accuracy, bool forces, Equilibrium& result);
  void carryTo(const Harness& harness, Topology topology);
  struct OnGrid {
    std::unique_ptr<RodSystem> system, coarse;
    Configuration configuration;
  };
  OnGrid regrid(const Grid& grid, const std::vector<CableShape>& shapes);
  void restoreGrid(OnGrid before);
  bool leaveSaddle(const NodalField& motion, Equilibrium& result);
  void returnToGrid();
  std::vector<std::vector<bool>> pairsThatMatter(const DiscretisationError& error, bool forces) const;
  bool overstretched(Equilibrium& result) const;
  bool lostInRounding(Equilibrium& result) const;
  void findEigenvalue(Equilibrium& result);
  double eigenvalueInContact() const;
  void noteForces(Equilibrium& result) const;

  EquilibriumOptions options_;
  Problem problem_;
  double softened_ = INFINITY;  // slenderness that the systems are softened to
  bool unstable_ = false;
  int left_saddles_ = 0;                  // in this finish()
  double gap_tolerance_ = kGapTolerance;  // [m]
  struct GapAt {
    std::vector<SpanConfiguration> spans;
    ExactGap gap;
  };
  std::optional<GapAt> known_gap_;  // of the harness at hand
  double force_error_ = 0.0;
  Grid first_grid_;  // that following began with; empty: it has not begun
  int keep_ = 1;     // how many harnesses a finer grid is kept for
  int left_ = 0;     // how many of them are left
};

/// More stretch than this is outside what a linear law and a real cable bear.
constexpr double kLargestStretch = 0.05;

}  // namespace cable_variation
