#include <cable_variation/variation/envelope_generator.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <cable_variation/geometry/voxel_set.h>
#include <cable_variation/math/thread_limit.h>
#include <cable_variation/variation/envelope_verification.h>
#include <cable_variation/variation/motion_phases.h>
#include <cable_variation/variation/phase_search.h>

namespace cable_variation {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// A facet that would move out by less than this share of the margin is left.
constexpr double kWorthwhile = 0.4;
// Rounds of looking at random shapes and taking in those that stick out.
constexpr int kRounds = 6;
// Random shapes that stick out by more than this share of the margin are taken in.
constexpr double kTakenIn = 0.5;
// Stretches are as long as this many radii of the thinnest cable, phases of a motion as far as so many.
constexpr double kLongestStretch = 2.0, kStride = 0.5;
// A section turns as much as a clip near it, and the cable moves aside by that turn times some of its length.
constexpr double kLever = 0.25;
// Tell the random numbers of both kinds of shapes apart, and from those of a PointSet.
constexpr std::uint32_t kContainmentStream = 3, kTightnessStream = 4;
// Voxels are as large as this share of the thinnest cable's radius.
constexpr double kVoxel = 1.0 / 6.0;

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
    search(options_.largest_solves);
    envelope_.solve_time = secondsSince(start);
    verify();
    assemble();
    measureVolume();
    envelope_.verify_time = secondsSince(start) - envelope_.solve_time;
    return std::move(envelope_);
  }

 private:
  static EnvelopeOptions checked(const Scene& scene, EnvelopeOptions options) {
    requirePositive("margin", options.margin, " m");
    if (!(options.from >= 0.0) || !std::isfinite(options.from) || !std::isfinite(options.to))
      throw std::invalid_argument("from and to: expected times of at least 0 s");
    if (options.conservative && options.verification == 0)
      throw std::invalid_argument("verification: 0 shapes; expected at least 1 for a conservative envelope");
    for (const std::size_t cable : options.cables) {
      if (cable < scene.harness.cables.size()) continue;
      throw std::invalid_argument("cable number " + std::to_string(cable) + "; expected less than " +
                                  std::to_string(scene.harness.cables.size()));
    }
    if (scene.harness.cables.empty()) throw std::invalid_argument("the scene has no cables");
    if (options.cables.empty()) {
      options.cables.resize(scene.harness.cables.size());
      std::iota(options.cables.begin(), options.cables.end(), std::size_t{0});
    }
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
    phases_ = cutIntoPhases(space_, frames_, options_.from, end_, kStride * thinnest, kLever * longest);
  }

  // The design's shape is followed from phase to phase, and each phase looked through by itself.
  void search(std::size_t largest_solves) {
    searches_.reserve(phases_.size());
    EquilibriumSolver following = solver_;
    const StretchReader& reader = reader_;
    for (const MotionPhase& phase : phases_) {
      report_({"shapes", 0.1 * static_cast<double>(searches_.size()) / static_cast<double>(phases_.size()), 0,
               phase.reference});
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
    std::vector<std::size_t> all(searches_.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    run(all, largest_solves);
  }

  void noticeJump(const ShapeFollower& before, const ShapeFollower& after) {
    const SamplePlace place = space_.designAt(after.referenceTime());
    const FollowedShape followed = before.follow(place, false);
    if (followed.converged && !followed.jump) return;
    warn("the design itself does not follow the motion smoothly between ", before.referenceTime(), " and ",
         after.referenceTime(), " s: it snaps or is lost on the way");
  }

  void run(const std::vector<std::size_t>& which, std::size_t largest_solves) {
    std::atomic<std::size_t> done{0}, solved{0};
    tbb::parallel_for(std::size_t{0}, which.size(), [&](std::size_t i) {
      PhaseSearch& search = searches_[which[i]];
      search.run(largest_solves, [&] {
        report_({"shapes", 0.1 + 0.5 * static_cast<double>(done) / static_cast<double>(which.size()),
                 solved + search.solves(), search.follower().referenceTime()});
      });
      ++done;
      solved += search.solves();
    });
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
      if (envelope_.containment.largest_protrusion <= kTakenIn * options_.margin) return;
      if (round == kRounds) {
        warn("random shapes still stick out by ", 1e3 * envelope_.containment.largest_protrusion,
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

  void takeIn(const std::vector<RandomShape>& shapes) {
    std::vector<std::vector<FollowedShape>> taken(searches_.size());
    std::vector<const RandomShape*> outside;
    for (const RandomShape& shape : shapes) {
      if (shape.converged && shape.protrusion > kTakenIn * options_.margin) outside.push_back(&shape);
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
    run(changed, options_.largest_solves);
  }

  void assemble() {
    envelope_.cables = options_.cables;
    envelope_.variables = options_.variables;
    envelope_.inflation = inflationFor(envelope_.containment);
    envelope_.frames.resize(frames_.size());
    for (std::size_t frame = 0; frame < frames_.size(); ++frame)
      envelope_.frames[frame].component = frames_[frame];
    std::vector<const PhaseSearch::Branch*> known{nullptr};
    for (std::size_t phase = 0; phase < searches_.size(); ++phase) assemble(phase, known);
    envelope_.branches = known.size();
    std::size_t exhausted = 0;
    for (const PhaseSearch& search : searches_) exhausted += search.exhausted() ? 1 : 0;
    if (exhausted > 0) {
      warn(exhausted, " of ", searches_.size(), " phases ended at the largest number of solves, ",
           options_.largest_solves, ": their hulls may still grow");
    }
    if (envelope_.failures > 0) {
      const auto first = std::find_if(searches_.begin(), searches_.end(),
                                      [](const PhaseSearch& search) { return search.failures() > 0; });
      warn(envelope_.failures,
           " harnesses within the tolerances have no equilibrium that the design's leads to, ",
           "and are not in the envelope; the first: ", first->failure());
    }
  }

  void assemble(std::size_t phase, std::vector<const PhaseSearch::Branch*>& known) {
    const PhaseSearch& search = searches_[phase];
    envelope_.phases.push_back({search.times().front(), search.times().back(), search.times().size()});
    envelope_.solves += search.solves();
    envelope_.failures += search.failures();
    envelope_.discretisation_error = std::max(envelope_.discretisation_error, search.discretisationError());
    std::vector<std::size_t> global{0};
    for (std::size_t b = 1; b < search.branches().size(); ++b) {
      global.push_back(globalBranch(search.branches()[b], known));
    }
    const std::size_t first_sample = envelope_.samples.size();
    for (std::size_t i = 0; i < search.samples().size(); ++i) {
      const SamplePlace& place = search.samples()[i].place;
      envelope_.samples.push_back({place.deviations, place.time, phase, global[search.sampleBranches()[i]]});
    }
    for (Snap snap : search.snaps()) {
      snap.branch = global[snap.branch];
      envelope_.snaps.push_back(std::move(snap));
    }
    for (std::size_t b = 0; b < search.branches().size(); ++b) {
      const PhaseSearch::Branch& branch = search.branches()[b];
      for (std::size_t frame = 0; frame < frames_.size(); ++frame) {
        for (std::size_t i = 0; i < stretches_.size(); ++i) {
          const GrowingHull& hull = branch.hulls[frame][i];
          EnvelopePiece piece{stretches_[i].cable,
                              stretches_[i].start,
                              stretches_[i].end,
                              phase,
                              global[b],
                              {hull.hull(), search.radius()[i] + envelope_.inflation},
                              {}};
          for (const GrowingHull::Tag& tag : hull.tags())
            piece.vertex_sample.push_back(first_sample + tag.sample);
          envelope_.frames[frame].pieces.push_back(std::move(piece));
        }
      }
    }
  }

  // The envelope's volume, and that of shapes drawn apart from those for containment.
  void measureVolume() {
    Tightness& tightness = envelope_.tightness;
    const std::vector<EnvelopePiece>& pieces = envelope_.frames.front().pieces;
    Box box = boxOf(pieces);
    double thinnest = std::numeric_limits<double>::infinity();
    for (const EnvelopePiece& piece : pieces) thinnest = std::min(thinnest, piece.body.radius);
    tightness.voxel = options_.voxel > 0.0 ? options_.voxel : kVoxel * thinnest;
    const VoxelSet none(box, tightness.voxel);
    tbb::enumerable_thread_specific<VoxelSet> sets(none);
    tbb::parallel_for(std::size_t{0}, pieces.size(),
                      [&](std::size_t i) { sets.local().addBody(pieces[i].body); });
    tightness.envelope_volume = volumeOf(sets, none);
    if (options_.tightness == 0) return;
    const ContainmentCheck check(searches_);
    const CounterRandom random(options_.seed, kTightnessStream);
    tbb::enumerable_thread_specific<VoxelSet> shapes(none);
    std::atomic<std::size_t> done{0}, drawn{0};
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, options_.tightness, 16), [&](const auto& range) {
      VoxelSet& own = shapes.local();
      for (std::size_t i = range.begin(); i != range.end(); ++i) {
        const SamplePlace place = drawPlace(space_, options_.from, end_, random, i);
        const PhaseSearch& phase = searches_[check.phaseOf(place.time)];
        const FollowedShape followed = phase.follower().follow(place, false);
        if (!followed.converged) continue;
        for (std::size_t k = 0; k < stretches_.size(); ++k) {
          own.addTube(followed.shape.centreline(0, k), followed.shape.radius[k]);
        }
        ++drawn;
      }
      done += range.size();
      report_({"tightness", 0.9 + 0.1 * static_cast<double>(done) / static_cast<double>(options_.tightness),
               done, 0.0});
    });
    tightness.shapes = drawn;
    tightness.shapes_volume = volumeOf(shapes, none);
  }

  static Box boxOf(const std::vector<EnvelopePiece>& pieces) {
    Box box;
    for (const EnvelopePiece& piece : pieces) {
      for (const Eigen::Vector3d& vertex : piece.body.core.surface().vertices) {
        box.add(vertex - Eigen::Vector3d::Constant(piece.body.radius));
        box.add(vertex + Eigen::Vector3d::Constant(piece.body.radius));
      }
    }
    return box;
  }

  static double volumeOf(const tbb::enumerable_thread_specific<VoxelSet>& sets, const VoxelSet& none) {
    VoxelSet all = none;
    for (const VoxelSet& set : sets) all.unite(set);
    return all.volume();
  }

  // Branches of different phases are the same if they begin close together.
  static std::size_t globalBranch(const PhaseSearch::Branch& branch,
                                  std::vector<const PhaseSearch::Branch*>& known) {
    for (std::size_t i = 1; i < known.size(); ++i) {
      const double apart = (known[i]->first_ends - branch.first_ends).colwise().norm().maxCoeff();
      if (apart < 0.5 * std::min(known[i]->jump, branch.jump)) return i;
    }
    known.push_back(&branch);
    return known.size() - 1;
  }

  template <class... Parts>
  void warn(const Parts&... parts) {
    std::ostringstream text;
    text.precision(3);
    (text << ... << parts);
    envelope_.warnings.push_back(text.str());
  }

  EnvelopeOptions options_;
  SampleSpace space_;
  EquilibriumSolver solver_;
  Reporter report_;
  double end_ = 0.0;
  std::vector<std::string> frames_;
  std::vector<MaterialStretch> stretches_;
  StretchReader reader_{space_, stretches_, frames_};
  std::vector<MotionPhase> phases_;
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
