#include <cable_variation/variation/envelope_generator.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <sstream>
#include <stdexcept>

#include <tbb/parallel_for.h>

#include <cable_variation/math/seconds_since.h>
#include <cable_variation/math/thread_limit.h>
#include <cable_variation/variation/chosen_indices.h>
#include <cable_variation/variation/envelope_assembly.h>
#include <cable_variation/variation/envelope_memory.h>
#include <cable_variation/variation/envelope_tightness.h>
#include <cable_variation/variation/envelope_verification.h>
#include <cable_variation/variation/envelope_warning.h>
#include <cable_variation/variation/motion_phases.h>
#include <cable_variation/variation/phase_search.h>

namespace cable_variation {
namespace {

// A facet that would move out by less than this share of the margin is left.
constexpr double kWorthwhile = 0.4;
// Rounds of looking at random shapes and taking in those that stick out.
constexpr int kRounds = 6;
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
// Tell the random numbers of both kinds of shapes apart, and from those of a PointSet.
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
            const EnvelopeObserver& observer)
      : options_(checked(scene, options)), space_(scene, options_), solver_(solver), report_(observer) {
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
    search();
    envelope_.solve_time = secondsSince(start);
    verify();
    assemble();
    measureTightness();
    envelope_.verify_time = secondsSince(start) - envelope_.solve_time;
    return std::move(envelope_);
  }

 private:
  static EnvelopeOptions checked(const Scene& scene, EnvelopeOptions options) {
    requirePositive("margin", options.margin, " m");
    requirePositive("memory_limit", options.memory_limit, " B");
    if (!(options.from >= 0.0) || !std::isfinite(options.from) || !std::isfinite(options.to))
      throw std::invalid_argument("from and to: expected times of at least 0 s");
    if (options.conservative && options.verification == 0)
      throw std::invalid_argument("verification: 0 shapes; expected at least 1 for a conservative envelope");
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
  }

  // The design's shape is followed from phase to phase, and each phase looked through by itself.
  void search() {
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
    }
    run(allIndices(searches_.size()));
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

  void run(const std::vector<std::size_t>& which) {
    std::atomic<std::size_t> done{0}, solved{0};
    tbb::parallel_for(std::size_t{0}, which.size(), [&](std::size_t i) {
      PhaseSearch& search = searches_[which[i]];
      search.run(options_.largest_solves, patience(), [&] {
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

  // Random shapes, apart from those looked at before; those that stick out are taken in, until a round of
  // them finds none.
  void verify() {
    if (options_.verification == 0) return;
    std::size_t drawn = 0;
    for (int round = 0;; ++round) {
      const std::vector<RandomShape> shapes = look(drawn, options_.verification);
      drawn += options_.verification;
      envelope_.containment = summary(shapes);
      const bool well = std::all_of(shapes.begin(), shapes.end(), [&](const RandomShape& shape) {
        return !shape.converged || shape.protrusion <= allowed(shape.phase);
      });
      if (well) return;
      if (round == kRounds) {
        warn(envelope_, "random shapes still stick out by ", 1e3 * envelope_.containment.largest_protrusion,
             " mm after ", round, " rounds of taking them in");
        return;
      }
      takeIn(shapes);
    }
  }

  std::vector<RandomShape> look(std::size_t first, std::size_t count) {
    const ContainmentCheck check(searches_);
    const CounterRandom random(options_.seed, kContainmentStream);
    std::vector<RandomShape> shapes(count);
    std::atomic<std::size_t> done{0};
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 16), [&](const auto& range) {
      for (std::size_t i = range.begin(); i != range.end(); ++i) {
        shapes[i] = check.look(drawPlace(space_, options_.from, end_, random, first + i));
      }
      done += range.size();
      report_({"containment", 0.6 + 0.3 * static_cast<double>(done) / static_cast<double>(count), done,
               shapes[range.begin()].place.time});
    });
    return shapes;
  }

  Containment summary(const std::vector<RandomShape>& shapes) const {
    Containment containment;
    containment.shapes = shapes.size();
    double most = -std::numeric_limits<double>::infinity();
    for (const RandomShape& shape : shapes) {
      if (!shape.converged) {
        ++containment.failed;
        continue;
      }
      if (shape.protrusion <= most) continue;
      most = shape.protrusion;
      containment.largest_protrusion = std::max(0.0, shape.protrusion);
      containment.deviations = shape.place.deviations;
      containment.time = shape.place.time;
      containment.cable = stretches_[shape.stretch].cable;
      containment.arc_length = stretches_[shape.stretch].start;
    }
    const double inflation = inflationFor(containment);
    for (const RandomShape& shape : shapes) {
      if (shape.converged && shape.protrusion > inflation + 1e-9) ++containment.outside;
    }
    return containment;
  }

  // Facets may still move out by what was not worthwhile; random shapes have missed the worst place by some.
  double inflationFor(const Containment& containment) const {
    if (!options_.conservative) return 0.0;
    return 2.0 * std::max(containment.largest_protrusion, kWorthwhile * options_.margin);
  }

  // What a random shape may stick out of a phase without being taken in [m].
  double allowed(std::size_t phase) const { return kTakenIn / kWorthwhile * searches_[phase].tolerance(); }

  void takeIn(const std::vector<RandomShape>& shapes) {
    std::vector<const RandomShape*> outside;
    for (const RandomShape& shape : shapes) {
      if (shape.converged && shape.protrusion > allowed(shape.phase)) outside.push_back(&shape);
    }
    std::vector<FollowedShape> solved(outside.size());
    tbb::parallel_for(std::size_t{0}, outside.size(), [&](std::size_t i) {
      solved[i] = searches_[outside[i]->phase].follower().follow(outside[i]->place, true);
    });
    std::vector<std::size_t> changed;
    for (std::size_t i = 0; i < outside.size(); ++i) {
      searches_[outside[i]->phase].add(solved[i]);
      changed.push_back(outside[i]->phase);
    }
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    run(changed);
  }

  void assemble() {
    envelope_.cables = options_.cables;
    envelope_.variables = options_.variables;
    envelope_.inflation = inflationFor(envelope_.containment);
    assembleEnvelope(searches_, options_.largest_solves, envelope_);
    for (std::size_t i = 0; i < phases_.size(); ++i) {
      envelope_.phases[i].excess = phases_[i].excess;
      envelope_.motion_excess = std::max(envelope_.motion_excess, phases_[i].excess);
    }
    if (phases_.size() > 1) tellOfCoarsening();
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

  // With shapes drawn apart from those for containment.
  void measureTightness() {
    const CounterRandom random(options_.seed, kTightnessStream);
    const auto draw = [&](std::size_t index) -> std::optional<StretchShape> {
      const SamplePlace place = drawPlace(space_, options_.from, end_, random, index);
      FollowedShape followed = searches_[phaseAt(searches_, place.time)].follower().follow(place, false);
      if (!followed.converged) return std::nullopt;
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
  double end_ = 0.0;
  EnvelopeMemory memory_;
  std::vector<std::string> frames_;
  std::vector<MaterialStretch> stretches_;
  StretchReader reader_{space_, stretches_, frames_};
  std::vector<MotionPhase> phases_;
  std::size_t wanted_phases_ = 1;
  std::vector<PhaseSearch> searches_;
  Envelope envelope_;
};

}  // namespace

Envelope generateEnvelope(const Scene& scene, const EnvelopeOptions& options, const EquilibriumSolver& solver,
                          const EnvelopeObserver& observer) {
  Envelope envelope;
  withThreads(options.threads, [&] { envelope = Generator(scene, options, solver, observer).run(); });
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
