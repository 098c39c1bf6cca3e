#include <cable_variation/harness/batch_solver.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include <cable_variation/harness/lane_system.h>

namespace cable_variation {
namespace {

constexpr int kMaxIterations = 12;
// Steps within which Newton's method is trusted, over the harness's length and in radians; as minimise().
constexpr double kLargestShift = 0.25;
constexpr double kLargestTurn = 0.7;
// Steps below which rounding is all that is left, likewise; then the residual may be that of rounding, too.
constexpr double kTinyStep = 1e-10;
constexpr double kRoundingResidual = 1e3;
// What an equilibrium may be off the prediction even when that is no motion at all.
constexpr double kFreeShift = 0.02;
constexpr double kFreeTurn = 0.1;
// As EquilibriumSolver bears.
constexpr double kLargestStretch = 0.1;

// Two steps with the exact Hessian bring most harnesses so close that its factors serve to the end. The plan
// depends on the iteration alone, so that no harness feels how its neighbours do.
bool newHessianAt(int iteration) { return iteration <= 2 || iteration % 3 == 2; }

}  // namespace

const char* toString(BatchStatus status) {
  switch (status) {
    case BatchStatus::converged:
      return "converged";
    case BatchStatus::other_structure:
      return "other structure";
    case BatchStatus::not_converged:
      return "not converged";
    case BatchStatus::unstable:
      return "unstable";
    case BatchStatus::departed:
      return "departed";
    case BatchStatus::overstretched:
      return "overstretched";
  }
  return "unknown";
}

struct BatchSolver::Nominal {
  Nominal(const Problem& of, double error)
      : problem(of),
        system(problem),
        tolerance(toleranceOf(*problem.system)),
        length(largestArcLength(problem.configuration)),
        discretisation_error(error) {}

  // Looser than minimise(), which has no last steps with old factors: leaves some 1e-10 m.
  static double toleranceOf(const RodSystem& system) {
    constexpr double kBalance = 1e-8;  // of what the softest bending takes
    double force = 0.0;
    for (const auto& metric : system.bendingMetric()) force = std::max(force, metric.bend);  // EI (π/L)²
    return std::max(residualTolerance(system), kBalance * force);
  }

  Problem problem;
  LaneSystem system;
  double tolerance;  // [N]
  double length;     // [m]
  double discretisation_error;
};

struct BatchSolver::Lanes {
  explicit Lanes(const Nominal& nominal) : system(nominal.problem) {}

  LaneSystem system;
  std::size_t count = 0;
  std::array<BatchOutcome, kBatch> outcomes;
};

BatchSolver::BatchSolver(const EquilibriumSolver& nominal)
    : nominal_(std::make_shared<const Nominal>(nominal.problem(), 0.0)),
      lanes_(std::make_unique<Lanes>(*nominal_)) {}

BatchSolver::~BatchSolver() = default;
BatchSolver::BatchSolver(const BatchSolver& other)
    : nominal_(other.nominal_), lanes_(std::make_unique<Lanes>(*nominal_)) {}
BatchSolver::BatchSolver(BatchSolver&&) noexcept = default;

void BatchSolver::solve(const Harness* harnesses, std::size_t count) {
  static_assert(kBatch == LaneSystem::kLanes, "a harness per lane");
  if (count < 1 || count > kBatch) {
    throw std::invalid_argument("a batch of " + std::to_string(count) + " harnesses; expected 1 to " +
                                std::to_string(kBatch));
  }
  LaneSystem& system = lanes_->system;
  lanes_->count = count;
  struct Path {
    double predicted_shift = 0.0, predicted_turn = 0.0;
    double shift = 0.0, turn = 0.0;  // corrections, summed up
    double last_shift = INFINITY, last_turn = INFINITY;
    bool stable = false;
  };
  std::array<Path, kBatch> paths;
  LaneSystem::Flags active{};
  system.restart(nominal_->system);
  for (std::size_t i = 0; i < count; ++i) {
    active[i] = system.load(static_cast<int>(i), harnesses[i]);
    lanes_->outcomes[i] = {active[i] ? BatchStatus::not_converged : BatchStatus::other_structure, 0, 0.0};
  }
  system.evaluate(false);
  system.predict(nominal_->system);
  system.move(active, newHessianAt(1));
  for (std::size_t i = 0; i < count; ++i) {
    paths[i].predicted_shift = system.shift()[i];
    paths[i].predicted_turn = system.turn()[i];
    active[i] =
        active[i] && system.shift()[i] < kLargestShift * nominal_->length && system.turn()[i] < kLargestTurn;
  }
  for (int iteration = 1; iteration <= kMaxIterations; ++iteration) {
    if (std::none_of(active.begin(), active.end(), [](bool a) { return a; })) break;
    const bool hessian = newHessianAt(iteration);
    system.evaluate(hessian);
    bool all_done = true;
    for (std::size_t i = 0; i < count; ++i) {
      if (!active[i]) continue;
      Path& path = paths[i];
      BatchOutcome& outcome = lanes_->outcomes[i];
      outcome.residual = system.residual()[i];
      if (hessian) path.stable = system.negativePivots()[i] == 0;
      const bool tiny = path.last_shift < kTinyStep * nominal_->length && path.last_turn < kTinyStep;
      const double tolerance = tiny ? kRoundingResidual * nominal_->tolerance : nominal_->tolerance;
      if (!(outcome.residual <= tolerance)) {
        all_done = false;
        continue;
      }
      active[i] = false;
      const bool departed = path.shift > path.predicted_shift + kFreeShift * nominal_->length ||
                            path.turn > path.predicted_turn + kFreeTurn;
      if (!path.stable) {
        outcome.status = BatchStatus::unstable;
      } else if (departed) {
        outcome.status = BatchStatus::departed;
      } else if (!(system.largestStretch(static_cast<int>(i)) <= kLargestStretch)) {
        outcome.status = BatchStatus::overstretched;
      } else {
        outcome.status = BatchStatus::converged;
      }
    }
    if (all_done) break;
    system.step();
    system.move(active, newHessianAt(iteration + 1));
    for (std::size_t i = 0; i < count; ++i) {
      if (!active[i]) continue;
      Path& path = paths[i];
      const double shift = system.shift()[i], turn = system.turn()[i];
      ++lanes_->outcomes[i].iterations;
      path.shift += shift;
      path.turn += turn;
      path.last_shift = shift;
      path.last_turn = turn;
      active[i] = shift < kLargestShift * nominal_->length && turn < kLargestTurn;
    }
  }
}

const BatchOutcome& BatchSolver::outcome(std::size_t index) const {
  if (index >= lanes_->count)
    throw std::out_of_range("no harness " + std::to_string(index) + " in the batch");
  return lanes_->outcomes[index];
}

Equilibrium BatchSolver::describe(std::size_t index) const {
  const BatchOutcome& of = outcome(index);
  Equilibrium result;
  if (of.status == BatchStatus::other_structure) {
    result.message = "the harness differs from the nominal one in more than numbers";
    return result;
  }
  lanes_->system.describe(static_cast<int>(index), result);
  result.iterations = of.iterations;
  result.discretisation_error = nominal_->discretisation_error;
  if (of.converged()) {
    result.status = EquilibriumStatus::converged;
  } else {
    result.message = toString(of.status);
  }
  return result;
}

}  // namespace cable_variation
