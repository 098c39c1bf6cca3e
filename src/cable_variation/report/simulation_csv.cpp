#include <cable_variation/report/csv.h>
#include <cable_variation/report/simulation_section.h>

namespace cable_variation {

namespace {

using csv::number;

std::string ofMeasure(const Measure& measure) {
  return csv::text(measure.name) + "," + csv::text(measure.unit);
}

std::string ends(const ConfidenceInterval& interval) {
  return "," + number(interval.low) + "," + number(interval.high);
}
std::string ends(const std::optional<ConfidenceInterval>& interval) {
  return interval ? ends(*interval) : ",,";
}

std::string capabilityColumns(const std::optional<Capability>& capability) {
  if (!capability) return std::string(15, ',');
  const Capability& c = *capability;
  return "," + number(c.cp) + ends(c.cp_interval) + "," + number(c.cpk) + ends(c.cpk_interval) + "," +
         number(c.cp_quantile) + "," + number(c.cpk_quantile) + "," + number(c.below) + "," +
         number(c.above) + ends(c.outside_interval) + "," + number(c.outside_at_worst) + "," +
         number(c.below_normal) + "," + number(c.above_normal);
}

std::string controlColumns(const std::optional<ControlledEstimate>& controlled) {
  if (!controlled) return std::string(8, ',');
  const ControlledEstimate& c = *controlled;
  return "," + number(c.mean) + ends(c.mean_interval) + "," + number(c.mean_gain) + "," + number(c.sigma) +
         ends(c.sigma_interval) + "," + number(c.sigma_gain);
}

std::string bestColumns(const MeasureStatistics::Estimate& best) {
  return "," + number(best.value) + ends(best.interval) + (best.controlled ? ",controlled" : ",plain");
}

}  // namespace

std::string statisticsCsv(const Scene& scene, const SimulationStatistics& statistics) {
  std::string table =
      "measure,measure_unit,lower_limit,upper_limit,nominal,samples,without_value,infinite,confidence,mean,"
      "mean_low,mean_high,sigma,sigma_low,sigma_high,skewness,kurtosis,min,max,cp,cp_low,cp_high,cpk,cpk_low,"
      "cpk_high,cp_quantile,cpk_quantile,below,above,outside_low,outside_high,outside_at_worst,below_normal,"
      "above_normal,controlled_mean,controlled_mean_low,controlled_mean_high,mean_gain,controlled_sigma,"
      "controlled_sigma_low,controlled_sigma_high,sigma_gain,best_mean,best_mean_low,best_mean_high,"
      "best_mean_is,best_sigma,best_sigma_low,best_sigma_high,best_sigma_is,percentile_error";
  if (!statistics.statistics.empty()) {
    for (const Percentile& percentile : statistics.statistics.front().percentiles) {
      table += ",p" + std::to_string(percentile.share);
    }
  }
  table += "\r\n";
  for (std::size_t i = 0; i < statistics.measures.size(); ++i) {
    const Measure& measure = scene.measures[statistics.measures[i]];
    const MeasureStatistics& s = statistics.statistics[i];
    table += ofMeasure(measure) + "," + number(measure.lower) + "," + number(measure.upper) + "," +
             number(statistics.nominal[i]) + "," + std::to_string(s.count) + "," + std::to_string(s.missing) +
             "," + std::to_string(s.infinite) + "," + number(s.confidence) + "," + number(s.mean) +
             ends(s.mean_interval) + "," + number(s.sigma) + ends(s.sigma_interval) + "," +
             number(s.skewness) + "," + number(s.kurtosis) + "," + number(s.min) + "," + number(s.max) +
             capabilityColumns(s.capability) + controlColumns(s.controlled) + bestColumns(s.bestMean()) +
             bestColumns(s.bestSigma()) + "," + number(s.percentile_error);
    for (const Percentile& percentile : s.percentiles) table += "," + number(percentile.value);
    table += "\r\n";
  }
  return table;
}

std::string contributionCsv(const Scene& scene, const SimulationStatistics& statistics) {
  const VarianceContributions& found = statistics.contributions;
  std::string table =
      "measure,measure_unit,variable,variable_unit,samples,left_out,slope,standardised_slope,regression_"
      "share,"
      "r_squared,first_order_index,bins\r\n";
  for (std::size_t i = 0; i < statistics.measures.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    for (std::size_t j = 0; j < statistics.variables.size(); ++j) {
      const auto column = static_cast<Eigen::Index>(j);
      const DesignVariable& variable = scene.design_variables[statistics.variables[j]];
      table += ofMeasure(scene.measures[statistics.measures[i]]) + "," + csv::text(variable.name) + "," +
               csv::text(variable.unit) + "," + std::to_string(found.count) + "," +
               std::to_string(found.left_out) + ",";
      table += found.slope.size() == 0
                   ? ",,,"
                   : number(found.slope(row, column)) + "," + number(found.standardised(row, column)) + "," +
                         number(found.regression_share(row, column)) + "," + number(found.r_squared[row]);
      table += "," + (found.first_order.size() == 0 ? "" : number(found.first_order(row, column))) + "," +
               std::to_string(found.bins) + "\r\n";
    }
  }
  return table;
}

}  // namespace cable_variation
