#include <cable_variation/harness/start_search.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include <cable_variation/harness/equilibrium_result.h>
#include <cable_variation/harness/initial_shape.h>

namespace cable_variation {
namespace {

// Shapes closer than this share of the harness's length are the same equilibrium.
constexpr double kSameShape = 1e-3;

// A stationary shape that a start led to.
struct Candidate {
  bool stable = false;
  Configuration configuration;
  double energy = 0.0;
  std::vector<double> interval_energy;
};

class Search {
 public:
  Search(Problem& problem, const EquilibriumOptions& options, Equilibrium& result)
      : problem_(problem),
        options_(options),
        result_(result),
        initial_(problem.harness, problem.topology),
        best_routing_(initial_.intervals().size()),
        best_energy_(initial_.intervals().size(), std::numeric_limits<double>::infinity()) {}

  SearchResult run() {
    const std::vector<Routing> natural(best_routing_.size());
    attempt(natural);
    if (options_.multi_start) tryOthers(natural);
    SearchResult search;
    search.failure = failure_;
    search.stable = !found_.empty();
    search.found = search.stable || saddle_;
    if (search.stable) {
      choose();
    } else if (saddle_) {
      problem_.configuration = saddle_->configuration;
    }
    return search;
  }

 private:
  void tryOthers(const std::vector<Routing>& natural) {
    using Bulge = Routing::Bulge;
    const Routing others[] = {{Bulge::down, 0},  {Bulge::up, 0},      {Bulge::left, 0},
                              {Bulge::right, 0}, {Bulge::natural, 1}, {Bulge::natural, -1}};
    const auto& intervals = initial_.intervals();
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
    const bool mixed = std::any_of(best_routing_.begin(), best_routing_.end(), [](const Routing& r) {
      return r.bulge != Bulge::natural || r.turns != 0;
    });
    if (mixed && intervals.size() > 1) attempt(best_routing_);
  }

  void attempt(const std::vector<Routing>& routing) {
    std::optional<Candidate> candidate = descend(routing);
    if (!candidate) return;
    if (!candidate->stable) {
      if (!saddle_) saddle_ = std::move(candidate);
      return;
    }
    for (std::size_t i = 0; i < routing.size(); ++i) {
      if (candidate->interval_energy[i] < best_energy_[i]) {
        best_energy_[i] = candidate->interval_energy[i];
        best_routing_[i] = routing[i];
      }
    }
    const bool known = std::any_of(found_.begin(), found_.end(), [&](const Candidate& other) {
      return distance(other.configuration, candidate->configuration) < kSameShape * problem_.length();
    });
    if (!known) found_.push_back(std::move(*candidate));
  }

  // From one start to a stationary shape.
  std::optional<Candidate> descend(const std::vector<Routing>& routing) {
    RodSystem& system = *problem_.system;
    Candidate candidate;
    candidate.configuration = initial_.make(system.grid(), routing);
    const Minimum minimum = minimise(system, candidate.configuration, {options_.max_iterations, false, true});
    result_.iterations += minimum.iterations;
    result_.residual = minimum.residual;
    if (!minimum.stationary) {
      if (failure_.empty()) {
        failure_ = whereItFailed(problem_.harness, problem_.topology, system, candidate.configuration);
      }
      return std::nullopt;
    }
    candidate.stable = minimum.stable;
    candidate.energy = system.energy().total();
    for (const Interval& interval : initial_.intervals()) {
      double energy = 0.0;
      for (std::size_t i : problem_.topology.cable_spans[interval.cable]) {
        const double s = problem_.topology.stations[problem_.topology.spans[i].left].arc_length;
        if (s < interval.start || s >= interval.end) continue;
        for (std::size_t e = 0; e < system.elementCount(i); ++e) energy += system.elementEnergy(i, e);
      }
      candidate.interval_energy.push_back(energy);
    }
    return candidate;
  }

  void choose() {
    std::sort(found_.begin(), found_.end(),
              [](const Candidate& a, const Candidate& b) { return a.energy < b.energy; });
    problem_.configuration = found_.front().configuration;
    for (std::size_t i = 1; i < found_.size(); ++i) {
      result_.alternatives.push_back(
          {found_[i].energy, distance(found_[i].configuration, problem_.configuration)});
    }
  }

  double distance(const Configuration& a, const Configuration& b) const {
    return largestDistance(problem_.system->grid(), a, problem_.system->grid(), b);
  }

  Problem& problem_;
  const EquilibriumOptions& options_;
  Equilibrium& result_;
  InitialShape initial_;
  std::vector<Candidate> found_;
  std::optional<Candidate> saddle_;
  std::vector<Routing> best_routing_;
  std::vector<double> best_energy_;
  std::string failure_;
};

}  // namespace

SearchResult searchStarts(Problem& problem, const EquilibriumOptions& options, Equilibrium& result) {
  return Search(problem, options, result).run();
}

}  // namespace cable_variation
