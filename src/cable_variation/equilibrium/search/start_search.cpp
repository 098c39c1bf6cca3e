#include <cable_variation/equilibrium/search/start_search.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <cable_variation/equilibrium/discretisation/contact_result.h>
#include <cable_variation/equilibrium/discretisation/equilibrium_result.h>
#include <cable_variation/equilibrium/search/initial_shape.h>
#include <cable_variation/equilibrium/search/minimise.h>
#include <cable_variation/equilibrium/search/slide_starts.h>
#include <cable_variation/equilibrium/search/twist.h>

namespace cable_variation {
namespace {

// Shapes closer than this share of the harness's length are the same equilibrium.
constexpr double kSameShape = 1e-3;
// And of the same energy: one with a turn more may have the same centreline.
constexpr double kSameEnergy = 1e-6;
constexpr int kBriefly = 60;  // Newton steps

struct Candidate {
  bool stable = false;
  FoundShape shape;
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
    attempt(std::vector<Routing>(best_routing_.size()));
    if (!found_.minima.empty()) natural_ = found_.minima.front().configuration;
    if (options_.multi_start) {
      bulgeTogether();
      tryOthers();
    }
    takeOutTurns();
    findCarriedLoads();
    sort();
    if (!found_.minima.empty()) found_.saddles.clear();
    return found_;
  }

 private:
  using Bulge = Routing::Bulge;
  // Every second piece of cable routed as `even`, the others as `odd`, as far as they may; nothing when none
  // may.
  std::optional<std::vector<Routing>> routed(const Routing& even, const Routing& odd) const {
    const auto& intervals = initial_.intervals();
    std::vector<Routing> routing(intervals.size());
    bool any = false;
    for (std::size_t i = 0; i < intervals.size(); ++i) {
      const Routing& wanted = i % 2 == 0 ? even : odd;
      if (intervals[i].hinted || (wanted.turns != 0 && !intervals[i].twistable)) continue;
      if (wanted.bulge == Bulge::stress_free && !intervals[i].preformed) continue;
      routing[i] = wanted;
      any = any || wanted.bulge != Bulge::natural || wanted.turns != 0;
    }
    return any ? std::make_optional(routing) : std::nullopt;
  }

  std::optional<std::vector<Routing>> routed(Bulge even, Bulge odd) const {
    return routed(Routing{even, 0}, Routing{odd, 0});
  }

  // All pieces bulge the same way, wherever sliding clips start: which shape is lowest depends on both at
  // once. What follows starts with sliding clips where the lowest of these shapes came from.
  void bulgeTogether() {
    constexpr Bulge kWays[] = {Bulge::down, Bulge::up, Bulge::left, Bulge::right};
    double lowest = found_.minima.empty() ? INFINITY : found_.minima.front().energy;
    std::vector<double> best;
    const auto consider = [&](const std::optional<std::vector<Routing>>& routing) {
      const double energy = routing ? attempt(*routing) : INFINITY;
      if (!(energy < lowest)) return;
      lowest = energy;
      best = arc_lengths_;
    };
    consider(routed(Bulge::stress_free, Bulge::stress_free));
    for (const Bulge way : kWays) consider(routed(way, way));
    std::size_t next = 0;
    for (std::vector<double>& start : slideStarts(problem_.harness, problem_.topology)) {
      arc_lengths_ = std::move(start);
      consider(std::vector<Routing>(initial_.intervals().size()));
      const Bulge way = kWays[next++ % std::size(kWays)];
      consider(routed(way, way));
    }
    arc_lengths_ = best;
  }

  // Every second piece another way than its neighbours, a turn more or less, and each piece as it was best.
  void tryOthers() {
    if (best_routing_.size() > 1) {
      constexpr std::pair<Bulge, Bulge> kApart[] = {
          {Bulge::stress_free, Bulge::natural}, {Bulge::natural, Bulge::stress_free},
          {Bulge::down, Bulge::natural},        {Bulge::up, Bulge::natural},
          {Bulge::natural, Bulge::left},        {Bulge::natural, Bulge::right}};
      for (const auto& [even, odd] : kApart) {
        if (const auto routing = routed(even, odd)) attempt(*routing);
      }
    }
    for (const int turns : {1, -1}) {
      const Routing turned{Bulge::natural, turns};
      if (const auto routing = routed(turned, turned)) attempt(*routing);
    }
    const bool mixed = std::any_of(best_routing_.begin(), best_routing_.end(), [](const Routing& r) {
      return r.bulge != Bulge::natural || r.turns != 0;
    });
    if (mixed && best_routing_.size() > 1) attempt(best_routing_);
  }

  void sort() {
    std::stable_sort(found_.minima.begin(), found_.minima.end(),
                     [](const FoundShape& a, const FoundShape& b) {
                       return std::make_pair(a.departures, a.energy) < std::make_pair(b.departures, b.energy);
                     });
  }

  // Large steps can carry a load right over to where it has nothing left to press against. It is expected
  // near where the natural start leaves it: within the length of its cable.
  void findCarriedLoads() {
    if (!natural_) return;
    for (FoundShape& shape : found_.minima) {
      for (std::size_t i = 0; i < problem_.topology.stations.size(); ++i) {
        const Station& station = problem_.topology.stations[i];
        const bool loaded = std::any_of(station.loads.begin(), station.loads.end(), [&](std::size_t load) {
          return !problem_.harness.loads[load].force.isZero(0.0);
        });
        const double way =
            (shape.configuration.stations[i].pose.position - natural_->stations[i].pose.position).norm();
        if (loaded && way > problem_.harness.cables[station.cable].length) ++shape.departures;
      }
    }
  }

  // Long soft cables gather turns in large steps, and lose those asked for: then the shape with the right
  // turns is looked for next to the one with the wrong ones.
  void takeOutTurns() {
    constexpr int kRounds = 3;
    for (int round = 0; round < kRounds && !found_.minima.empty(); ++round) {
      sort();
      const Configuration& lowest = found_.minima.front().configuration;
      const std::vector<TwistPiece> pieces = twistPieces(problem_.harness, problem_.topology, lowest);
      const bool right = std::all_of(pieces.begin(), pieces.end(),
                                     [](const TwistPiece& piece) { return piece.surplus == 0; });
      if (right) return;
      const std::size_t before = found_.minima.size();
      take(descend(
          withoutSurplus(problem_.harness, problem_.topology, problem_.system->grid(), lowest, pieces),
          StartStress::own));
      if (found_.minima.size() == before) return;
    }
  }

  // The energy of the minimum that a start leads to [J]; infinite: to none.
  double attempt(const std::vector<Routing>& routing) {
    const std::optional<Candidate> candidate =
        take(descend(initial_.make(problem_.system->grid(), routing, arc_lengths_), StartStress::none));
    if (!candidate) return INFINITY;
    for (std::size_t i = 0; i < routing.size(); ++i) {
      if (candidate->interval_energy[i] < best_energy_[i]) {
        best_energy_[i] = candidate->interval_energy[i];
        best_routing_[i] = routing[i];
      }
    }
    return candidate->shape.energy;
  }

  // Puts a stationary shape to those found; returns it when it is a minimum.
  std::optional<Candidate> take(std::optional<Candidate> candidate) {
    if (!candidate) return std::nullopt;
    if (!candidate->stable) {
      if (found_.saddles.empty()) found_.saddles.push_back(std::move(candidate->shape));
      return std::nullopt;
    }
    const Grid& grid = problem_.system->grid();
    const bool known = std::any_of(found_.minima.begin(), found_.minima.end(), [&](const FoundShape& other) {
      const double apart = std::abs(other.energy - candidate->shape.energy);
      return apart <= kSameEnergy * (std::abs(other.energy) + std::abs(candidate->shape.energy)) &&
             largestDistance(grid, other.configuration, grid, candidate->shape.configuration) <
                 kSameShape * problem_.length();
    });
    if (!known) found_.minima.push_back(candidate->shape);
    return candidate;
  }

  // Whether a start passes through no part that its cables have contact with; nothing is known of their
  // forces then.
  bool isOutside(const Configuration& start) {
    ContactSystem& contact = *problem_.system->contact();
    contact.forget();
    contact.soften(ContactSystem::kSoft);
    const std::optional<std::size_t> crossed = contact.crossed(start);
    if (!crossed) return true;
    if (found_.failure.empty()) found_.failure = passesThrough(problem_.harness, *crossed);
    return false;
  }

  // From one start to a stationary shape.
  std::optional<Candidate> descend(Configuration start, StartStress stress) {
    RodSystem& system = *problem_.system;
    if (system.contact() && !isOutside(start)) return std::nullopt;
    Candidate candidate;
    Configuration& configuration = candidate.shape.configuration;
    configuration = std::move(start);
    // Cables that creep along a part are given up sooner once another shape is known.
    const bool briefly = system.contact() && !found_.minima.empty();
    const int most = briefly ? std::min(kBriefly, options_.max_iterations) : options_.max_iterations;
    const Minimum minimum = minimise(system, configuration, {most, false, stress, true, options_.descent});
    result_.iterations += minimum.iterations;
    result_.residual = minimum.residual;
    if (!minimum.stationary()) {
      if (found_.failure.empty()) {
        found_.failure = whereItFailed(problem_.harness, problem_.topology, system, configuration) +
                         "; the first start's descent ended: " + toString(minimum.end);
      }
      return std::nullopt;
    }
    candidate.stable = minimum.stable();
    candidate.shape.energy = system.energy().total();
    for (const TwistPiece& piece : twistPieces(problem_.harness, problem_.topology, configuration)) {
      if (problem_.harness.cables[piece.cable].twist) candidate.shape.departures += std::abs(piece.surplus);
    }
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

  Problem& problem_;
  const EquilibriumOptions& options_;
  Equilibrium& result_;
  InitialShape initial_;
  std::vector<double> arc_lengths_;       // of the stations, to start from; empty: as the topology has them
  std::optional<Configuration> natural_;  // the minimum that the natural start leads to
  SearchResult found_;
  std::vector<Routing> best_routing_;
  std::vector<double> best_energy_;
};

}  // namespace

SearchResult searchStarts(Problem& problem, const EquilibriumOptions& options, Equilibrium& result) {
  return Search(problem, options, result).run();
}

}  // namespace cable_variation
