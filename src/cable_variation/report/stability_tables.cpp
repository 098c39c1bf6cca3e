#include <cable_variation/report/stability_tables.h>

#include <cmath>

#include <cable_variation/report/markup.h>
#include <cable_variation/util/display_unit.h>

namespace cable_variation {

namespace {

ReportCell limit(const std::optional<double>& value, const DisplayUnit& unit) {
  return {value ? figure(unit.factor * *value) : "", 0.0, false};
}

std::string unitsOf(const DisplayUnit& measure, const DisplayUnit& variable) {
  const bool is_ratio = measure.symbol.find('/') != std::string::npos;
  const bool is_product = variable.symbol.find(' ') != std::string::npos;
  return (is_ratio ? "(" + measure.symbol + ")" : measure.symbol) + "/" +
         (is_product ? "(" + variable.symbol + ")" : variable.symbol);
}

}  // namespace

double nominalValue(const DesignVariable& variable, const DesignValues& values) {
  const auto found = values.find(variable.name);
  return found == values.end() ? variable.nominal : found->second;
}

ReportTable measureTable(const Scene& scene, const StabilityAnalysis& analysis) {
  ReportTable table{"At the nominal design",
                    {"measure", "kind", "value", "lower limit", "upper limit", "unit", "note"},
                    {}};
  for (std::size_t i = 0; i < analysis.measures.size(); ++i) {
    const Measure& measure = scene.measures[analysis.measures[i]];
    const MeasureValue& value = analysis.values[i];
    const DisplayUnit unit = displayUnit(measure.unit);
    std::string note = value.note;
    if (!analysis.whyUndefined(i).empty())
      note += std::string(note.empty() ? "" : "; ") + "derivatives not defined: " + analysis.whyUndefined(i);
    if (!value.unique) note += std::string(note.empty() ? "" : "; ") + "found at more than one place";
    table.rows.push_back({{measure.name, 0.0, false},
                          {toString(measure.type), 0.0, false},
                          {figure(unit.factor * withoutRounding(value.value, measure.unit)), 0.0,
                           beyondLimits(measure, value.value)},
                          limit(measure.lower, unit),
                          limit(measure.upper, unit),
                          {unit.symbol, 0.0, false},
                          {note, 0.0, false}});
  }
  return table;
}

ReportTable spreadTable(const Scene& scene, const StabilityAnalysis& analysis) {
  ReportTable table{
      "To first order; beyond a limit in bold red",
      {"measure", "mean", "σ", "mean − 3 σ", "mean + 3 σ", "worst case low", "worst case high", "unit"},
      {}};
  for (std::size_t i = 0; i < analysis.measures.size(); ++i) {
    const Measure& measure = scene.measures[analysis.measures[i]];
    const DisplayUnit unit = displayUnit(measure.unit);
    const auto row = static_cast<Eigen::Index>(i);
    const double nominal = analysis.values[i].value, sigma = analysis.sigma[row];
    const double mean = nominal + analysis.mean_shift[row];
    if (!analysis.whyUndefined(i).empty()) {
      table.rows.push_back({{measure.name, 0.0, false}});
      table.rows.back().resize(table.columns.size(), {"not defined", 0.0, false});
      table.rows.back().back() = {unit.symbol, 0.0, false};
      continue;
    }
    const auto cell = [&](double value) {
      return ReportCell{figure(unit.factor * withoutRounding(value, measure.unit)), 0.0,
                        beyondLimits(measure, value)};
    };
    table.rows.push_back({{measure.name, 0.0, false},
                          cell(mean),
                          {figure(unit.factor * withoutRounding(sigma, measure.unit)), 0.0, false},
                          cell(mean - 3.0 * sigma),
                          cell(mean + 3.0 * sigma),
                          cell(nominal + analysis.worst_low[row]),
                          cell(nominal + analysis.worst_high[row]),
                          {unit.symbol, 0.0, false}});
  }
  return table;
}

ReportTable sensitivityTable(const Scene& scene, const StabilityAnalysis& analysis) {
  ReportTable table{
      "Derivatives; the darker, the larger the variable's share in the measure's variance", {"variable"}, {}};
  for (std::size_t i = 0; i < analysis.measures.size(); ++i) {
    const Measure& measure = scene.measures[analysis.measures[i]];
    table.columns.push_back(measure.name + (analysis.one_sided[i] ? " *" : ""));
  }
  for (std::size_t j = 0; j < analysis.variables.size(); ++j) {
    const DesignVariable& variable = scene.design_variables[analysis.variables[j]];
    const DisplayUnit by = displayUnit(variable.unit);
    std::vector<ReportCell> row{{variable.name, 0.0, false}};
    for (std::size_t i = 0; i < analysis.measures.size(); ++i) {
      const DisplayUnit unit = displayUnit(scene.measures[analysis.measures[i]].unit);
      const auto r = static_cast<Eigen::Index>(i), c = static_cast<Eigen::Index>(j);
      const std::string units = unitsOf(unit, by);
      if (!analysis.whyUndefined(i).empty()) {
        row.push_back({"not defined", 0.0, false});
        continue;
      }
      row.push_back(
          {figure(unit.factor / by.factor * analysis.jacobian(r, c), 3) + (units.empty() ? "" : " " + units),
           analysis.contribution(r, c), false});
    }
    table.rows.push_back(row);
  }
  return table;
}

ReportTable variableTable(const Scene& scene, const StabilityAnalysis& analysis, const DesignValues& values) {
  const bool re_solved = !analysis.eigenvalue_low.empty();
  ReportTable table{"", {"variable", "nominal", "lower", "upper", "σ", "unit", "distribution"}, {}};
  if (re_solved) {
    table.columns.emplace_back("eigenvalue low\n[N/m]");
    table.columns.emplace_back("eigenvalue high\n[N/m]");
  }
  for (std::size_t j = 0; j < analysis.variables.size(); ++j) {
    const DesignVariable& variable = scene.design_variables[analysis.variables[j]];
    const DisplayUnit unit = displayUnit(variable.unit);
    const auto cell = [&](double value) { return ReportCell{figure(unit.factor * value), 0.0, false}; };
    table.rows.push_back({{variable.name, 0.0, false},
                          cell(nominalValue(variable, values)),
                          cell(variable.lower),
                          cell(variable.upper),
                          cell(analysis.variable_sigma[static_cast<Eigen::Index>(j)]),
                          {unit.symbol, 0.0, false},
                          {variable.distribution, 0.0, false}});
    if (re_solved) {
      for (const double value : {analysis.eigenvalue_low[j], analysis.eigenvalue_high[j]}) {
        table.rows.back().push_back({figure(value), 0.0, false});
      }
    }
  }
  return table;
}

}  // namespace cable_variation
