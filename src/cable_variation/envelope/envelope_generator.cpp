#include <cable_variation/envelope/envelope_generator.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <mutex>
#include <sstream>
#include <stdexcept>

#include <tbb/parallel_for.h>

#include <cable_variation/util/seconds_since.h>
#include <cable_variation/util/thread_limit.h>
#include <cable_variation/util/chosen_indices.h>
#include <cable_variation/statistics/confidence.h>
#include <cable_variation/envelope/envelope_assembly.h>
#include <cable_variation/envelope/envelope_memory.h>
#include <cable_variation/envelope/envelope_tightness.h>
#include <cable_variation/envelope/envelope_verification.h>
#include <cable_variation/envelope/envelope_warning.h>
#include <cable_variation/tracking/motion_phases.h>
#include <cable_variation/envelope/search/phase_search.h>
#include <cable_variation/envelope/search/random_place.h>
#include <cable_variation/envelope/statistical_envelope.h>

namespace cable_variation {
namespace {

// A facet that would move out by less than this share of the margin is left.
constexpr double kWorthwhile = 0.4;
// Rounds of looking at random shapes and taking in those that stick out, and the most of each.
constexpr int kRounds = 8;
constexpr std::size_t kLookedAt = 2000;
// Of shapes that stick out of the finished envelope so many are taken in at most.
constexpr std::size_t kMostHeld = 1000;
// Random shapes that stick out by more than this share of the margin are taken in; in phases that leave more
// than worthwhile gains, by so much more.
constexpr double kTakenIn = 0.5;
// Stretches are as long as this many radii of the thinnest cable.
constexpr double kLongestStretch = 2.0;
// Phases of a motion are as far as so many radii any way, further where they go straight to so many.
constexpr double kStride = 0.5, kReach = 3.0, kBow = 0.05;
// Times of a phase that the design is followed through from one phase to the next.
constexpr std::size_t kFollowedTimes = 4;
// Solves of all phases together, and of each at most and at least, after which, again and again, half as much
// is asked for: small gains come without end near snaps, and over long ways.
constexpr std::size_t kPatience = 20000, kMostPatience = 150, kLeastPatience = 24;
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

void requirePositive(const char* name, double value, const char* unit) {
  if (value > 0.0 && std::isfinite(value)) return;
  std::ostringstream text;
  text << name << ": " << value << unit << "; expected above 0";
  throw std::invalid_argument(text.str());
}

// Reports progress, one thread at a time, and stops when asked to.
class Reporter {
 public:
  explicit Reporter(const EnvelopeObserver& observer) : observer_(observer) {}

  void operator()(const EnvelopeProgress& progress) {
    if (!observer_) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!stopped_) stopped_ = !observer_(progress);
    if (stopped_) throw Cancelled();
  }

 private:
  const EnvelopeObserver& observer_;
  std::mutex mutex_;
  bool stopped_ = false;
};

class Generator {
 public:
  Generator(const Scene& scene, const EnvelopeOptions& options, const EquilibriumSolver& solver,
            const EnvelopeObserver& observer, const SolvedWitness& witness)
      : options_(checked(scene, options)),
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
  static EnvelopeOptions checked(const Scene& scene, EnvelopeOptions options) {
    requirePositive("margin", options.margin, " m");
    requirePositive("memory_limit", options.memory_limit, " B");
    if (!(options.from >= 0.0) || !std::isfinite(options.from) || !std::isfinite(options.to))
      throw std::invalid_argument("from and to: expected times of at least 0 s");
    if (options.probability != 0.0) {
      planFor(options.probability, options.verification, 1);  // refuses what is none
      std::ostringstream text;
      text << "probability: " << options.probability;
      if (!options.motions.empty()) {
        throw std::invalid_argument(text.str() +
                                    " over motions; expected no motions, or 0: all that the "
                                    "tolerances allow");
      }
      if (!options.conservative)
        throw std::invalid_argument(text.str() + " without inflation; expected a conservative envelope");
    } else if (options.conservative && options.verification == 0) {
      throw std::invalid_argument("verification: 0 shapes; expected at least 1 for a conservative envelope");
    }
    options.cables = allOrChosen(options.cables, scene.harness.cables.size(), "cable");
    if (options.cables.empty()) throw std::invalid_argument("the scene has no cables");
    for (const std::string& frame : options.frames) componentPose(scene, frame);
    return options;
  }

  // The design at the start of the motion, the stretches of its cables, the phases.
  void prepare() {
    const SamplePlace start = space_.designAt(options_.from);
    const Harness harness = space_.harness(start);
    const Equilibrium equilibrium = solver_.update(harness);
    if (!equilibrium.converged())
      throw std::runtime_error("the design has no equilibrium: " + equilibrium.message);
    double thinnest = std::numeric_limits<double>::infinity(), longest = 0.0;
    for (const std::size_t cable : options_.cables) {
      thinnest = std::min(thinnest, equilibrium.shapes[cable].radius);
      longest = std::max(longest, harness.cables[cable].length);
    }
    for (const std::size_t cable : options_.cables) {
      const CableView view(harness.cables[cable], equilibrium.shapes[cable]);
      const auto own = cutIntoStretches(cable, view, kLongestStretch * thinnest);
      stretches_.insert(stretches_.end(), own.begin(), own.end());
    }
    memory_ = EnvelopeMemory(stretches_.size(), frames_.size(),
                             static_cast<std::size_t>(space_.coordinates()), equilibrium);
    refuseMoreThanMemory(options_, memory_, equilibrium);
    options_.largest_solves = std::min(options_.largest_solves, memory_.mostShapes(options_.memory_limit));
    const PhaseRule rule{kStride * thinnest, kReach * thinnest, kBow * thinnest, kLever * longest,
                         memory_.mostPhases(options_.memory_limit)};
    phases_ = cutIntoPhases(space_, frames_, options_.from, end_, rule, &wanted_phases_);
    followDesign();
  }

  // The design's shape is followed from phase to phase.
  void followDesign() {
    searches_.reserve(phases_.size());
    EquilibriumSolver following = solver_;
    const StretchReader& reader = reader_;
    for (const MotionPhase& phase : phases_) {
      report_({"shapes", 0.1 * static_cast<double>(searches_.size()) / static_cast<double>(phases_.size()), 0,
               phase.reference});
      if (!searches_.empty()) approach(following, searches_.back().follower().referenceTime(), phase);
      const Harness harness = space_.harness(space_.designAt(phase.reference));
      const Equilibrium equilibrium = following.update(harness);
      if (!equilibrium.converged()) {
        std::ostringstream text;
        text << "the design has no equilibrium at " << phase.reference << " s: " << equilibrium.message;
        throw std::runtime_error(text.str());
      }
      ShapeFollower follower(reader, following, harness, equilibrium, phase.reference);
      if (!searches_.empty()) noticeJump(searches_.back().follower(), follower);
      searches_.emplace_back(std::move(follower), phase.times, kWorthwhile * options_.margin);
      if (options_.probability == 0.0) searches_.back().setWitness(witness_);
    }
  }

  // Follows the design through some times between two references.
  void approach(EquilibriumSolver& following, double from, const MotionPhase& phase) const {
    const std::vector<double>& before = searches_.back().times();
    std::vector<double> times;
    const auto take = [&](const std::vector<double>& of) {
      const std::size_t step = std::max<std::size_t>(1, of.size() / kFollowedTimes);
      for (std::size_t i = 0; i < of.size(); i += step) {
        if (of[i] > from && of[i] < phase.reference) times.push_back(of[i]);
      }
    };
    take(before);
    take(phase.times);
    for (const double time : times) following.update(space_.harness(space_.designAt(time)));
  }

  void noticeJump(const ShapeFollower& before, const ShapeFollower& after) {
    const SamplePlace place = space_.designAt(after.referenceTime());
    const FollowedShape followed = before.follow(place, false);
    if (followed.converged && !followed.jump) return;
    warn(envelope_, "the design itself does not follow the motion smoothly between ", before.referenceTime(),
         " and ", after.referenceTime(), " s: it snaps or is lost on the way");
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
    double most = 0.0;
    LearningPlaces places{
        space_, options_.from, end_, options_.seed, std::min(options_.verification, kLookedAt), {}};
    for (int round = 0; options_.verification > 0; ++round) {
      const std::vector<RandomShape> shapes = look(places.ofRound(round), round);
      most = 0.0;
      for (const RandomShape& shape : shapes) {
        if (shape.converged) most = std::max(most, shape.protrusion);
      }
      const bool well = std::all_of(shapes.begin(), shapes.end(),
                                    [&](const RandomShape& shape) { return !sticksOut(shape); });
      if (well) break;
      if (round == kRounds) {
        warn(envelope_, "random shapes still stick out by ", 1e3 * most, " mm after ", round,
             " rounds of taking them in");
        break;
      }
      takeIn(shapes);
      places.rare = rarePlaces(shapes);
    }
    // Facets may still move out by what was not worthwhile; random shapes have missed the worst place by
    // some.
    if (options_.conservative) envelope_.inflation = 2.0 * std::max(most, kWorthwhile * options_.margin);
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
    std::vector<RandomShape> outside, unknown;
    lookInBlocks(
        searches_, options_.verification,
        [&](std::size_t i) { return drawPlace(space_, options_.from, end_, random, i); },
        lookOptions(kRounds, options_.verification),
        [&](std::size_t first, const std::vector<RandomShape>& shapes) {
          count.add(shapes, stretches_);
          for (std::size_t i = 0; i < shapes.size(); ++i) {
            if (count.isOutside(shapes[i]) && outside.size() < kMostHeld) outside.push_back(shapes[i]);
            if (isDrawnEvenly(first + i)) countSnap(shapes[i], &unknown);
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
    countUnknown(unknown);
  }

  void holdProduction() {
    const StatisticalPlan plan = planFor(options_.probability, options_.verification, stretches_.size());
    const Sampler sampler = productionSampler(space_.scene(), options_, plan.samples());
    const StatisticalResult result =
        holdShareOfProduction(searches_, sampler, plan, witness_, [&](double share, std::size_t done) {
          report_({share < 0.4 ? "shapes" : "containment", 0.9 * share, done, options_.from});
        });
    envelope_.probability = plan.probability;
    envelope_.inflation = result.inflation;
    envelope_.containment = result.containment;
    envelope_.draws = result.draws;
    if (!result.shown) {
      warn(envelope_, "that ", 100.0 * plan.probability, " % of production is held could not be shown in ",
           result.looks, " looks at fresh shapes: up to ", 100.0 * result.containment.outside_bound,
           " % may stick out");
    }
    counted_ = result.containment.shapes - result.containment.failed;
    countUnknown(result.snapped);
  }

  // Counts a shape among those that tell of the share that snaps, by branch of the envelope; of a branch that
  // is not known yet it is put aside.
  void countSnap(const RandomShape& shape, std::vector<RandomShape>* unknown) {
    if (!shape.converged) return;
    ++counted_;
    if (shape.jump.size() > 0) countJump(shape, unknown);
  }

  void countJump(const RandomShape& shape, std::vector<RandomShape>* unknown) {
    const std::vector<std::size_t> numbers = branchNumbers(searches_)[shape.phase];
    const std::size_t branch = searches_[shape.phase].branchAfter(shape.jump);
    if (branch < numbers.size()) {
      ++snapped_[numbers[branch]];
    } else if (unknown != nullptr && unknown->size() < kMostHeld) {
      unknown->push_back(shape);
    }
  }

  void countUnknown(const std::vector<RandomShape>& shapes) {
    for (const RandomShape& shape : shapes) countJump(shape, nullptr);
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
    countBeyond();
    for (std::size_t i = 0; i < phases_.size(); ++i) {
      envelope_.phases[i].excess = phases_[i].excess;
      envelope_.motion_excess = std::max(envelope_.motion_excess, phases_[i].excess);
    }
    if (phases_.size() > 1) tellOfCoarsening();
  }

  void countBeyond() {
    for (Snap& snap : envelope_.snaps) {
      const std::size_t snapped = snapped_[snap.branch];
      if (counted_ > 0) snap.share = static_cast<double>(snapped) / static_cast<double>(counted_);
      snap.share_bound = shareUpperBound(snapped, counted_, kConfidence);
    }
  }

  void tellOfCoarsening() {
    const std::size_t most = memory_.mostPhases(options_.memory_limit);
    if (wanted_phases_ > most) {
      warn(envelope_, "the motion has ", wanted_phases_, " phases; ", phases_.size(),
           " longer ones are taken, for which ", memoryText(options_.memory_limit),
           " are enough: their bodies span up to ", 1e3 * envelope_.motion_excess,
           " mm beyond the way of a clip");
    }
    double coarsest = 0.0;
    std::size_t coarser = 0;
    for (const PhaseSearch& search : searches_) {
      coarsest = std::max(coarsest, search.tolerance());
      coarser += search.tolerance() > kWorthwhile * options_.margin ? 1 : 0;
    }
    if (coarser > 0) {
      warn(envelope_, coarser, " of ", searches_.size(), " phases leave gains of up to ", 1e3 * coarsest,
           " mm to the inflation: over a motion ", kPatience, " solves are shared among the phases");
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
  Reporter report_;
  const SolvedWitness& witness_;
  double end_ = 0.0;
  EnvelopeMemory memory_;
  std::vector<std::string> frames_;
  std::vector<MaterialStretch> stretches_;
  StretchReader reader_{space_, stretches_, frames_};
  std::vector<MotionPhase> phases_;
  std::size_t wanted_phases_ = 1;
  std::vector<PhaseSearch> searches_;
  std::size_t counted_ = 0;                     // random shapes that tell of shares, ...
  std::map<std::size_t, std::size_t> snapped_;  // ... and how many snapped, per branch of the envelope
  Envelope envelope_;
};

}  // namespace

Envelope generateEnvelope(const Scene& scene, const EnvelopeOptions& options, const EquilibriumSolver& solver,
                          const EnvelopeObserver& observer, const SolvedWitness& witness) {
  Envelope envelope;
  withThreads(options.threads,
              [&] { envelope = Generator(scene, options, solver, observer, witness).run(); });
  return envelope;
}

SolvedSample solveSample(const Scene& scene, const EnvelopeOptions& options, const Envelope& envelope,
                         const EnvelopeSample& sample, const EquilibriumSolver& solver) {
  EnvelopeOptions own = options;
  own.variables = envelope.variables;
  const SampleSpace space(scene, own);
  const SamplePlace place{sample.deviations, sample.time};
  EquilibriumSolver following = solver;
  SolvedSample solved{space.harness(place), {}, space.components(place)};
  solved.equilibrium = following.update(solved.harness);
  return solved;
}

}  // namespace cable_variation
