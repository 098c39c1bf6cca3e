#include <cable_variation/simulation/simulation_statistics.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cable_variation {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::vector<std::vector<double>> edgesOf(const Scene& scene, const std::vector<std::size_t>& variables) {
  std::vector<std::vector<double>> edges;
  edges.reserve(variables.size());
  for (const std::size_t variable : variables) {
    edges.push_back(VarianceContributor::binEdges(*makeDistribution(scene.design_variables[variable])));
  }
  return edges;
}

}  // namespace

const char* toString(SampleOutcome outcome) {
  constexpr std::array<const char*, kSampleOutcomes> kNames = {"solved", "snapped", "not_converged",
                                                               "impossible"};
  return kNames[static_cast<std::size_t>(outcome)];
}

bool hasValues(SampleOutcome outcome) {
  return outcome == SampleOutcome::solved || outcome == SampleOutcome::snapped;
}

std::uint64_t samplesNeeded(const SimulationStatistics& statistics, double error) {
  double most = static_cast<double>(statistics.samples);
  for (const MeasureStatistics& measure : statistics.statistics) {
    const auto done = static_cast<double>(statistics.samples);
    const auto needed = static_cast<double>(samplesNeeded(measure, error));  // with a value
    most = std::max(most, needed == 0.0 ? 2.0 * done : needed * done / static_cast<double>(measure.count));
  }
  return static_cast<std::uint64_t>(std::min(std::ceil(most), static_cast<double>(kMostSamples)));
}

SimulationAccumulator::SimulationAccumulator(const Scene& scene, const std::vector<std::size_t>& variables,
                                             const std::vector<std::size_t>& measures)
    : variables_(variables), measures_(measures), contributor_(edgesOf(scene, variables), measures.size()) {
  for (const std::size_t measure : measures) {
    accumulators_.emplace_back(scene.measures[measure].lower, scene.measures[measure].upper);
  }
}

void SimulationAccumulator::add(std::uint64_t index, SampleOutcome outcome, const double* deviations,
                                const double* values, const double* linear) {
  ++samples_;
  ++outcomes_[static_cast<std::size_t>(outcome)];
  if (outcome != SampleOutcome::solved && listed_.size() < SimulationStatistics::kMostListed) {
    listed_.push_back({index, outcome, {deviations, deviations + variables_.size()}});
  }
  const bool has_values = hasValues(outcome);
  for (std::size_t i = 0; i < accumulators_.size(); ++i) {
    accumulators_[i].add(has_values ? values[i] : kNaN, linear ? linear[i] : kNaN);
  }
  if (has_values) {
    contributor_.add(deviations, values);
  } else {
    contributor_.leaveOut();
  }
}

void SimulationAccumulator::merge(const SimulationAccumulator& later) {
  samples_ += later.samples_;
  for (std::size_t i = 0; i < outcomes_.size(); ++i) outcomes_[i] += later.outcomes_[i];
  const std::size_t room = SimulationStatistics::kMostListed - listed_.size();
  listed_.insert(listed_.end(), later.listed_.begin(),
                 later.listed_.begin() + static_cast<std::ptrdiff_t>(std::min(room, later.listed_.size())));
  for (std::size_t i = 0; i < accumulators_.size(); ++i) accumulators_[i].merge(later.accumulators_[i]);
  contributor_.merge(later.contributor_);
}

std::vector<RunningFigures> SimulationAccumulator::running() const {
  std::vector<RunningFigures> figures;
  figures.reserve(accumulators_.size());
  for (const MeasureAccumulator& accumulator : accumulators_) figures.push_back(accumulator.running());
  return figures;
}

SimulationStatistics SimulationAccumulator::statistics(
    double confidence, const std::vector<std::optional<LinearMoments>>& linear) const {
  SimulationStatistics result;
  result.variables = variables_;
  result.measures = measures_;
  result.samples = samples_;
  result.outcomes = outcomes_;
  result.listed = listed_;
  for (std::size_t i = 0; i < accumulators_.size(); ++i) {
    result.statistics.push_back(
        accumulators_[i].statistics(confidence, linear.empty() ? std::nullopt : linear.at(i)));
  }
  result.contributions = contributor_.contributions();
  return result;
}

}  // namespace cable_variation
