#include <cable_variation/report/simulation_tables.h>

#include <algorithm>
#include <cmath>

#include <cable_variation/report/markup.h>
#include <cable_variation/report/stability_tables.h>
#include <cable_variation/util/display_unit.h>

namespace cable_variation {

namespace {

std::string between(const ConfidenceInterval& interval, double factor, int digits = 4) {
  constexpr int kMostDigits = 9;
  std::string low, high;
  do {  // to as many digits as tell the ends apart
    low = figure(factor * interval.low, digits);
    high = figure(factor * interval.high, digits);
  } while (low == high && interval.low < interval.high && ++digits <= kMostDigits);
  return low + " … " + high;
}

ReportCell optional(const std::optional<double>& value, double factor, int digits = 4) {
  return plain(value ? figure(factor * *value, digits) : "");
}

// Below 1 the spread does not fit between the limits.
ReportCell index(double value) { return {figure(value, 3), 0.0, value < 1.0}; }

// What is less than half a thousandth is nothing here.
double inThousandths(double value) { return std::round(1e3 * value) / 1e3; }

ReportCell marked(ReportCell cell, const MeasureStatistics::Estimate& estimate) {
  if (estimate.controlled) cell.text += " *";
  return cell;
}

std::string gain(double factor) { return factor > 1000.0 ? "> 1000" : figure(factor, 3); }

std::string confidenceText(const SimulationStatistics& statistics) {
  const double confidence = statistics.statistics.empty() ? 0.95 : statistics.statistics.front().confidence;
  return figure(100.0 * confidence, 3) + " %";
}

}  // namespace

ReportTable meanTable(const Scene& scene, const SimulationStatistics& statistics) {
  const std::string at = "\nat " + confidenceText(statistics);
  ReportTable table{
      "Of all samples that have a finite value. * Mean and σ sharpened by the linear model as control "
      "variate, where that makes their interval narrower",
      {"measure", "nominal", "mean", "mean between" + at, "σ", "σ between" + at, "smallest", "largest",
       "skewness", "kurtosis", "unit", "samples", "without\nvalue", "infinite"},
      {}};
  for (std::size_t i = 0; i < statistics.measures.size(); ++i) {
    const Measure& measure = scene.measures[statistics.measures[i]];
    const MeasureStatistics& s = statistics.statistics[i];
    const DisplayUnit unit = displayUnit(measure.unit);
    const MeasureStatistics::Estimate mean = s.bestMean(), sigma = s.bestSigma();
    const auto cell = [&](double value) {
      return ReportCell{figure(unit.factor * withoutRounding(value, measure.unit)), 0.0,
                        beyondLimits(measure, value)};
    };
    table.rows.push_back(
        {plain(measure.name),
         cell(statistics.nominal[i]),
         marked(cell(mean.value), mean),
         plain(between(mean.interval, unit.factor)),
         marked(plain(figure(unit.factor * withoutRounding(sigma.value, measure.unit))), sigma),
         plain(between(sigma.interval, unit.factor)),
         cell(s.min),
         cell(s.max),
         plain(figure(inThousandths(s.skewness), 3)),
         plain(figure(inThousandths(s.kurtosis), 3)),
         plain(unit.symbol),
         plain(std::to_string(s.count)),
         {std::to_string(s.missing), 0.0, s.missing > 0},
         plain(std::to_string(s.infinite))});
  }
  return table;
}

ReportTable capabilityTable(const Scene& scene, const SimulationStatistics& statistics) {
  ReportTable table{"Limits, capability and rejects",
                    {"measure", "lower\nlimit", "upper\nlimit", "unit", "Cp", "Cpk",
                     "Cpk between\nat " + confidenceText(statistics), "Cpk by\nquantiles",
                     "outside\nobserved", "outside between\nat " + confidenceText(statistics),
                     "outside, with those\nwithout value", "outside if\nnormal"},
                    {}};
  for (std::size_t i = 0; i < statistics.measures.size(); ++i) {
    const MeasureStatistics& s = statistics.statistics[i];
    if (!s.capability) continue;
    const Measure& measure = scene.measures[statistics.measures[i]];
    const DisplayUnit unit = displayUnit(measure.unit);
    const Capability& c = *s.capability;
    table.rows.push_back(
        {plain(measure.name), optional(measure.lower, unit.factor), optional(measure.upper, unit.factor),
         plain(unit.symbol), c.cp ? index(*c.cp) : plain(""), index(c.cpk),
         plain(between(c.cpk_interval, 1.0, 3)), c.cpk_quantile ? index(*c.cpk_quantile) : plain(""),
         plain(rejectText(c.below + c.above)), plain(between(c.outside_interval, 100.0, 3) + " %"),
         plain(rejectText(c.outside_at_worst)), plain(rejectText(c.below_normal + c.above_normal))});
  }
  return table;
}

ReportTable percentileTable(const Scene& scene, const SimulationStatistics& statistics) {
  ReportTable table{"Percentiles: that share of the samples lies below", {"measure"}, {}};
  for (std::size_t i = 0; i < statistics.measures.size(); ++i) {
    const MeasureStatistics& s = statistics.statistics[i];
    if (i == 0) {
      for (const Percentile& percentile : s.percentiles) {
        table.columns.push_back(figure(100.0 * percentile.share, 5) + " %");
      }
      table.columns.insert(table.columns.end(), {"unit", "known to"});
    }
    const DisplayUnit unit = displayUnit(scene.measures[statistics.measures[i]].unit);
    std::vector<ReportCell> row{plain(scene.measures[statistics.measures[i]].name)};
    for (const Percentile& percentile : s.percentiles) {
      row.push_back(plain(figure(unit.factor * percentile.value)));
    }
    row.push_back(plain(unit.symbol));
    row.push_back(plain(s.percentile_error > 0.0 ? figure(unit.factor * s.percentile_error, 2) : "exact"));
    table.rows.push_back(row);
  }
  return table;
}

ReportTable controlTable(const Scene& scene, const SimulationStatistics& statistics) {
  const std::string at = "\nat " + confidenceText(statistics);
  ReportTable table{
      "Mean and σ without and with what is known of the linear model (control variate); gain: so many times "
      "as "
      "many samples would say as much without it",
      {"measure", "mean of the\nsamples", "σ of the\nsamples", "mean with\ncontrol", "mean between" + at,
       "gain", "σ with\ncontrol", "σ between" + at, "gain", "unit", "note"},
      {}};
  for (std::size_t i = 0; i < statistics.measures.size(); ++i) {
    const MeasureStatistics& s = statistics.statistics[i];
    const DisplayUnit unit = displayUnit(scene.measures[statistics.measures[i]].unit);
    std::vector<ReportCell> row{plain(scene.measures[statistics.measures[i]].name),
                                plain(figure(unit.factor * s.mean)), plain(figure(unit.factor * s.sigma))};
    if (s.controlled) {
      const ControlledEstimate& c = *s.controlled;
      row.insert(row.end(),
                 {plain(figure(unit.factor * c.mean)), plain(between(c.mean_interval, unit.factor)),
                  plain(gain(c.mean_gain)), plain(figure(unit.factor * c.sigma)),
                  plain(between(c.sigma_interval, unit.factor)), plain(gain(c.sigma_gain)),
                  plain(unit.symbol), plain("")});
    } else {
      row.insert(row.end(), 6, plain(""));
      row.push_back(plain(unit.symbol));
      row.push_back(plain(s.no_control));
    }
    table.rows.push_back(row);
  }
  return table;
}

ReportTable shareTable(const Scene& scene, const SimulationStatistics& statistics, const std::string& caption,
                       const Eigen::MatrixXd& share) {
  ReportTable table{caption, {"variable"}, {}};
  for (const std::size_t measure : statistics.measures) table.columns.push_back(scene.measures[measure].name);
  for (std::size_t j = 0; j < statistics.variables.size(); ++j) {
    std::vector<ReportCell> row{plain(scene.design_variables[statistics.variables[j]].name)};
    for (std::size_t i = 0; i < statistics.measures.size(); ++i) {
      const double value = share(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      row.push_back({percent(inThousandths(value)), std::isnan(value) ? 0.0 : std::max(value, 0.0), false});
    }
    table.rows.push_back(row);
  }
  return table;
}

ReportTable listedTable(const Scene& scene, const SimulationStatistics& statistics,
                        const DesignValues& values, std::size_t most) {
  ReportTable table{"", {"sample", "outcome"}, {}};
  for (const std::size_t j : statistics.variables) {
    const DisplayUnit unit = displayUnit(scene.design_variables[j].unit);
    table.columns.push_back(scene.design_variables[j].name +
                            (unit.symbol.empty() ? "" : "\n[" + unit.symbol + "]"));
  }
  for (std::size_t k = 0; k < std::min(most, statistics.listed.size()); ++k) {
    const ListedSample& sample = statistics.listed[k];
    std::vector<ReportCell> row{plain(std::to_string(sample.index)), plain(toString(sample.outcome))};
    for (std::size_t j = 0; j < statistics.variables.size(); ++j) {
      const DesignVariable& variable = scene.design_variables[statistics.variables[j]];
      const double value = nominalValue(variable, values) + sample.deviations[j];
      row.push_back(plain(figure(displayUnit(variable.unit).factor * value)));
    }
    table.rows.push_back(row);
  }
  return table;
}

}  // namespace cable_variation
