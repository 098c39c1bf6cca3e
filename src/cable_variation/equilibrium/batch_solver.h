#pragma once

#include <cstddef>
#include <memory>

#include <cable_variation/equilibrium/equilibrium.h>

namespace cable_variation {

/// How one harness of a batch ended. All but the first are for EquilibriumSolver::update() to try again,
/// which finds its way with patience, or says why there is none.
enum class BatchStatus {
  converged,        ///< a stable equilibrium, close to where the nominal one was expected to move
  other_structure,  ///< differs from the nominal harness in more than numbers
  not_converged,    ///< Newton's method did not settle
  unstable,         ///< stationary, but not a minimum
  departed,         ///< an equilibrium further from the prediction than that is from the nominal: it may have
                    ///< snapped
  overstretched,    ///< a cable is stretched or compressed by more than one can bear
  too_coarse        ///< the nominal grid leaves it a larger error than was asked for
};

const char* toString(BatchStatus status);

struct BatchOutcome {
  BatchStatus status = BatchStatus::not_converged;
  int iterations = 0;                 ///< steps after the prediction
  double residual = 0.0;              ///< as Equilibrium::residual [N]
  double discretisation_error = 0.0;  ///< as Equilibrium::discretisation_error [m]

  bool converged() const { return status == BatchStatus::converged; }
};

/// Solves many harnesses that differ from a solved one in numbers only (poses of clips, lengths, arc lengths,
/// stiffness, rest curvature, weight, loads, gravity), several side by side in the lanes of the vector
/// registers: AVX-512, AVX2 or plain, whichever the processor has.
///
/// Each starts from the nominal shape's first-order response to everything that changed, exact poses of its
/// clips, and is brought to its own equilibrium, on a grid that leaves the nominal shape half of the error
/// asked for, by Newton's method with the exact Hessian and predicted stresses, then by steps with the last
/// factors until the forces balance as well as EquilibriumSolver asks for. Then the error of the grid is
/// estimated for each, as EquilibriumSolver does, by a step on the grid with every pair of elements merged.
///
/// A harness gives the same numbers, bit for bit, in whatever batch and at whatever place in it. Another
/// instruction set rounds differently.
///
/// One per thread: a copy shares what is prepared and works on its own.
class BatchSolver {
 public:
  /// Most harnesses of one batch.
  static constexpr std::size_t kBatch = 8;

  /// Around the shape of the last converged call of `nominal`. Throws std::logic_error when there is none,
  /// and std::invalid_argument, naming it, for a clip that slides or a dead moment without a potential.
  explicit BatchSolver(const EquilibriumSolver& nominal);
  ~BatchSolver();
  BatchSolver(const BatchSolver& other);
  BatchSolver& operator=(const BatchSolver&) = delete;
  BatchSolver(BatchSolver&&) noexcept;

  /// Solves `count` harnesses, 1 to kBatch; fastest when they are that many. Each must be valid (validate()).
  /// Throws std::invalid_argument: a count out of range.
  void solve(const Harness* harnesses, std::size_t count);

  /// Of the harness at `index` of the last batch. Both throw std::out_of_range beyond it.
  const BatchOutcome& outcome(std::size_t index) const;
  /// All that EquilibriumSolver tells, but for the smallest eigenvalue (0) and the solve time (0).
  Equilibrium describe(std::size_t index) const;
  /// Of one that has converged, as Equilibrium::smallest_eigenvalue [N/m]; takes longer than to solve it.
  /// Throws std::logic_error if it has not.
  double smallestEigenvalue(std::size_t index);

 private:
  struct Nominal;
  struct Lanes;
  std::shared_ptr<const Nominal> nominal_;
  std::unique_ptr<Lanes> lanes_;
};

}  // namespace cable_variation
