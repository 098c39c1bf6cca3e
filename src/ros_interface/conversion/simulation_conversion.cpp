#include <ros_interface/conversion/simulation_conversion.h>

#include <limits>

#include <ros_interface/conversion/matrix_conversion.h>
#include <ros_interface/conversion/measure_conversion.h>
#include <ros_interface/conversion/message_conversion.h>
#include <ros_interface/conversion/scene_conversion.h>

namespace cable_variation_ros {

using cable_variation::CableVariation;
using cable_variation::CableVariationInfo;
using cable_variation::Capability;
using cable_variation::CapabilityResult;
using cable_variation::ConfidenceInterval;
using cable_variation::ControlledEstimate;
using cable_variation::ControlledResult;
using cable_variation::ListedSample;
using cable_variation::Measure;
using cable_variation::MeasureStatistics;
using cable_variation::MeasureStatisticsResult;
using cable_variation::SampleOutcome;
using cable_variation::Scene;
using cable_variation::SectionVariation;
using cable_variation::SimulateVariationResponse;
using cable_variation::Simulation;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kMillion = 1e6;

CapabilityResult toResult(const Capability& capability) {
  constexpr ConfidenceInterval kNone{kNan, kNan};
  CapabilityResult result;
  result.cp = capability.cp.value_or(kNan);
  result.cp_low = capability.cp_interval.value_or(kNone).low;
  result.cp_high = capability.cp_interval.value_or(kNone).high;
  result.cpk = capability.cpk;
  result.cpk_low = capability.cpk_interval.low;
  result.cpk_high = capability.cpk_interval.high;
  result.cp_quantile = capability.cp_quantile.value_or(kNan);
  result.cpk_quantile = capability.cpk_quantile.value_or(kNan);
  result.below = capability.below;
  result.above = capability.above;
  result.outside_low = capability.outside_interval.low;
  result.outside_high = capability.outside_interval.high;
  result.outside_at_worst = capability.outside_at_worst;
  result.below_normal = capability.below_normal;
  result.above_normal = capability.above_normal;
  result.ppm_outside = kMillion * (capability.below + capability.above);
  result.ppm_outside_normal = kMillion * (capability.below_normal + capability.above_normal);
  return result;
}

ControlledResult toResult(const ControlledEstimate& controlled) {
  ControlledResult result;
  result.mean = controlled.mean;
  result.mean_low = controlled.mean_interval.low;
  result.mean_high = controlled.mean_interval.high;
  result.mean_gain = controlled.mean_gain;
  result.sigma = controlled.sigma;
  result.sigma_low = controlled.sigma_interval.low;
  result.sigma_high = controlled.sigma_interval.high;
  result.sigma_gain = controlled.sigma_gain;
  result.correlation = controlled.correlation;
  return result;
}

MeasureStatisticsResult toResult(const Measure& measure, double nominal, const MeasureStatistics& found) {
  auto result = described<MeasureStatisticsResult>(measure);
  result.nominal = nominal;
  result.count = found.count;
  result.infinite = found.infinite;
  result.missing = found.missing;
  result.confidence = found.confidence;
  result.mean = found.mean;
  result.mean_low = found.mean_interval.low;
  result.mean_high = found.mean_interval.high;
  result.sigma = found.sigma;
  result.sigma_low = found.sigma_interval.low;
  result.sigma_high = found.sigma_interval.high;
  result.skewness = found.skewness;
  result.kurtosis = found.kurtosis;
  result.min = found.min;
  result.max = found.max;
  for (const cable_variation::Percentile& percentile : found.percentiles) {
    result.percentile_share.push_back(percentile.share);
    result.percentile.push_back(percentile.value);
  }
  result.percentile_error = found.percentile_error;
  result.histogram_low = found.histogram.low;
  result.histogram_width = found.histogram.width;
  result.histogram_count = found.histogram.counts;
  result.has_capability = found.capability.has_value();
  if (found.capability) result.capability = toResult(*found.capability);
  result.has_controlled = found.controlled.has_value();
  if (found.controlled) result.controlled = toResult(*found.controlled);
  result.no_control = found.no_control;
  const MeasureStatistics::Estimate mean = found.bestMean(), sigma = found.bestSigma();
  result.best_mean = mean.value;
  result.best_mean_low = mean.interval.low;
  result.best_mean_high = mean.interval.high;
  result.best_mean_controlled = mean.controlled;
  result.best_sigma = sigma.value;
  result.best_sigma_low = sigma.interval.low;
  result.best_sigma_high = sigma.interval.high;
  result.best_sigma_controlled = sigma.controlled;
  return result;
}

CableVariationInfo toInfo(const Scene& scene, const CableVariation& variation) {
  CableVariationInfo info;
  info.cable = scene.harness.cables[variation.cable].name;
  info.arc_length = variation.arc_length;
  for (const SectionVariation& section : variation.sections) {
    const Eigen::Matrix3d& directions = section.axes.directions;
    info.mean.push_back(toPoint(section.mean));
    info.six_sigma.push_back(6.0 * section.axes.sigma[0]);
    info.range.push_back(section.range.maxCoeff());
    info.direction.push_back(toVector(directions.col(0)));
    info.second.push_back(toVector(directions.col(1)));
    info.third.push_back(toVector(directions.col(2)));
    info.sigma.push_back(toVector(section.axes.sigma));
  }
  return info;
}

cable_variation::SampleInfo toInfo(const ListedSample& sample) {
  cable_variation::SampleInfo info;
  info.index = sample.index;
  info.outcome = toString(sample.outcome);
  info.deviations = sample.deviations;
  return info;
}

cable_variation::SimulatedTimeInfo toInfo(const cable_variation::SimulatedTime& time) {
  cable_variation::SimulatedTimeInfo info;
  info.time = time.time;
  info.largest_six_sigma = time.largest_6s;
  info.worst = time.worst;
  return info;
}

}  // namespace

SimulateVariationResponse toResponse(const Scene& scene, const cable_variation::DesignValues& values,
                                     const Simulation& simulation) {
  const cable_variation::SimulationStatistics& found = simulation.statistics;
  SimulateVariationResponse response;
  response.samples = found.samples;
  response.wanted = found.wanted;
  response.seed = found.seed;
  response.sampler = toString(found.sampler);
  response.solved = found.count(SampleOutcome::solved);
  response.snapped = found.count(SampleOutcome::snapped);
  response.not_converged = found.count(SampleOutcome::not_converged);
  response.impossible = found.count(SampleOutcome::impossible);
  for (const ListedSample& sample : found.listed) response.listed.push_back(toInfo(sample));
  response.variables = toInfos(scene, found.variables, values);
  const auto row = [](std::size_t i) { return static_cast<Eigen::Index>(i); };
  for (std::size_t i = 0; i < found.measures.size(); ++i) {
    response.measures.push_back(
        toResult(scene.measures[found.measures[i]], found.nominal[i], found.statistics[i]));
    MeasureStatisticsResult& measure = response.measures.back();
    const Eigen::VectorXd& r_squared = found.contributions.r_squared;
    measure.r_squared = row(i) < r_squared.size() ? r_squared[row(i)] : kNan;
    measure.linear_sigma = simulation.linear.sigma[row(i)];
    if (i < simulation.missed.size()) measure.missed = simulation.missed[i];
  }
  response.first_order = rowByRow(found.contributions.first_order);
  response.first_order_bins = static_cast<std::uint32_t>(found.contributions.bins);
  response.regression_share = rowByRow(found.contributions.regression_share);
  response.regression_slope = rowByRow(found.contributions.slope);
  response.linear_contribution = rowByRow(simulation.linear.contribution);
  response.contribution_samples = found.contributions.count;
  for (const CableVariation& cable : simulation.cables) response.cables.push_back(toInfo(scene, cable));
  response.shown_time = simulation.shown_time;
  for (const cable_variation::SimulatedTime& time : simulation.times) response.times.push_back(toInfo(time));
  response.solved_again = simulation.solved_again;
  response.discretisation_error = simulation.discretisation_error;
  response.warnings = simulation.warnings;
  response.simulation_time = simulation.time;
  if (simulation.time > 0.0) {
    response.samples_per_second = static_cast<double>(found.samples) / simulation.time;
  }
  return response;
}

}  // namespace cable_variation_ros
