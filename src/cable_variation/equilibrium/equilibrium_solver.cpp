#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>

#include <cable_variation/equilibrium/derivatives/eigenvalue_rate.h>
#include <cable_variation/equilibrium/derivatives/equilibrium_rate.h>
#include <cable_variation/equilibrium/discretisation/contact_result.h>
#include <cable_variation/equilibrium/discretisation/equilibrium_result.h>
#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/equilibrium/search/branch.h>
#include <cable_variation/equilibrium/search/initial_shape.h>
#include <cable_variation/equilibrium/search/lowest_shape.h>
#include <cable_variation/equilibrium/search/shape_from.h>
#include <cable_variation/util/seconds_since.h>

namespace cable_variation {

const char* toString(EquilibriumStatus status) {
  switch (status) {
    case EquilibriumStatus::converged:
      return "converged";
    case EquilibriumStatus::not_converged:
      return "not converged";
    case EquilibriumStatus::unstable:
      return "unstable";
    case EquilibriumStatus::impossible:
      return "impossible";
  }
  return "unknown";
}

struct EquilibriumSolver::Impl {
  explicit Impl(const EquilibriumOptions& of) : options(of) {}
  Impl(const Impl& other)
      : options(other.options), branch(other.branch ? std::make_unique<Branch>(*other.branch) : nullptr) {}

  Equilibrium solve(const Harness& harness);
  Equilibrium update(const Harness& harness);
  Equilibrium solveFrom(const Harness& harness, const std::vector<CableShape>& shapes);

  std::vector<EquilibriumRate> differentiate(const std::vector<HarnessRate>& variables);
  std::vector<double> eigenvalueRates(const std::vector<HarnessRate>& variables);
  Problem& atRest();
  LinearResponse linearise(Problem& problem) const;

  EquilibriumOptions options;
  std::unique_ptr<Branch> branch;  // of the last converged call
  std::unique_ptr<Branch> aside;   // a copy that is differentiated, of a shape that touches
};

// What contact does not know yet.
void requireKnownContact(const Harness& harness) {
  const bool moments = std::any_of(harness.loads.begin(), harness.loads.end(),
                                   [](const PointLoad& load) { return !load.moment.isZero(0.0); });
  if (moments) requireNoContact(harness, "dead moments");
}

// Whether contact can be anywhere outside the parts; else the result says why not.
bool canBeOutside(const Harness& harness, Equilibrium& result) {
  result.message = heldInside(harness);
  if (result.message.empty()) return true;
  result.status = EquilibriumStatus::impossible;
  return false;
}

Equilibrium EquilibriumSolver::Impl::solve(const Harness& harness) {
  const auto start = Clock::now();
  requireKnownContact(harness);
  Equilibrium result;
  if (!canBeOutside(harness, result)) {
    branch.reset();
    return result;
  }
  branch = lowestShape(harness, options, result);
  if (branch) branch->finish(result);
  if (!result.converged()) branch.reset();
  result.solve_time = secondsSince(start);
  return result;
}

Equilibrium EquilibriumSolver::Impl::update(const Harness& harness) {
  const auto start = Clock::now();
  requireKnownContact(harness);
  if (!branch) return solve(harness);
  const Problem& problem = branch->problem();
  const Topology topology = makeTopology(harness);
  if (!sameStructure(problem.harness, problem.topology, harness, topology)) return solve(harness);
  // there is no energy to follow a shape by while dead moments grow or turn
  if (!problem.system->conservative() || !problem.system->conservative(harness)) return solve(harness);
  Equilibrium result;
  if (!canBeOutside(harness, result)) {
    branch.reset();
    return result;
  }
  branch->setOptions(options);
  if (!branch->follow(harness, topology, result)) return solve(harness);  // the branch ends here
  branch->finish(result);
  if (!result.converged()) branch.reset();
  result.solve_time = secondsSince(start);
  return result;
}

Equilibrium EquilibriumSolver::Impl::solveFrom(const Harness& harness,
                                               const std::vector<CableShape>& shapes) {
  const auto start = Clock::now();
  requireKnownContact(harness);
  Equilibrium result;
  if (!canBeOutside(harness, result)) {
    branch.reset();
    return result;
  }
  branch = shapeFrom(harness, shapes, options, result);
  if (branch) branch->finish(result);
  if (!result.converged()) branch.reset();
  result.solve_time = secondsSince(start);
  return result;
}

std::vector<ContactForceRate> contactRates(const Problem& problem, const HarnessResponse& response) {
  std::vector<ContactForceRate> rates;
  for (Eigen::Index i = 0; i < response.contact_forces.size(); ++i) {
    const auto& at = problem.system->contact()->pressing()[static_cast<std::size_t>(i)];
    const Span& span = problem.topology.spans[at.span];
    const double left = problem.configuration.stations[span.left].arc_length;
    const double right = problem.configuration.stations[span.right].arc_length;
    rates.push_back({span.cable, at.contact, left + at.share * (right - left), response.contact_forces[i]});
  }
  return rates;
}

// The equilibrium as it is differentiated.
Problem& EquilibriumSolver::Impl::atRest() {
  if (!branch || branch->unstable()) throw std::logic_error("there is no equilibrium to differentiate");
  const ContactSystem* contact = branch->problem().system->contact();
  if (contact == nullptr || contact->pressing().empty()) return branch->problem();
  aside = std::make_unique<Branch>(*branch);
  aside->letPointsMove();
  return aside->problem();
}

// The system ends with its Hessian factorised at the equilibrium.
LinearResponse EquilibriumSolver::Impl::linearise(Problem& problem) const {
  // The error of the derivatives is the shift over the softest motion's share of the bending stiffness.
  constexpr double kSmallestShift = 1e-12;
  for (double shift : {kSmallestShift, neutralShift(*problem.system)}) {
    problem.system->evaluate(problem.configuration, RodSystem::Hessian::exact);
    if (problem.system->factorise(shift, problem.system->bendingMetric()) == 0) break;
  }
  return LinearResponse(*problem.system, problem.configuration);
}

std::vector<EquilibriumRate> EquilibriumSolver::Impl::differentiate(
    const std::vector<HarnessRate>& variables) {
  Problem& problem = atRest();
  LinearResponse response = linearise(problem);
  const std::vector<CableShape> shapes =
      describeShapes(problem.harness, problem.topology, *problem.system, problem.configuration);
  const ShapeRates shape_rates(problem.harness, problem.topology, shapes);
  std::vector<EquilibriumRate> rates;
  rates.reserve(variables.size());
  for (const HarnessRate& variable : variables) {
    const HarnessChange change = changeOf(problem.harness, problem.topology, problem.system->unknowns(),
                                          problem.configuration, variable);
    const HarnessResponse& changed = response.to(change);
    rates.push_back(shape_rates.of(change, changed));
    rates.back().contacts = contactRates(problem, changed);
  }
  aside.reset();
  return rates;
}

std::vector<double> EquilibriumSolver::Impl::eigenvalueRates(const std::vector<HarnessRate>& variables) {
  Problem& problem = atRest();
  if (&problem != &branch->problem())
    requireNoContact(problem.harness, "derivatives of the smallest eigenvalue where a cable touches");
  LinearResponse response = linearise(problem);
  EigenvalueRate rate(problem);
  std::vector<double> rates;
  for (const HarnessRate& variable : variables) {
    const HarnessChange change = changeOf(problem.harness, problem.topology, problem.system->unknowns(),
                                          problem.configuration, variable);
    rates.push_back(rate.of(variable, change, response.to(change)));
  }
  return rates;
}

void validate(const EquilibriumOptions& options) {
  const auto require = [](bool right, const char* name, double value, const char* expected) {
    if (right) return;
    std::ostringstream text;
    text << name << ": " << value << "; expected " << expected;
    throw std::invalid_argument(text.str());
  };
  require(options.accuracy > 0.0, "accuracy", options.accuracy, "more than 0 m");
  require(options.force_accuracy > 0.0, "force_accuracy", options.force_accuracy, "more than 0");
  require(options.eigenvalue_accuracy > 0.0, "eigenvalue_accuracy", options.eigenvalue_accuracy,
          "more than 0");
  require(options.max_iterations >= 1, "max_iterations", options.max_iterations, "at least 1");
  validate(options.descent);
}

EquilibriumSolver::EquilibriumSolver(const EquilibriumOptions& options) {
  validate(options);
  impl_ = std::make_unique<Impl>(options);
}
EquilibriumSolver::~EquilibriumSolver() = default;
EquilibriumSolver::EquilibriumSolver(const EquilibriumSolver& other)
    : impl_(std::make_unique<Impl>(*other.impl_)) {}
EquilibriumSolver& EquilibriumSolver::operator=(const EquilibriumSolver& other) {
  if (this != &other) impl_ = std::make_unique<Impl>(*other.impl_);
  return *this;
}
EquilibriumSolver::EquilibriumSolver(EquilibriumSolver&&) noexcept = default;
EquilibriumSolver& EquilibriumSolver::operator=(EquilibriumSolver&&) noexcept = default;

void EquilibriumSolver::setOptions(const EquilibriumOptions& options) {
  validate(options);
  impl_->options = options;
}
Equilibrium EquilibriumSolver::solve(const Harness& harness) { return impl_->solve(harness); }
Equilibrium EquilibriumSolver::update(const Harness& harness) { return impl_->update(harness); }
Equilibrium EquilibriumSolver::solveFrom(const Harness& harness, const std::vector<CableShape>& shapes) {
  return impl_->solveFrom(harness, shapes);
}
std::vector<EquilibriumRate> EquilibriumSolver::differentiate(const std::vector<HarnessRate>& variables) {
  return impl_->differentiate(variables);
}
std::vector<double> EquilibriumSolver::eigenvalueRates(const std::vector<HarnessRate>& variables) {
  return impl_->eigenvalueRates(variables);
}

const Problem& EquilibriumSolver::problem() const {
  if (!impl_->branch || impl_->branch->unstable())
    throw std::logic_error("there is no equilibrium to start from");
  return impl_->branch->problem();
}

const EquilibriumOptions& EquilibriumSolver::options() const { return impl_->options; }

EquilibriumSolver EquilibriumSolver::refined(double share) const {
  EquilibriumSolver finer(*this);
  finer.impl_->options.accuracy *= share;
  finer.impl_->options.force_accuracy *= share;
  finer.impl_->options.eigenvalue = false;
  finer.update(Harness(problem().harness));
  return finer;
}

}  // namespace cable_variation
