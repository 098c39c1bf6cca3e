#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include <cable_variation/harness/discretisation.h>
#include <cable_variation/harness/eigenvalue_rate.h>
#include <cable_variation/harness/equilibrium.h>
#include <cable_variation/harness/equilibrium_rate.h>
#include <cable_variation/harness/equilibrium_result.h>
#include <cable_variation/harness/initial_shape.h>
#include <cable_variation/harness/problem.h>
#include <cable_variation/harness/smallest_eigenvalue.h>
#include <cable_variation/harness/start_search.h>
#include <cable_variation/math/seconds_since.h>
#include <cable_variation/math/so3.h>

namespace cable_variation {
namespace {

// More stretch than this is outside what a linear law and a real cable bear.
constexpr double kLargestStretch = 0.05;
// update() goes to its goal in pieces that turn no clip by more than this [rad].
constexpr double kLargestPiece = 0.35;
constexpr int kRefinements = 7;

// The clips on their way from `from` to `to`.
Harness between(const Harness& from, const Harness& to, double t) {
  Harness harness = to;
  for (std::size_t i = 0; i < to.clips.size(); ++i) {
    Pose& pose = harness.clips[i].pose;
    const Pose& start = from.clips[i].pose;
    pose.position = (1.0 - t) * start.position + t * pose.position;
    pose.orientation = start.orientation.slerp(t, pose.orientation);
  }
  return harness;
}

// With dead moments scaled by `share`.
Harness withMoments(const Harness& harness, double share) {
  Harness scaled = harness;
  for (PointLoad& load : scaled.loads) load.moment *= share;
  return scaled;
}

}  // namespace

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
      : options(other.options),
        problem(other.problem ? std::make_unique<Problem>(*other.problem) : nullptr) {}

  Equilibrium solve(const Harness& harness);
  Equilibrium update(const Harness& harness);

  void find(const Harness& harness, Equilibrium& result);
  bool search(Equilibrium& result);
  bool growMoments(const Harness& harness, Equilibrium& result);
  bool descend(bool settle, Equilibrium& result);
  void follow(const Harness& harness, Topology topology);
  bool adaptGrid(Equilibrium& result);
  void finish(Equilibrium& result);

  std::vector<EquilibriumRate> differentiate(const std::vector<HarnessRate>& variables);
  std::vector<double> eigenvalueRates(const std::vector<HarnessRate>& variables);
  LinearResponse linearise();

  EquilibriumOptions options;
  std::unique_ptr<Problem> problem;
  bool unstable = false;  // the shape at hand is merely stationary
};

// From the shape at hand to a minimum near by, or with `settle` to the stationary shape near by.
bool EquilibriumSolver::Impl::descend(bool settle, Equilibrium& result) {
  const Minimum minimum =
      minimise(*problem->system, problem->configuration, {options.max_iterations, settle, false});
  result.iterations += minimum.iterations;
  result.residual = minimum.residual;
  if (settle) unstable = !minimum.stable;
  return settle ? minimum.stationary : minimum.stable;
}

// The shape on the start grid; else says in the result why there is none.
bool EquilibriumSolver::Impl::search(Equilibrium& result) {
  const InitialShape initial(problem->harness, problem->topology);
  problem->configuration =
      initial.make(problem->system->grid(), std::vector<Routing>(initial.intervals().size()));
  const std::string reason =
      unreachable(problem->harness, problem->topology, problem->configuration, kLargestStretch);
  if (!reason.empty()) {
    result.status = EquilibriumStatus::impossible;
    result.message = reason;
    return false;
  }
  const SearchResult found = searchStarts(*problem, options, result);
  unstable = !found.stable;
  if (found.found) return true;
  result.status = EquilibriumStatus::not_converged;
  result.message = "no start led to an equilibrium: " + found.failure;
  return false;
}

// Dead moments that have no potential: there is no energy to descend. The shape without them is followed
// while they grow; it is stable as long as it passes no singular point.
bool EquilibriumSolver::Impl::growMoments(const Harness& harness, Equilibrium& result) {
  double turn = 0.0;  // that the moments may cause [rad]
  for (const PointLoad& load : harness.loads) {
    const Section section = sectionAt(harness.cables[load.cable], load.arc_length);
    const double softest = std::min({section.EI_y, section.EI_z, section.GJ});
    turn += load.moment.norm() * harness.cables[load.cable].length / softest;
  }
  const int pieces = std::max(1, static_cast<int>(std::ceil(turn / kLargestPiece)));
  bool passed_singular = false;
  for (int k = 1; k <= pieces; ++k) {
    follow(withMoments(harness, static_cast<double>(k) / pieces), makeTopology(harness));
    if (!descend(true, result)) {
      result.status = EquilibriumStatus::not_converged;
      result.message =
          "the shape was lost while the dead moments grew: " +
          whereItFailed(problem->harness, problem->topology, *problem->system, problem->configuration);
      return false;
    }
    passed_singular = passed_singular || unstable;
  }
  unstable = passed_singular;
  return true;
}

// Refines until the estimated error is below the accuracy asked for. The system ends with its gradient at
// the configuration, and the result with the shapes there.
bool EquilibriumSolver::Impl::adaptGrid(Equilibrium& result) {
  for (int round = 0; round <= kRefinements; ++round) {
    result.shapes =
        describeShapes(problem->harness, problem->topology, *problem->system, problem->configuration);
    const Configuration on_coarse =
        onGrid(problem->topology, problem->configuration, result.shapes, problem->coarse->grid());
    const DiscretisationError error =
        estimateDiscretisation(*problem->system, *problem->coarse, on_coarse, !unstable);
    result.discretisation_error = error.centreline;
    if (error.centreline <= options.accuracy) return true;
    if (round == kRefinements) break;
    double largest = 0.0;
    for (const auto& span : error.contribution) {
      for (double c : span) largest = std::max(largest, c);
    }
    std::vector<std::vector<bool>> marked;
    for (const auto& span : error.contribution) {
      marked.emplace_back();
      for (double c : span) marked.back().push_back(c >= 0.02 * largest || !std::isfinite(error.centreline));
    }
    problem->setGrid(refine(problem->system->grid(), marked));
    problem->configuration =
        onGrid(problem->topology, problem->configuration, result.shapes, problem->system->grid());
    if (!descend(unstable || !problem->system->conservative(), result)) break;
  }
  result.shapes.clear();
  return false;
}

void EquilibriumSolver::Impl::finish(Equilibrium& result) {
  describe(problem->harness, problem->topology, *problem->system, problem->configuration, result);
  for (const CableShape& shape : result.shapes) {
    for (const ShapePoint& point : shape.points) {
      if (std::abs(point.strain.x()) <= 2.0 * kLargestStretch) continue;
      std::ostringstream text;
      text << "cable '" << shape.cable << "' is stretched by " << 100.0 * point.strain.x() << " % at "
           << 1e3 * point.arc_length << " mm; expected at most " << 200.0 * kLargestStretch
           << " %: the clips around it leave it too little length";
      result.status = EquilibriumStatus::impossible;
      result.message = text.str();
      return;
    }
  }
  if (options.eigenvalue || unstable) {
    problem->system->evaluate(problem->configuration, RodSystem::Hessian::exact);
    result.smallest_eigenvalue = smallestEigenvalue(*problem->system, problem->configuration);
  }
  result.status = EquilibriumStatus::converged;
  if (unstable) {
    std::ostringstream text;
    text << "the only equilibrium found is unstable: the smallest eigenvalue is "
         << result.smallest_eigenvalue << " N/m";
    result.status = EquilibriumStatus::unstable;
    result.message = text.str();
  }
}

void EquilibriumSolver::Impl::find(const Harness& harness, Equilibrium& result) {
  problem = std::make_unique<Problem>(harness);
  problem->setGrid(startGrid(problem->harness, problem->topology));
  const bool conservative = problem->system->conservative();
  if (!conservative) problem->harness = withMoments(harness, 0.0);
  if (!search(result)) return;
  if (!conservative && !growMoments(harness, result)) return;
  problem->system->evaluate(problem->configuration, RodSystem::Hessian::none);
  if (!adaptGrid(result)) {
    result.status = EquilibriumStatus::not_converged;
    std::ostringstream text;
    text << "the grid could not be refined to the accuracy of " << 1e3 * options.accuracy
         << " mm; estimated error " << 1e3 * result.discretisation_error << " mm; "
         << whereItFailed(problem->harness, problem->topology, *problem->system, problem->configuration);
    result.message = text.str();
    return;
  }
  finish(result);
}

Equilibrium EquilibriumSolver::Impl::solve(const Harness& harness) {
  const auto start = Clock::now();
  Equilibrium result;
  find(harness, result);
  if (!result.converged()) problem.reset();
  result.solve_time = secondsSince(start);
  return result;
}

// Carries the shape along to the new harness, to first order.
void EquilibriumSolver::Impl::follow(const Harness& harness, Topology topology) {
  Configuration& configuration = problem->configuration;
  const std::vector<StationConfiguration> before = configuration.stations;
  problem->harness = harness;
  problem->topology = std::move(topology);
  for (std::size_t i = 0; i < configuration.stations.size(); ++i) {
    if (problem->system->unknowns().slide(i) < 0) {
      configuration.stations[i].arc_length = problem->topology.stations[i].arc_length;
    }
  }
  placeStations(problem->harness, problem->topology, configuration);
  Eigen::Matrix<double, 6, Eigen::Dynamic> carried(6,
                                                   static_cast<Eigen::Index>(configuration.stations.size()));
  bool moved = false;
  for (std::size_t i = 0; i < configuration.stations.size(); ++i) {
    const Pose& from = before[i].pose;
    const Pose& to = configuration.stations[i].pose;
    carried.col(static_cast<Eigen::Index>(i)) << to.position - from.position,
        so3::log(from.orientation.conjugate() * to.orientation);
    moved = moved || !carried.col(static_cast<Eigen::Index>(i)).isZero(0.0);
  }
  if (moved) {
    NodalField motion;
    problem->system->follow(carried, motion);
    problem->system->move(motion, configuration);
  }
  problem->system->harnessChanged();
  problem->coarse->harnessChanged();
}

Equilibrium EquilibriumSolver::Impl::update(const Harness& harness) {
  const auto start = Clock::now();
  if (!problem || !problem->system->conservative()) return solve(harness);
  Topology topology = makeTopology(harness);
  if (!sameStructure(problem->harness, problem->topology, harness, topology)) return solve(harness);
  double turn = 0.0;
  for (std::size_t i = 0; i < harness.clips.size(); ++i) {
    const auto& from = problem->harness.clips[i].pose.orientation;
    turn = std::max(turn, from.angularDistance(harness.clips[i].pose.orientation));
  }
  Equilibrium result;
  const int pieces = std::max(1, static_cast<int>(std::ceil(turn / kLargestPiece)));
  if (pieces > 1) {
    const Harness origin = problem->harness;
    for (int k = 1; k < pieces; ++k) {
      follow(between(origin, harness, static_cast<double>(k) / pieces), topology);
      if (!descend(false, result)) return solve(harness);  // the branch ends here
    }
  }
  follow(harness, std::move(topology));
  const bool reachable =
      unreachable(problem->harness, problem->topology, problem->configuration, kLargestStretch).empty();
  if (!reachable || !descend(false, result) || !adaptGrid(result)) return solve(harness);
  finish(result);
  if (!result.converged()) problem.reset();
  result.solve_time = secondsSince(start);
  return result;
}

// The system ends with its Hessian factorised at the equilibrium.
LinearResponse EquilibriumSolver::Impl::linearise() {
  // The error of the derivatives is the shift over the softest motion's share of the bending stiffness.
  constexpr double kSmallestShift = 1e-12;
  if (!problem || unstable) throw std::logic_error("there is no equilibrium to differentiate");
  for (double shift : {kSmallestShift, kNeutralShift}) {
    problem->system->evaluate(problem->configuration, RodSystem::Hessian::exact);
    if (problem->system->factorise(shift, problem->system->bendingMetric()) == 0) break;
  }
  return LinearResponse(*problem->system, problem->configuration);
}

std::vector<EquilibriumRate> EquilibriumSolver::Impl::differentiate(
    const std::vector<HarnessRate>& variables) {
  LinearResponse response = linearise();
  const std::vector<CableShape> shapes =
      describeShapes(problem->harness, problem->topology, *problem->system, problem->configuration);
  const ShapeRates shape_rates(problem->harness, problem->topology, shapes);
  std::vector<EquilibriumRate> rates;
  rates.reserve(variables.size());
  for (const HarnessRate& variable : variables) {
    const HarnessChange change = changeOf(problem->harness, problem->topology, problem->system->unknowns(),
                                          problem->configuration, variable);
    rates.push_back(shape_rates.of(change, response.to(change)));
  }
  return rates;
}

std::vector<double> EquilibriumSolver::Impl::eigenvalueRates(const std::vector<HarnessRate>& variables) {
  LinearResponse response = linearise();
  EigenvalueRate rate(*problem);
  std::vector<double> rates;
  for (const HarnessRate& variable : variables) {
    const HarnessChange change = changeOf(problem->harness, problem->topology, problem->system->unknowns(),
                                          problem->configuration, variable);
    rates.push_back(rate.of(variable, change, response.to(change)));
  }
  return rates;
}

EquilibriumSolver::EquilibriumSolver(const EquilibriumOptions& options)
    : impl_(std::make_unique<Impl>(options)) {}
EquilibriumSolver::~EquilibriumSolver() = default;
EquilibriumSolver::EquilibriumSolver(const EquilibriumSolver& other)
    : impl_(std::make_unique<Impl>(*other.impl_)) {}
EquilibriumSolver& EquilibriumSolver::operator=(const EquilibriumSolver& other) {
  if (this != &other) impl_ = std::make_unique<Impl>(*other.impl_);
  return *this;
}
EquilibriumSolver::EquilibriumSolver(EquilibriumSolver&&) noexcept = default;
EquilibriumSolver& EquilibriumSolver::operator=(EquilibriumSolver&&) noexcept = default;

void EquilibriumSolver::setOptions(const EquilibriumOptions& options) { impl_->options = options; }
Equilibrium EquilibriumSolver::solve(const Harness& harness) { return impl_->solve(harness); }
Equilibrium EquilibriumSolver::update(const Harness& harness) { return impl_->update(harness); }
std::vector<EquilibriumRate> EquilibriumSolver::differentiate(const std::vector<HarnessRate>& variables) {
  return impl_->differentiate(variables);
}
std::vector<double> EquilibriumSolver::eigenvalueRates(const std::vector<HarnessRate>& variables) {
  return impl_->eigenvalueRates(variables);
}

const Problem& EquilibriumSolver::problem() const {
  if (!impl_->problem || impl_->unstable) throw std::logic_error("there is no equilibrium to start from");
  return *impl_->problem;
}

const EquilibriumOptions& EquilibriumSolver::options() const { return impl_->options; }

EquilibriumSolver EquilibriumSolver::refined(double accuracy) const {
  EquilibriumSolver finer(*this);
  finer.impl_->options.accuracy = accuracy;
  finer.impl_->options.eigenvalue = false;
  finer.update(Harness(problem().harness));
  return finer;
}

}  // namespace cable_variation
