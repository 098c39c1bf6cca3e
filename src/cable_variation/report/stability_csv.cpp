#include <cable_variation/report/stability_section.h>

#include <cmath>

#include <cable_variation/report/csv.h>
#include <cable_variation/report/stability_tables.h>

namespace cable_variation {

using csv::number;

namespace {

// What is to be said of a measure: why it is not defined, and what to know of its value.
std::string noteOn(const StabilityAnalysis& analysis, std::size_t measure) {
  const std::string undefined = analysis.whyUndefined(measure);
  return undefined.empty() ? analysis.values[measure].note : "not defined: " + undefined;
}

}  // namespace

std::string lowHighNote(const Scene& scene, const StabilityAnalysis& analysis, std::size_t measure,
                        std::size_t variable) {
  if (analysis.low_high.empty()) return "";
  const DesignVariable& varied = scene.design_variables[analysis.variables[variable]];
  std::string note;
  const auto add = [&](const std::string& text) { note += (note.empty() ? "" : "; ") + text; };
  const LowHigh& values = analysis.low_high[measure][variable];
  if (std::isnan(values.low)) add("low not defined: no equilibrium there");
  if (std::isnan(values.high)) add("high not defined: no equilibrium there");
  for (const SnapWithin& snap : analysis.snaps) {
    if (snap.variable != analysis.variables[variable]) continue;
    add((snap.deviation < 0.0 ? "low" : "high") + std::string(" is of another equilibrium: a snap at ") +
        deviationText(varied, snap.deviation));
  }
  return note;
}

std::string stabilityCsv(const Scene& scene, const StabilityAnalysis& analysis, const DesignValues& values) {
  std::string table =
      "measure,measure_unit,value,lower_limit,upper_limit,mean_shift,sigma,worst_low,worst_high,variable,"
      "variable_unit,nominal,tolerance_lower,tolerance_upper,variable_sigma,derivative,one_sided,"
      "contribution,"
      "low,high,note,low_high_note\r\n";
  for (std::size_t i = 0; i < analysis.measures.size(); ++i) {
    const Measure& measure = scene.measures[analysis.measures[i]];
    const auto r = static_cast<Eigen::Index>(i);
    const std::string of_measure = csv::text(measure.name) + "," + csv::text(measure.unit) + "," +
                                   number(analysis.values[i].value) + "," + number(measure.lower) + "," +
                                   number(measure.upper) + "," + number(analysis.mean_shift[r]) + "," +
                                   number(analysis.sigma[r]) + "," + number(analysis.worst_low[r]) + "," +
                                   number(analysis.worst_high[r]);
    for (std::size_t j = 0; j < analysis.variables.size(); ++j) {
      const DesignVariable& variable = scene.design_variables[analysis.variables[j]];
      const auto c = static_cast<Eigen::Index>(j);
      table += of_measure + "," + csv::text(variable.name) + "," + csv::text(variable.unit) + "," +
               number(nominalValue(variable, values)) + "," + number(variable.lower) + "," +
               number(variable.upper) + "," + number(analysis.variable_sigma[c]) + "," +
               number(analysis.jacobian(r, c)) + "," + (analysis.one_sided[i] ? "1" : "0") + "," +
               number(analysis.contribution(r, c)) + ",";
      if (!analysis.low_high.empty()) {
        table += number(analysis.low_high[i][j].low) + "," + number(analysis.low_high[i][j].high);
      } else {
        table += ",";
      }
      table +=
          "," + csv::text(noteOn(analysis, i)) + "," + csv::text(lowHighNote(scene, analysis, i, j)) + "\r\n";
    }
  }
  return table;
}

}  // namespace cable_variation
