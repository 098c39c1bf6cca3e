#include <cable_variation/report/stability_section.h>

#include <cmath>
#include <cstdio>

#include <cable_variation/report/stability_tables.h>

namespace cable_variation {

namespace {

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') result += '"';
    result += c;
  }
  return result + "\"";
}

/// Read back to the same double everywhere; nan where there is none.
std::string number(double value) {
  if (std::isnan(value)) return "nan";
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

std::string number(const std::optional<double>& value) { return value ? number(*value) : ""; }

}  // namespace

std::string stabilityCsv(const Scene& scene, const StabilityAnalysis& analysis, const DesignValues& values) {
  std::string csv =
      "measure,measure_unit,value,lower_limit,upper_limit,mean_shift,sigma,worst_low,worst_high,variable,"
      "variable_unit,nominal,tolerance_lower,tolerance_upper,variable_sigma,derivative,one_sided,"
      "contribution,"
      "low,high\r\n";
  for (std::size_t i = 0; i < analysis.measures.size(); ++i) {
    const Measure& measure = scene.measures[analysis.measures[i]];
    const auto r = static_cast<Eigen::Index>(i);
    const std::string of_measure = quoted(measure.name) + "," + quoted(measure.unit) + "," +
                                   number(analysis.values[i].value) + "," + number(measure.lower) + "," +
                                   number(measure.upper) + "," + number(analysis.mean_shift[r]) + "," +
                                   number(analysis.sigma[r]) + "," + number(analysis.worst_low[r]) + "," +
                                   number(analysis.worst_high[r]);
    for (std::size_t j = 0; j < analysis.variables.size(); ++j) {
      const DesignVariable& variable = scene.design_variables[analysis.variables[j]];
      const auto c = static_cast<Eigen::Index>(j);
      csv += of_measure + "," + quoted(variable.name) + "," + quoted(variable.unit) + "," +
             number(nominalValue(variable, values)) + "," + number(variable.lower) + "," +
             number(variable.upper) + "," + number(analysis.variable_sigma[c]) + "," +
             number(analysis.jacobian(r, c)) + "," + (analysis.one_sided[i] ? "1" : "0") + "," +
             number(analysis.contribution(r, c)) + ",";
      if (!analysis.low_high.empty()) {
        csv += number(analysis.low_high[i][j].low) + "," + number(analysis.low_high[i][j].high);
      } else {
        csv += ",";
      }
      csv += "\r\n";
    }
  }
  return csv;
}

}  // namespace cable_variation
