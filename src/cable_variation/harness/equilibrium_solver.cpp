#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

#include <cable_variation/harness/discretisation.h>
#include <cable_variation/harness/equilibrium.h>
#include <cable_variation/harness/equilibrium_result.h>
#include <cable_variation/harness/grid.h>
#include <cable_variation/harness/initial_shape.h>
#include <cable_variation/harness/minimise.h>
#include <cable_variation/math/so3.h>

namespace cable_variation {
namespace {

using Clock = std::chrono::steady_clock;

// More stretch than this is outside what a linear law and a real cable bear.
constexpr double kLargestStretch = 0.05;
// Shapes closer than this share of the harness's length are the same equilibrium.
constexpr double kSameShape = 1e-3;
// update() goes to its goal in pieces that turn no clip by more than this [rad].
constexpr double kLargestPiece = 0.35;
constexpr int kRefinements = 7;

// A harness on a grid, and the shape it has there. Not movable: the system refers to its members.
struct Problem {
  Harness harness;
  Topology topology;
  std::unique_ptr<RodSystem> system;
  std::unique_ptr<RodSystem> coarse;  // every pair of elements merged
  Configuration configuration;

  explicit Problem(const Harness& of) : harness(of), topology(makeTopology(of)) {}
  Problem(const Problem& other)
      : harness(other.harness), topology(other.topology), configuration(other.configuration) {
    if (other.system) {
      setGrid(other.system->grid());
      system->evaluate(configuration, RodSystem::Hessian::exact);
      system->factorise(kNeutralShift, system->bendingMetric());
    }
  }
  Problem& operator=(const Problem&) = delete;

  void setGrid(const Grid& grid) {
    system = std::make_unique<RodSystem>(harness, topology, grid);
    coarse = std::make_unique<RodSystem>(harness, topology, coarsen(grid));
  }

  double length() const {
    double sum = 0.0;
    for (const Cable& cable : harness.cables) sum += cable.length;
    return sum;
  }
};

// A stationary shape that a start led to.
struct Candidate {
  bool stable = false;
  Configuration configuration;
  double energy = 0.0;
  std::vector<double> interval_energy;
  std::vector<Routing> routing;
};

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

  bool search(Equilibrium& result);
  std::optional<Candidate> tryRouting(const InitialShape& initial, const std::vector<Routing>& routing,
                                      Equilibrium& result);
  void follow(const Harness& harness);
  bool adaptGrid(Equilibrium& result);
  void finish(Equilibrium& result);

  EquilibriumOptions options;
  std::unique_ptr<Problem> problem;
  std::string failure;    // of the first start that led nowhere
  bool unstable = false;  // no start led to a minimum: the shape at hand is merely stationary
};

// From one start to a minimum on the current grid.
std::optional<Candidate> EquilibriumSolver::Impl::tryRouting(const InitialShape& initial,
                                                             const std::vector<Routing>& routing,
                                                             Equilibrium& result) {
  RodSystem& system = *problem->system;
  Candidate candidate;
  candidate.routing = routing;
  candidate.configuration = initial.make(system.grid(), routing);
  const Minimum minimum = minimise(system, candidate.configuration, {options.max_iterations, false, true});
  result.iterations += minimum.iterations;
  result.residual = minimum.residual;
  if (!minimum.stationary) {
    if (failure.empty()) {
      failure = whereItFailed(problem->harness, problem->topology, system, candidate.configuration);
    }
    return std::nullopt;
  }
  candidate.stable = minimum.stable;
  candidate.energy = system.energy().total();
  for (const Interval& interval : initial.intervals()) {
    double energy = 0.0;
    for (std::size_t i : problem->topology.cable_spans[interval.cable]) {
      const double s = problem->topology.stations[problem->topology.spans[i].left].arc_length;
      if (s < interval.start - 1e-12 || s >= interval.end - 1e-12) continue;
      for (std::size_t e = 0; e < system.elementCount(i); ++e) energy += system.elementEnergy(i, e);
    }
    candidate.interval_energy.push_back(energy);
  }
  return candidate;
}

// Multi-start on the start grid: the natural routing; then every other bulge, for every second interval at
// once, so that the effort stays linear in the size of the harness; then the best of each interval together.
bool EquilibriumSolver::Impl::search(Equilibrium& result) {
  const InitialShape initial(problem->harness, problem->topology);
  const auto& intervals = initial.intervals();
  std::vector<Candidate> found;
  std::optional<Candidate> saddle;
  const std::vector<Routing> natural(intervals.size());
  std::vector<Routing> best_routing = natural;
  std::vector<double> best_energy(intervals.size(), std::numeric_limits<double>::infinity());
  const double same = kSameShape * problem->length();
  const Grid& grid = problem->system->grid();
  const auto attempt = [&](const std::vector<Routing>& routing) {
    std::optional<Candidate> candidate = tryRouting(initial, routing, result);
    if (!candidate) return;
    if (!candidate->stable) {
      if (!saddle) saddle = std::move(candidate);
      return;
    }
    for (std::size_t i = 0; i < intervals.size(); ++i) {
      if (candidate->interval_energy[i] < best_energy[i]) {
        best_energy[i] = candidate->interval_energy[i];
        best_routing[i] = routing[i];
      }
    }
    const bool known = std::any_of(found.begin(), found.end(), [&](const Candidate& other) {
      return largestDistance(grid, other.configuration, grid, candidate->configuration) < same;
    });
    if (!known) found.push_back(std::move(*candidate));
  };
  attempt(natural);
  const bool hinted =
      std::any_of(intervals.begin(), intervals.end(), [](const Interval& i) { return i.hinted; });
  if (options.multi_start) {
    std::vector<Routing> others;
    for (Routing::Bulge bulge :
         {Routing::Bulge::down, Routing::Bulge::up, Routing::Bulge::left, Routing::Bulge::right}) {
      others.push_back({bulge, 0});
    }
    others.push_back({Routing::Bulge::natural, 1});
    others.push_back({Routing::Bulge::natural, -1});
    for (const Routing& other : others) {
      for (std::size_t parity = 0; parity < 2; ++parity) {
        std::vector<Routing> routing = natural;
        bool any = false;
        for (std::size_t i = parity; i < intervals.size(); i += 2) {
          if (intervals[i].hinted || (other.turns != 0 && !intervals[i].twistable)) continue;
          routing[i] = other;
          any = true;
        }
        if (any) attempt(routing);
      }
    }
    const bool mixed = std::any_of(best_routing.begin(), best_routing.end(), [](const Routing& r) {
      return r.bulge != Routing::Bulge::natural || r.turns != 0;
    });
    if (mixed && intervals.size() > 1) attempt(best_routing);
  }
  unstable = found.empty() && saddle;
  if (unstable) problem->configuration = saddle->configuration;
  if (found.empty()) return unstable;
  // hints choose the natural start's shape, else the lowest energy
  auto chosen = found.begin();
  if (!hinted) {
    chosen = std::min_element(found.begin(), found.end(),
                              [](const Candidate& a, const Candidate& b) { return a.energy < b.energy; });
  }
  std::iter_swap(found.begin(), chosen);
  problem->configuration = found.front().configuration;
  for (std::size_t i = 1; i < found.size(); ++i) {
    result.alternatives.push_back(
        {found[i].energy, largestDistance(grid, found[i].configuration, grid, problem->configuration)});
  }
  std::sort(result.alternatives.begin(), result.alternatives.end(),
            [](const Alternative& a, const Alternative& b) { return a.energy < b.energy; });
  return true;
}

// Refines until the estimated error is below the accuracy asked for. The system ends with its gradient at
// the configuration.
bool EquilibriumSolver::Impl::adaptGrid(Equilibrium& result) {
  for (int round = 0; round <= kRefinements; ++round) {
    const std::vector<CableShape> shapes =
        describeShapes(problem->harness, problem->topology, *problem->system, problem->configuration);
    const Configuration on_coarse =
        onGrid(problem->topology, problem->configuration, shapes, problem->coarse->grid());
    const DiscretisationError error =
        estimateDiscretisation(*problem->system, *problem->coarse, on_coarse, !unstable);
    result.discretisation_error = error.centreline;
    if (error.centreline <= options.accuracy) return true;
    if (round == kRefinements) return false;
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
        onGrid(problem->topology, problem->configuration, shapes, problem->system->grid());
    const Minimum minimum =
        minimise(*problem->system, problem->configuration, {options.max_iterations, unstable, false});
    result.iterations += minimum.iterations;
    result.residual = minimum.residual;
    if (unstable ? !minimum.stationary : !minimum.stable) return false;
  }
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

Equilibrium EquilibriumSolver::Impl::solve(const Harness& harness) {
  const auto start = Clock::now();
  Equilibrium result;
  unstable = false;
  failure.clear();
  problem = std::make_unique<Problem>(harness);
  problem->setGrid(startGrid(problem->harness, problem->topology));
  const auto done = [&] {
    if (!result.converged()) problem.reset();
    result.solve_time = std::chrono::duration<double>(Clock::now() - start).count();
    return result;
  };
  {
    const InitialShape initial(problem->harness, problem->topology);
    const Configuration placed =
        initial.make(problem->system->grid(), std::vector<Routing>(initial.intervals().size()));
    const std::string reason = unreachable(problem->harness, problem->topology, placed, kLargestStretch);
    if (!reason.empty()) {
      result.status = EquilibriumStatus::impossible;
      result.message = reason;
      return done();
    }
  }
  if (!search(result)) {
    result.status = EquilibriumStatus::not_converged;
    result.message = "no start led to an equilibrium: " + failure;
    return done();
  }
  problem->system->evaluate(problem->configuration, RodSystem::Hessian::none);
  if (!adaptGrid(result)) {
    result.status = EquilibriumStatus::not_converged;
    std::ostringstream text;
    text << "the grid could not be refined to the accuracy of " << 1e3 * options.accuracy
         << " mm; estimated error " << 1e3 * result.discretisation_error << " mm; "
         << whereItFailed(problem->harness, problem->topology, *problem->system, problem->configuration);
    result.message = text.str();
    return done();
  }
  finish(result);
  return done();
}

// Carries the shape along to the new harness, to first order.
void EquilibriumSolver::Impl::follow(const Harness& harness) {
  Configuration& configuration = problem->configuration;
  const Configuration before = configuration;
  Topology topology = makeTopology(harness);
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
    const Pose& from = before.stations[i].pose;
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
  if (!problem) return solve(harness);
  if (!sameStructure(problem->harness, problem->topology, harness, makeTopology(harness)))
    return solve(harness);
  const auto start = Clock::now();
  Equilibrium result;
  double turn = 0.0;
  for (std::size_t i = 0; i < harness.clips.size(); ++i) {
    const auto& from = problem->harness.clips[i].pose.orientation;
    turn = std::max(turn, from.angularDistance(harness.clips[i].pose.orientation));
  }
  const int pieces = std::max(1, static_cast<int>(std::ceil(turn / kLargestPiece)));
  const Harness origin = problem->harness;
  for (int k = 1; k <= pieces; ++k) {
    Harness step = harness;
    const double t = static_cast<double>(k) / pieces;
    for (std::size_t i = 0; k < pieces && i < harness.clips.size(); ++i) {
      Pose& pose = step.clips[i].pose;
      const Pose& from = origin.clips[i].pose;
      pose.position = (1.0 - t) * from.position + t * pose.position;
      pose.orientation = from.orientation.slerp(t, pose.orientation);
    }
    follow(step);
    const Minimum minimum =
        minimise(*problem->system, problem->configuration, {options.max_iterations, unstable, false});
    result.iterations += minimum.iterations;
    result.residual = minimum.residual;
    if (minimum.stable) continue;
    return solve(harness);  // the branch ends here
  }
  const std::string reason =
      unreachable(problem->harness, problem->topology, problem->configuration, kLargestStretch);
  if (!reason.empty() || !adaptGrid(result)) return solve(harness);
  finish(result);
  if (!result.converged()) problem.reset();
  result.solve_time = std::chrono::duration<double>(Clock::now() - start).count();
  return result;
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

Equilibrium EquilibriumSolver::solve(const Harness& harness) { return impl_->solve(harness); }
Equilibrium EquilibriumSolver::update(const Harness& harness) { return impl_->update(harness); }

}  // namespace cable_variation
