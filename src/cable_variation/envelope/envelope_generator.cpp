#include <cable_variation/envelope/envelope_generator.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include <tbb/parallel_for.h>

#include <cable_variation/envelope/design_searches.h>
#include <cable_variation/envelope/envelope_assembly.h>
#include <cable_variation/envelope/envelope_check.h>
#include <cable_variation/envelope/envelope_memory.h>
#include <cable_variation/envelope/envelope_tightness.h>
#include <cable_variation/envelope/envelope_verification.h>
#include <cable_variation/envelope/envelope_warning.h>
#include <cable_variation/envelope/search/phase_search.h>
#include <cable_variation/envelope/search/random_place.h>
#include <cable_variation/envelope/snap_shares.h>
#include <cable_variation/envelope/statistical_envelope.h>
#include <cable_variation/equilibrium/require_converged.h>
#include <cable_variation/tracking/motion_phases.h>
#include <cable_variation/util/chosen_indices.h>
#include <cable_variation/util/number_text.h>
#include <cable_variation/util/seconds_since.h>
#include <cable_variation/util/thread_limit.h>

namespace cable_variation {
namespace {

// A facet that would move out by less than this share of the margin is left.
constexpr double kWorthwhile = 0.4;
// Rounds of looking at random shapes and taking in those that stick out, and the most of each.
constexpr int kRounds = 8;
constexpr std::size_t kLookedAt = 2000;
// Where shapes are rare, so many more like them in each round, and in the last, which says how far pieces are
// rounded there; each takes as long as a hundred usual ones. Over a motion no pieces are rounded by them, so
// the last has no more.
constexpr std::size_t kLikeRare = 200, kLikeRareLast = 400;
// Pieces are rounded by so many times what random shapes stick out by: others will stick out further.
constexpr double kRounding = 2.0;
// Of shapes that stick out of the finished envelope so many are taken in at most.
constexpr std::size_t kMostHeld = 1000;
// Random shapes that stick out by more than this share of the margin are taken in; in phases that leave more
// than worthwhile gains, by so much more.
constexpr double kTakenIn = 0.5;
// Stretches are as long as this many radii of the thinnest cable.
constexpr double kLongestStretch = 2.0;
// Phases of a motion are as far as so many radii any way, further where they go straight to so many.
constexpr double kStride = 0.5, kReach = 3.0, kBow = 0.05;
// Solves of all phases together, and of each at most and at least, after which, again and again, half as much
// is asked for: small gains come without end near snaps, and over long ways.
constexpr std::size_t kPatience = kSolvesOverMotion, kMostPatience = 150, kLeastPatience = 24;
// Of more phases than this each forgets the derivatives of its shapes when it is done, and of fewer if they
// take too much memory.
constexpr std::size_t kFewPhases = 64;
// A section turns as much as a clip near it, and the cable moves aside by that turn times some of its length.
constexpr double kLever = 0.25;
constexpr double kConfidence = 0.95;
// The first search leaves some of the solves to those that start from random shapes.
constexpr double kFirstSearch = 0.6;
// Tell the random numbers of all kinds of shapes apart, and from those of a PointSet.
constexpr std::uint32_t kContainmentStream = 3, kTightnessStream = 4;

// What shapes stick out by at most, usual ones and those of RandomShape::of_rare [m].
struct Protrusions {
  double usual = 0.0, rare = 0.0;
};

Protrusions largestProtrusions(const std::vector<RandomShape>& shapes) {
  Protrusions largest;
  for (const RandomShape& shape : shapes) {
    if (!shape.converged) continue;
    if (shape.of_rare) {
      largest.rare = std::max(largest.rare, *shape.of_rare);
    } else {
      largest.usual = std::max(largest.usual, shape.protrusion);
    }
  }
  return largest;
}

class Generator {
 public:
  Generator(const Scene& scene, const EnvelopeOptions& options, const EquilibriumSolver& solver,
            const ProgressObserver& observer, const SolvedWitness& witness)
      : options_(checkedOptions(scene, options)),
        space_(scene, options_),
        solver_(solver),
        report_(observer),
        witness_(witness) {
    EquilibriumOptions of;
    of.accuracy = scene.accuracy;
    of.eigenvalue = false;
    solver_.setOptions(of);
    frames_ = {"world"};
    frames_.insert(frames_.end(), options_.frames.begin(), options_.frames.end());
    for (const Motion* motion : space_.motions()) end_ = std::max(end_, motion->duration());
    if (options_.to >= 0.0) end_ = options_.to;
    if (space_.motions().empty()) end_ = options_.from;
    if (!(options_.from <= end_)) {
      std::ostringstream text;
      text << "from " << options_.from << " s to " << end_ << " s; expected times in order";
      throw std::invalid_argument(text.str());
    }
  }

  Envelope run() {
    const auto start = Clock::now();
    prepare();
    if (options_.probability > 0.0) {
      holdProduction();
    } else {
      runSearches(allIndices(searches_.size()),
                  static_cast<std::size_t>(kFirstSearch * static_cast<double>(options_.largest_solves)));
      learn();
      envelope_.solve_time = secondsSince(start);
      verify();
    }
    assemble();
    measureTightness();
    const double all = secondsSince(start);
    if (options_.probability > 0.0) envelope_.solve_time = all;
    envelope_.verify_time = all - envelope_.solve_time;
    return std::move(envelope_);
  }

 private:
  // The design at the start of the motion, the stretches of its cables, the phases.
  void prepare() {
    const SamplePlace start = space_.designAt(options_.from);
    const Harness harness = space_.harness(start);
    const Equilibrium equilibrium = solver_.update(harness);
    requireConverged(equilibrium, "the design has no equilibrium");
    double thinnest = std::numeric_limits<double>::infinity(), longest = 0.0;
    for (const std::size_t cable : options_.cables) {
      thinnest = std::min(thinnest, equilibrium.shapes[cable].radius);
      longest = std::max(longest, harness.cables[cable].length);
    }
    for (const std::size_t cable : options_.cables) {
      const CableView view(harness.cables[cable], equilibrium.shapes[cable]);
      const auto own = cutIntoStretches(cable, view, kLongestStretch * thinnest, options_.cuts);
      stretches_.insert(stretches_.end(), own.begin(), own.end());
    }
    memory_ = EnvelopeMemory(reader_.readWithRates(start, harness, equilibrium, solver_), equilibrium);
    refuseMoreThanMemory(options_, memory_, equilibrium);
    const PhaseRule rule{kStride * thinnest, kReach * thinnest, kBow * thinnest, kLever * longest,
                         memory_.mostPhases(options_.memory_limit)};
    phases_ = cutIntoPhases(space_, frames_, options_.from, end_, rule, &wanted_phases_);
    searches_ =
        searchesAlongDesign(reader_, solver_, phases_, kWorthwhile * options_.margin, report_, envelope_);
    for (PhaseSearch& search : searches_) {
      search.setMostShapes(memory_.mostShapes(options_.memory_limit, phases_.size()));
      if (options_.probability == 0.0) search.setWitness(witness_);
    }
  }

  // Each phase is looked through by itself.
  void runSearches(const std::vector<std::size_t>& which, std::size_t largest_solves) {
    std::atomic<std::size_t> done{0}, solved{0};
    tbb::parallel_for(std::size_t{0}, which.size(), [&](std::size_t i) {
      PhaseSearch& search = searches_[which[i]];
      search.run(largest_solves, patience(), [&] {
        report_({"shapes", 0.1 + 0.5 * static_cast<double>(done) / static_cast<double>(which.size()),
                 solved + search.solves(), search.follower().referenceTime()});
      });
      if (mustForget()) search.forgetRates();
      ++done;
      solved += search.solves();
    });
  }

  // Whether the derivatives of all phases' shapes would be too many to keep.
  bool mustForget() const {
    if (searches_.size() == 1) return false;
    const double kept = static_cast<double>(searches_.size() * kMostPatience) * memory_.shape;
    return searches_.size() > kFewPhases || kept > EnvelopeMemory::kForSearches * options_.memory_limit;
  }

  std::size_t patience() const {
    if (searches_.size() == 1) return options_.largest_solves;
    return std::clamp(kPatience / searches_.size(), kLeastPatience, kMostPatience);
  }

  // Random shapes that stick out are taken in, until a round of others finds none. Where shapes are few, and
  // random ones hardly ever come, others like them are looked at too. Then the inflation is fixed.
  void learn() {
    Protrusions last;
    LearningPlaces places{
        space_, options_.from, end_, options_.seed, std::min(options_.verification, kLookedAt), {}};
    for (int round = 0; options_.verification > 0; ++round) {
      const std::vector<RandomShape> shapes = look(places.ofRound(round, likeRare(round)), round);
      last = largestProtrusions(shapes);
      const bool well = std::all_of(shapes.begin(), shapes.end(),
                                    [&](const RandomShape& shape) { return !sticksOut(shape); });
      if (well) break;
      if (round == kRounds) {
        double most = 0.0;
        for (const RandomShape& shape : shapes)
          most = std::max(most, shape.converged ? shape.protrusion : 0.0);
        warn(envelope_, "random shapes still stick out by ", 1e3 * most, " mm after ", round,
             " rounds of taking them in");
        break;
      }
      takeIn(shapes);
      places.rare = rarePlaces(shapes);
    }
    for (PhaseSearch& search : searches_) search.keepSlices();
    // Facets may still move out by what was not worthwhile; random shapes have missed the worst place by
    // some. Rare shapes are few and far apart, so others stick out further, but only near pieces of theirs.
    if (!options_.conservative) return;
    envelope_.inflation = kRounding * std::max(last.usual, kWorthwhile * options_.margin);
    const double beyond = std::max(0.0, kRounding * last.rare - envelope_.inflation);
    if (beyond > 0.0) searches_.front().roundRare(beyond);
    envelope_.largest_inflation = envelope_.inflation + beyond;
  }

  std::size_t likeRare(int round) const {
    return round == kRounds && searches_.size() == 1 ? kLikeRareLast : kLikeRare;
  }

  std::vector<SamplePlace> rarePlaces(const std::vector<RandomShape>& shapes) const {
    std::vector<SamplePlace> rare;
    for (const PhaseSearch& search : searches_) {
      const std::vector<SamplePlace> own = search.rarePlaces();
      rare.insert(rare.end(), own.begin(), own.end());
    }
    for (const RandomShape& shape : shapes) {
      if (sticksOut(shape)) rare.push_back(shape.place);
    }
    return rare;
  }

  // @param round kRounds: verification
  LookOptions lookOptions(int round, std::size_t count) {
    LookOptions looking;
    looking.witness = witness_;
    looking.progress = [this, round, count](std::size_t done) {
      const double share = static_cast<double>(done) / static_cast<double>(count);
      // a round is a fifth of what is left
      const double left = 0.4 * std::pow(0.8, round);
      const double to = round == kRounds ? 1.0 : 0.2;
      report_({"containment", 0.9 - left * (1.0 - to * share), done, options_.from});
    };
    return looking;
  }

  std::vector<RandomShape> look(const std::vector<SamplePlace>& places, int round) {
    return lookAt(searches_, places, lookOptions(round, places.size()));
  }

  // Fresh shapes, once: what they tell is true of the envelope as it is now. Those outside are taken in
  // afterwards, which makes the share outside smaller yet.
  void verify() {
    if (options_.verification == 0) return;
    const CounterRandom random(options_.seed, kContainmentStream);
    ContainmentCount count(envelope_.inflation);
    std::vector<RandomShape> outside;
    lookInBlocks(
        searches_, options_.verification,
        [&](std::size_t i) { return drawPlace(space_, options_.from, end_, random, i); },
        lookOptions(kRounds, options_.verification),
        [&](std::size_t first, const std::vector<RandomShape>& shapes) {
          count.add(shapes, stretches_);
          for (std::size_t i = 0; i < shapes.size(); ++i) {
            if (count.isOutside(shapes[i]) && outside.size() < kMostHeld) outside.push_back(shapes[i]);
            if (isDrawnEvenly(first + i)) shares_.count(shapes[i]);
          }
        });
    envelope_.containment = count.result(false, kConfidence);
    if (options_.conservative && !outside.empty()) {
      warn(envelope_, envelope_.containment.outside, " of ", envelope_.containment.shapes,
           " shapes drawn after the envelope was finished stick out of it by up to ",
           1e3 * envelope_.containment.largest_excess, " mm; it has been made to hold ", outside.size(),
           " of these too");
      hold(outside);
    }
  }

  void holdProduction() {
    const StatisticalPlan plan = planFor(options_.probability, options_.verification, stretches_.size());
    const Sampler sampler = productionSampler(space_.scene(), options_, plan.samples());
    const StatisticalResult result =
        holdShareOfProduction(searches_, sampler, plan, witness_, [&](double share, std::size_t done) {
          report_({share < 0.4 ? "shapes" : "containment", 0.9 * share, done, options_.from});
        });
    envelope_.probability = plan.probability;
    envelope_.inflation = envelope_.largest_inflation = result.inflation;
    envelope_.containment = result.containment;
    envelope_.draws = result.draws;
    if (!result.shown) {
      warn(envelope_, "that a share of ", numberText(plan.probability),
           " of production is held could not be shown in ", result.looks, " looks at fresh shapes: up to ",
           100.0 * result.containment.outside_bound, " % may stick out");
    }
    shares_.count(result.containment.shapes - result.containment.failed, result.snapped);
  }

  // What a random shape may stick out of a phase without being taken in [m].
  double allowed(std::size_t phase) const { return kTakenIn / kWorthwhile * searches_[phase].tolerance(); }

  bool sticksOut(const RandomShape& shape) const {
    return shape.converged && shape.protrusion > allowed(shape.phase);
  }

  // Shapes that stick out, solved again with their rates.
  std::vector<std::size_t> hold(const std::vector<RandomShape>& outside) {
    std::vector<FollowedShape> solved(outside.size());
    tbb::parallel_for(std::size_t{0}, outside.size(), [&](std::size_t i) {
      solved[i] = searches_[outside[i].phase].follower().follow(outside[i].place, true);
    });
    std::vector<std::size_t> changed;
    for (std::size_t i = 0; i < outside.size(); ++i) {
      searches_[outside[i].phase].add(solved[i]);
      changed.push_back(outside[i].phase);
    }
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    for (const std::size_t phase : changed) searches_[phase].rebuild();
    return changed;
  }

  void takeIn(const std::vector<RandomShape>& shapes) {
    std::vector<RandomShape> outside;
    for (const RandomShape& shape : shapes) {
      if (sticksOut(shape)) outside.push_back(shape);
    }
    runSearches(hold(outside), options_.largest_solves);
  }

  void assemble() {
    envelope_.cables = options_.cables;
    envelope_.variables = options_.variables;
    assembleEnvelope(searches_, options_.largest_solves, envelope_);
    shares_.tell(envelope_.snaps, kConfidence);
    for (std::size_t i = 0; i < phases_.size(); ++i) {
      envelope_.phases[i].excess = phases_[i].excess;
      envelope_.motion_excess = std::max(envelope_.motion_excess, phases_[i].excess);
    }
    if (phases_.size() > 1) {
      warnOfCoarsening(searches_, wanted_phases_, memory_.mostPhases(options_.memory_limit),
                       options_.memory_limit, kWorthwhile * options_.margin, envelope_);
    }
  }

  // With shapes drawn apart from those for containment; with a probability, those of production that are
  // held.
  void measureTightness() {
    const CounterRandom random(options_.seed, kTightnessStream);
    std::optional<ContainmentCheck> check;
    std::optional<Sampler> production;
    if (options_.probability > 0.0 && options_.tightness > 0) {
      check.emplace(searches_);
      EnvelopeOptions others = options_;
      others.seed = ~options_.seed;
      production.emplace(productionSampler(space_.scene(), others, options_.tightness));
    }
    const ToleranceSpace& tolerances = space_.tolerances();
    const auto draw = [&](std::size_t index) -> std::optional<StretchShape> {
      const SamplePlace place = production ? productionPlace(*production, index, options_.from)
                                           : drawPlace(space_, options_.from, end_, random, index);
      const std::size_t phase = phaseAt(searches_, place.time);
      FollowedShape followed = searches_[phase].follower().follow(place, false);
      if (!followed.converged) return std::nullopt;
      if (check && check->look(place, phase, followed).protrusion > envelope_.inflation) return std::nullopt;
      if (!check) tellOf(followed, tolerances, witness_);
      return std::move(followed.shape);
    };
    envelope_.tightness = tightnessOf(
        envelope_.frames.front().pieces, options_.voxel, options_.tightness,
        EnvelopeMemory::kForVoxels * options_.memory_limit, draw, [&](std::size_t done) {
          const double share = static_cast<double>(done) / static_cast<double>(options_.tightness);
          report_({"tightness", 0.9 + 0.1 * share, done, 0.0});
        });
  }

  EnvelopeOptions options_;
  SampleSpace space_;
  EquilibriumSolver solver_;
  ProgressReporter report_;
  const SolvedWitness& witness_;
  double end_ = 0.0;
  EnvelopeMemory memory_;
  std::vector<std::string> frames_;
  std::vector<MaterialStretch> stretches_;
  StretchReader reader_{space_, stretches_, frames_};
  std::vector<MotionPhase> phases_;
  std::size_t wanted_phases_ = 1;
  std::vector<PhaseSearch> searches_;
  SnapShares shares_{searches_};
  Envelope envelope_;
};

}  // namespace

Envelope generateEnvelope(const Scene& scene, const EnvelopeOptions& options, const EquilibriumSolver& solver,
                          const ProgressObserver& observer, const SolvedWitness& witness) {
  requireNoContact(scene.harness, "envelopes");
  Envelope envelope;
  withThreads(options.threads,
              [&] { envelope = Generator(scene, options, solver, observer, witness).run(); });
  return envelope;
}

}  // namespace cable_variation
