#include <command/simulation_json.h>

#include <limits>
#include <utility>

#include <command/scene_json.h>

namespace cable_variation_command {

using cable_variation::CableVariation;
using cable_variation::Capability;
using cable_variation::ConfidenceInterval;
using cable_variation::ControlledEstimate;
using cable_variation::MeasureStatistics;
using cable_variation::SampleOutcome;
using cable_variation::Scene;
using cable_variation::Simulation;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kMillion = 1e6;

void setInterval(const std::string& name, const ConfidenceInterval& interval, Json& json) {
  json.set(name + "_low", interval.low).set(name + "_high", interval.high);
}

Json capabilityJson(const Capability& found) {
  constexpr ConfidenceInterval kNone{kNan, kNan};
  Json json = Json::object();
  json.set("cp", found.cp.value_or(kNan));
  setInterval("cp", found.cp_interval.value_or(kNone), json);
  json.set("cpk", found.cpk);
  setInterval("cpk", found.cpk_interval, json);
  json.set("cp_quantile", found.cp_quantile.value_or(kNan));
  json.set("cpk_quantile", found.cpk_quantile.value_or(kNan));
  json.set("below", found.below).set("above", found.above);
  setInterval("outside", found.outside_interval, json);
  json.set("outside_at_worst", found.outside_at_worst).set("below_normal", found.below_normal);
  json.set("above_normal", found.above_normal).set("ppm_outside", kMillion * (found.below + found.above));
  return json.set("ppm_outside_normal", kMillion * (found.below_normal + found.above_normal));
}

Json controlledJson(const ControlledEstimate& found) {
  Json json = Json::object();
  json.set("mean", found.mean);
  setInterval("mean", found.mean_interval, json);
  json.set("mean_gain", found.mean_gain).set("sigma", found.sigma);
  setInterval("sigma", found.sigma_interval, json);
  return json.set("sigma_gain", found.sigma_gain).set("correlation", found.correlation);
}

void setBest(const std::string& name, const MeasureStatistics::Estimate& best, Json& json) {
  json.set(name, best.value);
  setInterval(name, best.interval, json);
  json.set(name + "_controlled", best.controlled);
}

void setStatistics(const MeasureStatistics& found, Json& json) {
  json.set("count", found.count).set("infinite", found.infinite).set("missing", found.missing);
  json.set("confidence", found.confidence).set("mean", found.mean);
  setInterval("mean", found.mean_interval, json);
  json.set("sigma", found.sigma);
  setInterval("sigma", found.sigma_interval, json);
  json.set("skewness", found.skewness).set("kurtosis", found.kurtosis);
  json.set("min", found.min).set("max", found.max);
  Json shares = Json::array(), percentiles = Json::array();
  for (const cable_variation::Percentile& percentile : found.percentiles) {
    shares.add(percentile.share);
    percentiles.add(percentile.value);
  }
  json.set("percentile_share", std::move(shares)).set("percentile", std::move(percentiles));
  json.set("percentile_error", found.percentile_error).set("histogram_low", found.histogram.low);
  json.set("histogram_width", found.histogram.width).set("histogram_count", found.histogram.counts);
  json.set("has_capability", found.capability.has_value());
  if (found.capability) json.set("capability", capabilityJson(*found.capability));
  json.set("has_controlled", found.controlled.has_value());
  if (found.controlled) json.set("controlled", controlledJson(*found.controlled));
  json.set("no_control", found.no_control);
  setBest("best_mean", found.bestMean(), json);
  setBest("best_sigma", found.bestSigma(), json);
}

Json measuresJson(const Scene& scene, const Simulation& simulation) {
  const cable_variation::SimulationStatistics& found = simulation.statistics;
  const Eigen::VectorXd& r_squared = found.contributions.r_squared;
  Json list = Json::array();
  for (std::size_t i = 0; i < found.measures.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    Json json = measureJson(scene.measures[found.measures[i]]);
    json.set("nominal", found.nominal[i]);
    setStatistics(found.statistics[i], json);
    json.set("r_squared", row < r_squared.size() ? r_squared[row] : kNan);
    json.set("linear_sigma", simulation.linear.sigma[row]);
    list.add(json.set("missed", i < simulation.missed.size() ? simulation.missed[i] : 0.0));
  }
  return list;
}

Json cableJson(const Scene& scene, const CableVariation& variation) {
  Json mean = Json::array(), six_sigma = Json::array(), range = Json::array(), sigma = Json::array();
  Json direction = Json::array(), second = Json::array(), third = Json::array();
  for (const cable_variation::SectionVariation& section : variation.sections) {
    const Eigen::Matrix3d& axes = section.axes.directions;
    const Eigen::Vector3d axis[] = {axes.col(0), axes.col(1), axes.col(2)};
    mean.add(section.mean);
    six_sigma.add(6.0 * section.axes.sigma[0]);
    range.add(section.range.maxCoeff());
    direction.add(axis[0]);
    second.add(axis[1]);
    third.add(axis[2]);
    sigma.add(section.axes.sigma);
  }
  Json json = Json::object();
  json.set("cable", scene.harness.cables[variation.cable].name).set("arc_length", variation.arc_length);
  json.set("mean", std::move(mean)).set("six_sigma", std::move(six_sigma)).set("range", std::move(range));
  json.set("direction", std::move(direction)).set("second", std::move(second)).set("third", std::move(third));
  return json.set("sigma", std::move(sigma));
}

void setContributions(const Simulation& simulation, Json& json) {
  const cable_variation::VarianceContributions& found = simulation.statistics.contributions;
  json.set("first_order", rowByRow(found.first_order)).set("first_order_bins", found.bins);
  json.set("regression_share", rowByRow(found.regression_share))
      .set("regression_slope", rowByRow(found.slope));
  json.set("linear_contribution", rowByRow(simulation.linear.contribution));
  json.set("contribution_samples", found.count);
}

}  // namespace

Json simulationJson(const Scene& scene, const cable_variation::DesignValues& values,
                    const Simulation& simulation) {
  const cable_variation::SimulationStatistics& found = simulation.statistics;
  Json listed = Json::array(), cables = Json::array(), times = Json::array();
  for (const cable_variation::ListedSample& sample : found.listed) {
    Json json = Json::object();
    json.set("index", sample.index).set("outcome", toString(sample.outcome));
    listed.add(json.set("deviations", sample.deviations));
  }
  for (const CableVariation& cable : simulation.cables) cables.add(cableJson(scene, cable));
  for (const cable_variation::SimulatedTime& time : simulation.times) {
    Json json = Json::object();
    json.set("time", time.time).set("largest_six_sigma", time.largest_6s);
    times.add(json.set("worst", time.worst));
  }
  Json json = Json::object();
  json.set("samples", found.samples).set("wanted", found.wanted).set("seed", found.seed);
  json.set("sampler", toString(found.sampler)).set("solved", found.count(SampleOutcome::solved));
  json.set("snapped", found.count(SampleOutcome::snapped));
  json.set("not_converged", found.count(SampleOutcome::not_converged));
  json.set("impossible", found.count(SampleOutcome::impossible)).set("listed", std::move(listed));
  json.set("variables", variablesJson(scene, found.variables, values));
  json.set("measures", measuresJson(scene, simulation));
  setContributions(simulation, json);
  json.set("cables", std::move(cables))
      .set("shown_time", simulation.shown_time)
      .set("times", std::move(times));
  json.set("solved_again", simulation.solved_again);
  json.set("discretisation_error", simulation.discretisation_error).set("warnings", simulation.warnings);
  json.set("simulation_time", simulation.time);
  const double rate = simulation.time > 0.0 ? static_cast<double>(found.samples) / simulation.time : 0.0;
  return json.set("samples_per_second", rate);
}

}  // namespace cable_variation_command
