#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/measures/measure_evaluation.h>
#include <cable_variation/scene/scene.h>
#include <cable_variation/sensitivity/stability_analysis.h>
#include <cable_variation/simulation/block_exchange.h>
#include <cable_variation/simulation/simulation_statistics.h>
#include <cable_variation/statistics/arc_variation.h>
#include <cable_variation/tolerances/varied_design.h>
#include <cable_variation/util/progress.h>

namespace cable_variation {

struct SimulationOptions : VariedDesign {
  std::vector<std::size_t> measures;  ///< indices, each once; empty: all of the scene

  SamplerType sampler = SamplerType::monte_carlo;
  std::uint64_t seed = 1;
  /// 1 to kMostSamples. With sigma_error: no more than these.
  std::uint64_t samples = 10000;
  /// Samples from this index on: a part of a simulation that begins at 0. Not with sigma_error, nor with
  /// Latin hypercube samples.
  std::uint64_t first_sample = 0;
  /// Above 0, below 1: end when the σ of every measure is known to this share of itself, to each side, at
  /// `confidence`. Not with Latin hypercube samples, which are of a count.
  double sigma_error = 0.0;
  double confidence = 0.95;

  double from = 0.0;            ///< of the motions [s]
  double to = 0.0;              ///< the same: variation at that time; later: the worst over the motion
  std::size_t most_times = 16;  ///< at which each sample is solved to find its worst

  std::size_t sections = 33;    ///< along each cable, ends included, at least 2: for the variation along it
  std::size_t kept_shapes = 0;  ///< shapes of the first samples that are kept, to be seen
  std::size_t threads = 0;      ///< 0: as many as there are cores
};

/// How production lets a cable vary, section by section at equal steps of its arc length.
struct CableVariation {
  std::size_t cable = 0;                   ///< index
  std::vector<double> arc_length;          ///< in the design; samples: the same share of their length [m]
  std::vector<SectionVariation> sections;  ///< against the world
};

/// The centrelines of one sample.
struct KeptShape {
  std::uint64_t index = 0;
  SampleOutcome outcome = SampleOutcome::solved;
  std::vector<Eigen::Matrix3Xd> cables;  ///< per cable, a column per section [m, world]
};

/// A time of the motion at which every sample was solved.
struct SimulatedTime {
  double time = 0.0;        ///< [s]
  double largest_6s = 0.0;  ///< of any section [m]
  std::uint64_t worst = 0;  ///< so often was a sample's measure at its worst here, all measures together
};

/// What a simulation of production found.
struct Simulation {
  SimulationStatistics statistics;
  StabilityAnalysis linear;          ///< of the same design, at `shown_time`; no low and high
  std::vector<SimulatedTime> times;  ///< of a motion, in order; at rest one of time 0
  double shown_time = 0.0;           ///< of what follows: where the cables vary most [s]
  Harness harness;                   ///< of the design then
  std::vector<CableVariation> cables;
  std::vector<KeptShape> shapes;

  /// Over a motion: how much worse than at the best of `times` a measure is predicted to get, at most, per
  /// measure [its unit]: by the first-order model at every pose, for samples not of this simulation.
  std::vector<double> missed;
  bool ended_early = false;           ///< the observer asked for it; what was done by then is all here
  std::uint64_t solved_again = 0;     ///< equilibria that a batch left to the robust solver
  double discretisation_error = 0.0;  ///< largest estimate [m]
  double time = 0.0;                  ///< it took [s]
  std::vector<std::string> warnings;
};

/// Given every sample in the order of its index, from one thread at a time.
/// @param deviations one per variable @param values one per measure; without an equilibrium nullptr
using SampleReceiver = std::function<void(std::uint64_t index, SampleOutcome outcome,
                                          const double* deviations, const double* values)>;

/// Simulates production: every sample is solved to the scene's accuracy, many at once (BatchSolver), from the
/// first-order response of the design; what does not settle so is followed there step by step, as envelopes
/// are, which tells of snaps. The same options give the same figures, bit for bit, whatever the number of
/// threads and whenever it is asked for progress. Memory does not grow with the samples.
///
/// Over a motion each sample is held while the motion plays, and a measure is its worst value over it: the
/// one closest to a limit, or furthest beyond; without limits the smallest distance, bend radius or
/// eigenvalue, the largest of everything else, of a position the one furthest from nominal. The times that
/// samples are solved at are those that are worst, by the first-order model at every pose recorded, for some
/// sample of production.
///
/// A block of samples is solved once in all that an exchange joins, and merged where it belongs: files and
/// other processes change nothing of the figures either.
///
/// @param evaluator of the scene, whatever its nominal shape: similarities are to the design at that time
/// @param solver the design's shape to follow, best solved; else it is solved from nothing
/// @param observer told of the stages "times" (of a motion) and "samples"; asked for an end: what is done
/// @param exchange of blocks with others; nullptr: with nobody. With one no shapes are kept
/// Throws std::invalid_argument that names it: nothing varies, an index out of range or twice, counts,
/// confidence or times that are none, a variable whose tolerance leaves the physical; as requireConverged()
/// does: no equilibrium of the design itself.
Simulation simulateVariation(const Scene& scene, const MeasureEvaluator& evaluator,
                             const SimulationOptions& options, const EquilibriumSolver& solver,
                             const SampleReceiver& receiver = {}, const ProgressObserver& observer = {},
                             BlockExchange* exchange = nullptr);

}  // namespace cable_variation
