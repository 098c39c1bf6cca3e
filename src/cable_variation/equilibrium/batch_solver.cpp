#include <cable_variation/equilibrium/batch_solver.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include <cable_variation/equilibrium/discretisation/discretisation.h>
#include <cable_variation/equilibrium/discretisation/lane_system.h>
#include <cable_variation/equilibrium/search/minimise.h>
#include <cable_variation/equilibrium/search/smallest_eigenvalue.h>

namespace cable_variation {
namespace {

// Steps within which Newton's method is trusted, over the longest cable and in radians. Wider than
// DescentOptions has them: no damping follows, and what then goes astray is told by where it arrives.
constexpr double kLargestDisplacement = 0.25;
constexpr double kLargestRotation = 0.7;
// A harness whose last step with a Hessian of its own was larger is not near enough for steps with that one.
constexpr double kNear = 1e-3;
// Steps, likewise, after which the error left is below 1e-8 of the cable: one with a new Hessian leaves
// about its square, one with an old Hessian a part of itself. The residual must only agree, as in minimise().
constexpr double kFinalNewtonStep = 1e-5;
constexpr double kFinalStep = 3e-9;
constexpr double kFinalResidual = 1e3;
// What an equilibrium may be off the prediction even when that is no motion at all.
constexpr double kFreeDisplacement = 0.02;
constexpr double kFreeRotation = 0.1;
// As EquilibriumSolver bears.
constexpr double kLargestStretch = 0.1;
// The share of the errors allowed that the nominal shape is brought to, since others on its grid are less
// accurate.
constexpr double kReserve = 0.5;

// Steps, and how many of them with a new Hessian: two bring most harnesses so close that its factors serve to
// the end. The others follow on their own. The plans depend on nothing but the step's number, so that no
// harness feels how its neighbours do.
struct Plan {
  int steps, hessians;
  bool patient;  // no other plan comes after it
};
constexpr Plan kQuick = {4, 2, false};
constexpr Plan kThorough = {6, 6, true};

bool any(const LaneSystem::Flags& flags) {
  return std::any_of(flags.begin(), flags.end(), [](bool flag) { return flag; });
}

// How a harness comes to its equilibrium.
struct Path {
  double predicted_displacement = 0.0, predicted_rotation = 0.0;
  double displacement = 0.0, rotation = 0.0;  // corrections, summed up
  double last_displacement = INFINITY, last_rotation = INFINITY;
  bool newton = false;  // the last step had a Hessian of its own
};

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
    case BatchStatus::too_coarse:
      return "too coarse";
  }
  return "unknown";
}

// What batches start from.
struct BatchSolver::Nominal {
  Nominal(const Problem& of, const EquilibriumOptions& options)
      : problem(of),
        merged(problem.harness),
        tolerance(residualTolerance(*problem.system)),
        length(largestArcLength(problem.configuration)),
        accuracy(options.accuracy),
        force_accuracy(options.force_accuracy) {
    merged.setGrid(coarsen(problem.system->grid()));
    merged.configuration = transfer(problem.configuration, problem.system->grid(), merged.system->grid());
    merged.system->evaluate(merged.configuration, RodSystem::Hessian::none);
    system = std::make_unique<LaneSystem>(problem);
    merged_system = std::make_unique<LaneSystem>(merged);
  }

  Problem problem;
  Problem merged;    // every pair of elements
  double tolerance;  // [N]
  double length;     // [m]
  double accuracy;   // [m]
  double force_accuracy;
  std::unique_ptr<LaneSystem> system, merged_system;
};

struct BatchSolver::Lanes {
  explicit Lanes(const Nominal& of) : nominal(of), system(of.problem), merged(of.merged) {}

  void predict(const Harness* harnesses);
  void follow(const Plan& plan);
  bool arrive(std::size_t lane);
  void judgeStep(std::size_t lane, int step, const Plan& plan);
  void judgeStability();
  void judgeGrid();
  double smallestEigenvalue(int lane);

  const Nominal& nominal;
  LaneSystem system, merged;
  std::size_t count = 0;
  std::array<BatchOutcome, kBatch> outcomes;
  std::array<Path, kBatch> paths;
  LaneSystem::Flags active{};     // on their way
  LaneSystem::Flags waiting{};    // for a more thorough plan
  std::optional<Problem> single;  // of one lane, for its eigenvalue
  NodalField softest;             // motion of the nominal shape
  bool hessian = false;           // evaluated last
};

namespace {

const EquilibriumSolver& knownToBatches(const EquilibriumSolver& nominal, const Harness& harness) {
  requireNoContact(harness, "batches");
  return nominal;
}

}  // namespace

BatchSolver::BatchSolver(const EquilibriumSolver& nominal)
    : nominal_(std::make_shared<const Nominal>(
          knownToBatches(nominal, nominal.problem().harness).refined(kReserve).problem(), nominal.options())),
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
  lanes_->count = count;
  lanes_->predict(harnesses);
  lanes_->follow(kQuick);
  if (any(lanes_->waiting)) {
    lanes_->active = lanes_->waiting;
    lanes_->system.takeStress();
    lanes_->follow(kThorough);
  }
  lanes_->judgeStability();
  lanes_->judgeGrid();
}

void BatchSolver::Lanes::predict(const Harness* harnesses) {
  active.fill(false);
  system.restart(*nominal.system);
  for (std::size_t i = 0; i < count; ++i) {
    active[i] = system.load(static_cast<int>(i), harnesses[i]);
    outcomes[i] = {active[i] ? BatchStatus::not_converged : BatchStatus::other_structure, 0, 0.0, 0.0};
  }
  system.evaluate(false);
  system.predict(*nominal.system);
  system.move(active, true);
  for (std::size_t i = 0; i < count; ++i) {
    paths[i] = {};
    paths[i].predicted_displacement = system.displacement()[i];
    paths[i].predicted_rotation = system.rotation()[i];
    active[i] = active[i] && system.displacement()[i] < kLargestDisplacement * nominal.length &&
                system.rotation()[i] < kLargestRotation;
  }
}

// Brings the active harnesses to rest; those that do not get there with the plan's steps are left waiting.
void BatchSolver::Lanes::follow(const Plan& plan) {
  waiting.fill(false);
  for (int step = 1; any(active); ++step) {
    // none is expected to be at rest before: then the Hessian need not wait for the forces
    const bool may_rest = plan.patient || step > plan.hessians;
    hessian = step <= plan.hessians && !may_rest;
    system.evaluate(hessian);
    for (std::size_t i = 0; i < count; ++i) {
      if (!active[i]) continue;
      active[i] = !arrive(i);
      waiting[i] = active[i] && step > plan.steps && !plan.patient;
    }
    if (step > plan.steps || !any(active)) break;
    if (step <= plan.hessians && may_rest) {
      hessian = true;
      system.evaluate(true);
    }
    system.step();
    system.move(active, step + 1 <= plan.hessians);
    for (std::size_t i = 0; i < count; ++i) {
      if (active[i]) judgeStep(i, step, plan);
    }
  }
}

// Whether a harness can go on after a step, or waits for a more thorough plan.
void BatchSolver::Lanes::judgeStep(std::size_t lane, int step, const Plan& plan) {
  Path& path = paths[lane];
  ++outcomes[lane].iterations;
  const double before = std::max(path.last_displacement / nominal.length, path.last_rotation);
  path.last_displacement = system.displacement()[lane];
  path.last_rotation = system.rotation()[lane];
  path.newton = hessian;
  path.displacement += path.last_displacement;
  path.rotation += path.last_rotation;
  const double size = std::max(path.last_displacement / nominal.length, path.last_rotation);
  const bool far = plan.patient ? step > 1 && !(size < before) : step == plan.hessians && size > kNear;
  const bool trusted =
      path.last_displacement < kLargestDisplacement * nominal.length && path.last_rotation < kLargestRotation;
  active[lane] = trusted && !far;
  waiting[lane] = trusted && far && !plan.patient;
}

// Whether the forces on a harness balance; then what it has come to.
bool BatchSolver::Lanes::arrive(std::size_t lane) {
  const Path& path = paths[lane];
  BatchOutcome& outcome = outcomes[lane];
  outcome.residual = system.residual()[lane];
  const double largest = path.newton ? kFinalNewtonStep : kFinalStep;
  const bool final = path.last_displacement < largest * nominal.length && path.last_rotation < largest;
  if (!(outcome.residual <= (final ? kFinalResidual : 1.0) * nominal.tolerance)) return false;
  if (path.displacement > path.predicted_displacement + kFreeDisplacement * nominal.length ||
      path.rotation > path.predicted_rotation + kFreeRotation) {
    outcome.status = BatchStatus::departed;
  } else if (!(system.largestStretch(static_cast<int>(lane)) <= kLargestStretch)) {
    outcome.status = BatchStatus::overstretched;
  } else {
    outcome.status = BatchStatus::converged;
  }
  return true;
}

// By the Hessian of the shapes that are described, with their own stresses.
void BatchSolver::Lanes::judgeStability() {
  system.takeStress();
  system.evaluate(true);
  for (std::size_t i = 0; i < count; ++i) {
    if (outcomes[i].converged() && system.negativePivots()[i] > 0) outcomes[i].status = BatchStatus::unstable;
  }
}

void BatchSolver::Lanes::judgeGrid() {
  LaneSystem::Flags solved{};
  for (std::size_t i = 0; i < count; ++i) solved[i] = outcomes[i].converged();
  if (!any(solved)) return;
  merged.restart(*nominal.merged_system);
  merged.merge(system, solved);
  merged.evaluate(true);
  merged.step();
  merged.move({}, false);  // only its size counts
  const LaneSystem::Lanes force_error = merged.forceErrors(system);
  for (std::size_t i = 0; i < count; ++i) {
    if (!solved[i]) continue;
    const bool positive = merged.negativePivots()[i] == 0;
    BatchOutcome& outcome = outcomes[i];
    outcome.discretisation_error =
        positive ? errorOfFiner(merged.displacement()[i], nominal.length) : INFINITY;
    if (!(outcome.discretisation_error <= nominal.accuracy) || !(force_error[i] <= nominal.force_accuracy))
      outcome.status = BatchStatus::too_coarse;
  }
}

const BatchOutcome& BatchSolver::outcome(std::size_t index) const {
  if (index >= lanes_->count)
    throw std::out_of_range("no harness " + std::to_string(index) + " in the batch");
  return lanes_->outcomes[index];
}

double BatchSolver::Lanes::smallestEigenvalue(int lane) {
  if (!single) {
    single.emplace(nominal.problem);
    single->system->evaluate(single->configuration, RodSystem::Hessian::exact);
    cable_variation::smallestEigenvalue(*single->system, single->configuration, &softest);
  }
  single->harness = system.harness(lane);
  single->topology = makeTopology(single->harness);
  system.read(lane, single->configuration);
  single->system->harnessChanged();
  single->system->evaluate(single->configuration, RodSystem::Hessian::exact);
  return cable_variation::smallestEigenvalue(*single->system, single->configuration, nullptr, &softest);
}

double BatchSolver::smallestEigenvalue(std::size_t index) {
  if (!outcome(index).converged())
    throw std::logic_error("harness " + std::to_string(index) + " of the batch has no equilibrium");
  return lanes_->smallestEigenvalue(static_cast<int>(index));
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
  result.discretisation_error = of.discretisation_error;
  if (of.converged()) {
    result.status = EquilibriumStatus::converged;
  } else {
    result.message = toString(of.status);
  }
  return result;
}

}  // namespace cable_variation
