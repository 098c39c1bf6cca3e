#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <cable_variation/scene/scene.h>
#include <cable_variation/simulation/variance_contribution.h>
#include <cable_variation/statistics/measure_statistics.h>
#include <cable_variation/tolerances/point_set.h>

namespace cable_variation {

/// What became of a sample.
enum class SampleOutcome {
  solved,         ///< an equilibrium that the nominal one goes over into
  snapped,        ///< a stable one, but another: its values count
  not_converged,  ///< none was found
  impossible      ///< none can be: the variables leave the physical, or the clips the cable's reach
};
constexpr std::size_t kSampleOutcomes = 4;

const char* toString(SampleOutcome outcome);
/// Whether there is an equilibrium, and so values of its measures.
bool hasValues(SampleOutcome outcome);

/// A sample that was not simply solved.
struct ListedSample {
  std::uint64_t index = 0;
  SampleOutcome outcome = SampleOutcome::not_converged;
  std::vector<double> deviations;  ///< from nominal, one per variable [its unit]
};

/// What a simulation of production tells.
struct SimulationStatistics {
  std::vector<std::size_t> variables;  ///< varied, indices into Scene::design_variables
  std::vector<std::size_t> measures;   ///< indices into Scene::measures
  SamplerType sampler = SamplerType::monte_carlo;
  std::uint64_t seed = 0;
  std::uint64_t wanted = 0;                                  ///< samples asked for
  std::uint64_t samples = 0;                                 ///< done; fewer: the simulation was ended before
  std::array<std::uint64_t, kSampleOutcomes> outcomes = {};  ///< counts, which add up to `samples`
  std::vector<ListedSample> listed;                          ///< the first kMostListed that were not solved
  std::vector<double> nominal;                               ///< per measure
  std::vector<MeasureStatistics> statistics;                 ///< per measure
  VarianceContributions contributions;

  static constexpr std::size_t kMostListed = 1000;

  std::uint64_t count(SampleOutcome outcome) const { return outcomes[static_cast<std::size_t>(outcome)]; }
};

/// So many samples, in all, make the standard deviation of every measure known to `error` of itself, to each
/// side, at the confidence of the statistics: those done, if it is so already. A measure without enough
/// values asks for twice the samples done, one that did not vary for none more; never more than kMostSamples.
/// An estimate from few samples is rough, and one that looks good by chance ends too soon: ask with 1,000 or
/// more. Throws std::invalid_argument: an error outside (0, 1).
std::uint64_t samplesNeeded(const SimulationStatistics& statistics, double error);

/// Collects samples, in constant memory. For the same figures whatever the number of threads, fill one for
/// each fixed block of samples, in their order, and merge them in the order of the blocks.
class SimulationAccumulator {
 public:
  /// Throws std::invalid_argument: makeDistribution().
  SimulationAccumulator(const Scene& scene, const std::vector<std::size_t>& variables,
                        const std::vector<std::size_t>& measures);

  /// @param deviations one per variable
  /// @param values one per measure, not a number where there is none; not read without an equilibrium
  /// @param linear what the linear model predicts of each measure; nullptr: no model
  void add(std::uint64_t index, SampleOutcome outcome, const double* deviations, const double* values,
           const double* linear);
  void merge(const SimulationAccumulator& later);

  std::uint64_t samples() const { return samples_; }
  std::uint64_t count(SampleOutcome outcome) const { return outcomes_[static_cast<std::size_t>(outcome)]; }
  std::vector<RunningFigures> running() const;  ///< per measure

  /// All but sampler, seed, wanted and nominal. @param linear per measure; empty: no model
  SimulationStatistics statistics(double confidence,
                                  const std::vector<std::optional<LinearMoments>>& linear = {}) const;

 private:
  std::vector<std::size_t> variables_, measures_;
  std::uint64_t samples_ = 0;
  std::array<std::uint64_t, kSampleOutcomes> outcomes_ = {};
  std::vector<ListedSample> listed_;
  std::vector<MeasureAccumulator> accumulators_;
  VarianceContributor contributor_;
};

}  // namespace cable_variation
