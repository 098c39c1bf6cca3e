#include <cable_variation/simulation/simulation.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <thread>

#include <tbb/task_arena.h>

#include <cable_variation/scene/severity.h>
#include <cable_variation/simulation/block_bytes.h>
#include <cable_variation/simulation/block_desk.h>
#include <cable_variation/simulation/sample_block.h>
#include <cable_variation/simulation/simulation_options.h>
#include <cable_variation/simulation/simulation_watch.h>
#include <cable_variation/simulation/worst_over_motion.h>
#include <cable_variation/util/seconds_since.h>
#include <cable_variation/util/thread_limit.h>

namespace cable_variation {
namespace {

// Samples of a block: some tens of milliseconds of work, the figures of one kept by itself until its turn.
constexpr std::size_t kBlock = 128;
// After so many samples σ is looked at for the first time, and then after at most so many times as many:
// how many it takes is itself an estimate.
constexpr std::uint64_t kPilot = 1024, kGrowth = 2;
// Trial samples that the times of a motion are chosen by, of another seed than the simulation's.
constexpr std::uint64_t kTrials = 256, kTrialSeed = 0x9e3779b97f4a7c15;
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

class Simulator {
 public:
  Simulator(const Scene& scene, const MeasureEvaluator& evaluator, const SimulationOptions& options,
            const EquilibriumSolver& solver, const SampleReceiver& receiver, const ProgressObserver& observer,
            BlockExchange* exchange)
      : start_(Clock::now()),
        scene_(scene),
        evaluator_(evaluator),
        options_(checkedOptions(scene, options)),
        space_(scene, options_),
        sampler_(scene, options_.variables, options_.sampler, options_.first_sample + options_.samples,
                 options_.seed),
        solver_(solver),
        receiver_(receiver),
        exchange_(exchange),
        watch_(observer, scene, options_) {
    if (exchange != nullptr && options_.kept_shapes > 0)
      refuse("kept_shapes: ", options_.kept_shapes, "; expected 0 with an exchange of blocks");
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
    if (exchange_ != nullptr && exchange_->isHelper()) return help();
    if (options_.sigma_error == 0.0) return solve(options_.samples);
    solve(std::min(kPilot, options_.samples));
    while (!watch_.ended() && figures_->measures.samples() < options_.samples) {
      const std::uint64_t needed = samplesNeeded(statistics(), options_.sigma_error);
      if (needed <= figures_->measures.samples()) return;
      solve(std::min({needed, kGrowth * figures_->measures.samples(), options_.samples}));
    }
  }

  BlockWorker worker() const {
    return BlockWorker(scene_, options_.measures, sampler_, instants_, *empty_, options_.kept_shapes);
  }

  // For another process.
  void help() {
    const auto threads = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
    exchange_->help(threads, [this]() -> BlockSolver {
      const auto solver = std::make_shared<BlockWorker>(worker());
      return [this, solver](const BlockRange& range) {
        const SampleBlock block = solver->solve(range.first, range.count, [&] { return watch_.goesOn(); });
        return block.complete ? toBytes(block) : std::string();
      };
    });
  }

  // Until `end` samples are there: blocks in threads and elsewhere, their figures merged in their order.
  void solve(std::uint64_t end) {
    const auto threads = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
    const std::size_t window = 2 * threads + (exchange_ == nullptr ? 0 : exchange_->mostElsewhere());
    BlockDesk desk(options_.first_sample + figures_->measures.samples(), options_.first_sample + end, kBlock,
                   window, [&](FinishedBlock& finished) { take(finished, end); });
    std::vector<std::thread> working;
    const auto orFail = [&](const auto& work) {
      try {
        work();
      } catch (...) {
        desk.fail(std::current_exception());
      }
    };
    orFail([&] {
      for (std::size_t i = 0; i < threads; ++i) working.emplace_back([&] { orFail([&] { workAt(desk); }); });
      if (exchange_ != nullptr) exchange_->deal(desk);
    });
    for (std::thread& thread : working) thread.join();
    desk.throwFailure();
  }

  void workAt(BlockDesk& desk) {
    BlockWorker solver = worker();
    const auto goes_on = [&] { return watch_.goesOn(); };
    while (std::optional<BlockDesk::Work> work = desk.work(goes_on)) {
      if (watch_.ended()) return desk.stop();
      if (exchange_ != nullptr && work->bytes.empty()) work->bytes = exchange_->solvedBefore(work->range);
      const BlockRange& range = work->range;
      SampleBlock block = work->bytes.empty() ? solver.solve(range.first, range.count, goes_on)
                                              : fromBytes(work->bytes, range, options_.variables.size(),
                                                          options_.measures.size(), instants_, *empty_);
      if (!block.complete) return desk.stop();
      if (exchange_ != nullptr && work->bytes.empty()) work->bytes = toBytes(block);
      desk.finish({std::move(block), std::move(work->bytes)});
    }
  }

  void take(FinishedBlock& finished, std::uint64_t wanted) {
    SampleBlock& block = finished.block;
    if (exchange_ != nullptr) exchange_->keep({block.first, block.outcomes.size()}, finished.bytes);
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
  BlockExchange* exchange_;
  SimulationWatch watch_;
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
                             const SampleReceiver& receiver, const ProgressObserver& observer,
                             BlockExchange* exchange) {
  return Simulator(scene, evaluator, options, solver, receiver, observer, exchange).run();
}

}  // namespace cable_variation
