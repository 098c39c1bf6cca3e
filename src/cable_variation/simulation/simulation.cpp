#include <cable_variation/simulation/simulation.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <sstream>
#include <stdexcept>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/task_arena.h>

#include <cable_variation/scene/severity.h>
#include <cable_variation/simulation/sample_block.h>
#include <cable_variation/simulation/worst_over_motion.h>
#include <cable_variation/util/chosen_indices.h>
#include <cable_variation/util/pipeline.h>
#include <cable_variation/util/seconds_since.h>
#include <cable_variation/util/thread_limit.h>

namespace cable_variation {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
// Samples of a block: some tens of milliseconds of work, the figures of one kept by itself until its turn.
constexpr std::size_t kBlock = 128;
// After so many samples σ is looked at for the first time, and then after at most so many times as many:
// how many it takes is itself an estimate.
constexpr std::uint64_t kPilot = 1024, kGrowth = 2;
// Trial samples that the times of a motion are chosen by, of another seed than the simulation's.
constexpr std::uint64_t kTrials = 256, kTrialSeed = 0x9e3779b97f4a7c15;
constexpr double kAsked = 0.05;  // the observer, at most so often [s]
// What is missed over a motion is warned of from this share of a measure's σ.
constexpr double kMissed = 0.05;

template <typename... Parts>
std::string text(const Parts&... parts) {
  std::ostringstream stream;
  (stream << ... << parts);
  return stream.str();
}

template <typename... Parts>
[[noreturn]] void refuse(const Parts&... parts) {
  throw std::invalid_argument(text(parts...));
}

// Tells the observer, one thread at a time, and remembers when it wants an end.
class Watch {
 public:
  Watch(const ProgressObserver& observer, const Scene& scene, const SimulationOptions& options)
      : observer_(observer), start_(Clock::now()) {
    progress_.stage = "times";
    progress_.wanted = options.samples;
    for (const std::size_t index : options.measures)
      progress_.figures.push_back({scene.measures[index].name, kNaN, kNaN});
  }

  bool ended() const { return ended_; }

  void update(const SimulationAccumulator& figures, std::uint64_t wanted) {
    if (!observer_ || secondsSince(start_) < refreshed_ + kAsked) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    refreshed_ = secondsSince(start_);
    progress_.stage = "samples";
    progress_.done = figures.samples();
    progress_.wanted = wanted;
    progress_.share = static_cast<double>(progress_.done) / static_cast<double>(wanted);
    progress_.snapped = figures.count(SampleOutcome::snapped);
    progress_.failed = figures.count(SampleOutcome::not_converged) + figures.count(SampleOutcome::impossible);
    const std::vector<RunningFigures> running = figures.running();
    for (std::size_t i = 0; i < running.size(); ++i) {
      progress_.figures[i].mean = running[i].mean;
      progress_.figures[i].sigma = running[i].sigma;
    }
    if (due()) tell();
  }

  // By any thread; whether the work goes on.
  bool goesOn() {
    if (ended_) return false;
    if (!observer_ || !due()) return true;
    const std::unique_lock<std::mutex> lock(mutex_, std::try_to_lock);
    if (lock.owns_lock()) tell();
    return !ended_;
  }

 private:
  bool due() const { return secondsSince(start_) > told_ + kAsked; }

  void tell() {
    told_ = secondsSince(start_);
    if (!ended_) ended_ = !observer_(progress_);
  }

  const ProgressObserver& observer_;
  Clock::time_point start_;
  std::mutex mutex_;
  Progress progress_;
  double refreshed_ = 0.0;  // the figures in it [s]; told or not, for others tell in between
  std::atomic<double> told_{0.0};
  std::atomic<bool> ended_{false};
};

SimulationOptions checked(const Scene& scene, SimulationOptions options) {
  if (options.variables.empty()) refuse("no design variables: expected at least one that varies");
  if (options.samples < 1 || options.samples > kMostSamples)
    refuse("samples: ", options.samples, "; expected 1 to ", kMostSamples);
  if (!(options.sigma_error >= 0.0 && options.sigma_error < 1.0))
    refuse("sigma_error: ", options.sigma_error, "; expected below 1, and above 0 or 0: the count is given");
  if (options.sigma_error > 0.0 && options.sampler == SamplerType::latin_hypercube)
    refuse(
        "sampler latin_hypercube: its samples are of a count; expected monte_carlo or sobol with a "
        "sigma_error");
  if (!(options.confidence > 0.0 && options.confidence < 1.0))
    refuse("confidence: ", options.confidence, "; expected above 0, below 1");
  if (options.sections < 2) refuse("sections: ", options.sections, "; expected at least 2");
  if (options.most_times < 1) refuse("most_times: 0; expected at least 1");
  if (!(options.from >= 0.0) || !(options.to >= options.from) || !std::isfinite(options.to))
    refuse("from ", options.from, " s to ", options.to, " s; expected times in order, of at least 0");
  if (scene.harness.cables.empty()) refuse("the scene has no cables");
  options.measures = allOrChosen(options.measures, scene.measures.size(), "measure");
  return options;
}

class Simulator {
 public:
  Simulator(const Scene& scene, const MeasureEvaluator& evaluator, const SimulationOptions& options,
            const EquilibriumSolver& solver, const SampleReceiver& receiver, const ProgressObserver& observer)
      : start_(Clock::now()),
        scene_(scene),
        evaluator_(evaluator),
        options_(checked(scene, options)),
        space_(scene, options_),
        sampler_(scene, options_.variables, options_.sampler, options_.samples, options_.seed),
        solver_(solver),
        receiver_(receiver),
        watch_(observer, scene, options_) {
    requirePhysical();
  }

  Simulation run() {
    withThreads(options_.threads, [&] {
      preparePoses();
      prepareFigures();
      solveAll();
    });
    assemble();
    result_.time = secondsSince(start_);
    return std::move(result_);
  }

 private:
  // A design at the limit of one tolerance must be one that can be built.
  void requirePhysical() const {
    for (std::size_t i = 0; i < options_.variables.size(); ++i) {
      const DesignVariable& variable = scene_.design_variables[options_.variables[i]];
      for (const bool upper : {false, true}) {
        SamplePlace place = space_.designAt(options_.from);
        place.deviations[static_cast<Eigen::Index>(i)] = upper ? variable.upper : variable.lower;
        try {
          space_.harness(place);
        } catch (const std::invalid_argument& error) {
          refuse("design variable '", variable.name, "' at its ", upper ? "upper" : "lower", " limit, ",
                 upper ? variable.upper : variable.lower, " ", variable.unit, " from nominal: ", error.what(),
                 "; expected a tolerance that can be built");
        }
      }
    }
  }

  void preparePoses() {
    std::vector<double> times{options_.from};
    if (!space_.motions().empty() && options_.to > options_.from) {
      const Sampler trials(scene_, options_.variables, SamplerType::sobol, kTrials,
                           options_.seed + kTrialSeed);
      WorstTimes worst =
          findWorstTimes(space_, options_.measures, evaluator_, trials, options_.from, options_.to,
                         options_.most_times, solver_, [&] { return watch_.goesOn(); });
      if (!worst.times.empty()) times = std::move(worst.times);
      result_.missed = std::move(worst.missed);
      unknown_ = std::move(worst.unknown);
      phases_ = worst.phases;
    }
    EquilibriumSolver solver = solver_;
    for (const double time : times) {
      if (!instants_.empty() && !watch_.goesOn()) return;
      instants_.push_back(std::make_unique<const DesignInstant>(space_, options_, options_.measures,
                                                                evaluator_, options_.sections, solver, time));
      solver = instants_.back()->solver();
    }
  }

  void prepareFigures() {
    figures_ = std::make_unique<SampleFigures>(SampleFigures{
        SimulationAccumulator(scene_, options_.variables, options_.measures), {}, {}, {}, 0, 0.0});
    for (const auto& instant : instants_) {
      figures_->arcs.emplace_back();
      for (std::size_t cable = 0; cable < scene_.harness.cables.size(); ++cable)
        figures_->arcs.back().emplace_back(options_.sections, instant->axes(cable));
    }
    figures_->shapes.resize(instants_.size());
    figures_->worst.resize(instants_.size());
    empty_ = std::make_unique<const SampleFigures>(*figures_);
  }

  void solveAll() {
    if (options_.sigma_error == 0.0) return solve(options_.samples);
    solve(std::min(kPilot, options_.samples));
    while (!watch_.ended() && figures_->measures.samples() < options_.samples) {
      const std::uint64_t needed = samplesNeeded(statistics(), options_.sigma_error);
      if (needed <= figures_->measures.samples()) return;
      solve(std::min({needed, kGrowth * figures_->measures.samples(), options_.samples}));
    }
  }

  // Up to the sample of index `end`: blocks in threads, their figures merged in their order.
  void solve(std::uint64_t end) {
    std::uint64_t next = figures_->measures.samples();
    tbb::enumerable_thread_specific<BlockWorker> workers([&] {
      return BlockWorker(scene_, options_.measures, sampler_, instants_, *empty_, options_.kept_shapes);
    });
    using Pointer = std::shared_ptr<SampleBlock>;
    bool whole = true;  // no block was left
    const auto first = tbb::make_filter<void, std::uint64_t>(
        PipelineMode::serial_in_order, [&](tbb::flow_control& control) -> std::uint64_t {
          if (next >= end || watch_.ended()) {
            control.stop();
            return 0;
          }
          const std::uint64_t at = next;
          next = std::min(end, next + kBlock);
          return at;
        });
    const auto work = tbb::make_filter<std::uint64_t, Pointer>(PipelineMode::parallel, [&](std::uint64_t at) {
      const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(kBlock, end - at));
      return std::make_shared<SampleBlock>(workers.local().solve(at, count, [&] { return watch_.goesOn(); }));
    });
    const auto collect =
        tbb::make_filter<Pointer, void>(PipelineMode::serial_in_order, [&](const Pointer& block) {
          whole = whole && block->complete;
          if (whole) take(*block, end);
        });
    const auto tokens = 2 * static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
    tbb::parallel_pipeline(tokens, first & work & collect);
  }

  void take(SampleBlock& block, std::uint64_t wanted) {
    if (receiver_) {
      for (std::size_t i = 0; i < block.outcomes.size(); ++i) {
        const auto column = static_cast<Eigen::Index>(i);
        const bool has_values = hasValues(block.outcomes[i]);
        receiver_(block.first + i, block.outcomes[i], block.deviations.col(column).data(),
                  has_values ? block.values.col(column).data() : nullptr);
      }
    }
    figures_->merge(std::move(block.figures));
    watch_.update(figures_->measures, wanted);
  }

  SimulationStatistics statistics() const {
    SimulationStatistics statistics = figures_->measures.statistics(
        options_.confidence, instants_.size() == 1 ? instants_.front()->linearMoments()
                                                   : std::vector<std::optional<LinearMoments>>());
    statistics.sampler = options_.sampler;
    statistics.seed = options_.seed;
    statistics.wanted = options_.samples;
    for (std::size_t i = 0; i < options_.measures.size(); ++i) {
      const Measure& measure = scene_.measures[options_.measures[i]];
      const double first = instants_.front()->linear().values[i].value;
      double nominal = first;
      for (const auto& instant : instants_) {
        const double value = instant->linear().values[i].value;
        if (isWorse(measure, first, value, nominal)) nominal = value;
      }
      statistics.nominal.push_back(nominal);
    }
    return statistics;
  }

  void assemble() {
    result_.statistics = statistics();
    result_.ended_early = watch_.ended() && result_.statistics.samples < options_.samples;
    if (options_.sigma_error > 0.0 && !result_.ended_early) {
      const std::uint64_t needed = samplesNeeded(result_.statistics, options_.sigma_error);
      if (needed > result_.statistics.samples) {
        warn("σ is not known as well as asked for after ", result_.statistics.samples, " samples: some ",
             needed, " would do");
      } else {
        result_.statistics.wanted = result_.statistics.samples;
      }
    }
    std::vector<std::vector<std::vector<SectionVariation>>> sections;  // per instant and cable
    std::size_t shown = 0;
    for (std::size_t instant = 0; instant < instants_.size(); ++instant) {
      double largest = 0.0;
      sections.emplace_back();
      for (const ArcVariation& arc : figures_->arcs[instant]) {
        sections.back().push_back(arc.variation());
        for (const SectionVariation& section : sections.back().back())
          largest = std::max(largest, 6.0 * section.axes.sigma[0]);
      }
      result_.times.push_back({instants_[instant]->time(), largest, figures_->worst[instant]});
      if (largest > result_.times[shown].largest_6s) shown = instant;
    }
    const DesignInstant& instant = *instants_[shown];
    result_.shown_time = instant.time();
    result_.linear = instant.linear();
    result_.harness = instant.harness();
    for (std::size_t cable = 0; cable < sections[shown].size(); ++cable)
      result_.cables.push_back({cable, instant.arcLengths(cable), std::move(sections[shown][cable])});
    result_.shapes = std::move(figures_->shapes[shown]);
    result_.solved_again = figures_->solved_again;
    result_.discretisation_error = figures_->discretisation_error;
    addWarnings();
  }

  void addWarnings() {
    result_.warnings.insert(result_.warnings.end(), result_.linear.warnings.begin(),
                            result_.linear.warnings.end());
    if (figures_->undecided > 0) {
      warn("in ", figures_->undecided,
           " equilibria it cannot be told whether a cable is inside of an open part or not:"
           " their distances count as if it were outside");
    }
    for (std::size_t i = 0; i < result_.missed.size(); ++i) {
      const double sigma = result_.statistics.statistics[i].sigma;  // not a number: no two finite values
      if (!(result_.missed[i] > (std::isnan(sigma) ? 0.0 : kMissed * sigma))) continue;
      const Measure& measure = scene_.measures[options_.measures[i]];
      warn(measure.name, " may be up to ", result_.missed[i], " ", measure.unit,
           " worse at other times of the motion than at the ", instants_.size(), " looked at");
    }
    for (std::size_t i = 0; i < unknown_.size(); ++i) {
      if (unknown_[i] == 0) continue;
      warn(scene_.measures[options_.measures[i]].name, " has no finite value of the design in ", unknown_[i],
           " of the ", phases_,
           " phases of the motion: times at which samples are worst there may not be among those looked at");
    }
  }

  template <typename... Parts>
  void warn(const Parts&... parts) {
    result_.warnings.push_back(text(parts...));
  }

  Clock::time_point start_;
  const Scene& scene_;
  const MeasureEvaluator& evaluator_;
  SimulationOptions options_;
  SampleSpace space_;
  Sampler sampler_;
  const EquilibriumSolver& solver_;
  const SampleReceiver& receiver_;
  Watch watch_;
  BlockWorker::Instants instants_;
  std::vector<std::size_t> unknown_;  // see WorstTimes, as is the next
  std::size_t phases_ = 0;
  std::unique_ptr<SampleFigures> figures_;
  std::unique_ptr<const SampleFigures> empty_;
  Simulation result_;
};

}  // namespace

Simulation simulateVariation(const Scene& scene, const MeasureEvaluator& evaluator,
                             const SimulationOptions& options, const EquilibriumSolver& solver,
                             const SampleReceiver& receiver, const ProgressObserver& observer) {
  return Simulator(scene, evaluator, options, solver, receiver, observer).run();
}

}  // namespace cable_variation
