#include <cable_variation/report/simulation_section.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <cable_variation/report/chart.h>
#include <cable_variation/report/histogram_chart.h>
#include <cable_variation/report/markup.h>
#include <cable_variation/report/simulation_tables.h>
#include <cable_variation/util/count_text.h>
#include <cable_variation/util/display_unit.h>

namespace cable_variation {

namespace {

constexpr std::size_t kMostBars = 8, kMostListed = 20;

void addOutcome(const Scene& scene, const SimulationStatistics& statistics, const DesignValues& values,
                ReportSection& section) {
  section.paragraph(countText(statistics.samples, "sample") + " of " +
                    countText(statistics.variables.size(), "design variable") + ", sampler " +
                    toString(statistics.sampler) + ", seed " + std::to_string(statistics.seed) +
                    ": the same seed gives the same figures.");
  if (statistics.samples < statistics.wanted) {
    section.warning("Ended after " + std::to_string(statistics.samples) + " of " +
                    countText(statistics.wanted, "sample") + ".");
  }
  const std::uint64_t solved = statistics.count(SampleOutcome::solved);
  if (solved == statistics.samples) return;
  std::string counts;
  const auto tell = [&](SampleOutcome outcome, const char* what) {
    const std::uint64_t count = statistics.count(outcome);
    if (count > 0) counts += (counts.empty() ? "" : ", ") + std::to_string(count) + " " + what;
  };
  tell(SampleOutcome::snapped, "snapped over to another equilibrium (their values count)");
  tell(SampleOutcome::not_converged, "came to none");
  tell(SampleOutcome::impossible, "cannot be (a length below zero, clips out of reach)");
  section.warning("Of " + countText(statistics.samples, "sample") + " " + counts + ".");
  section.table(listedTable(scene, statistics, values, kMostListed));
  const std::uint64_t others = statistics.samples - solved;
  if (others > kMostListed) {
    section.paragraph(std::to_string(others - kMostListed) + " more are not listed here.");
  }
}

std::string histogramOf(const Measure& measure, const MeasureStatistics& s, double nominal) {
  const double factor = displayUnit(measure.unit).factor;
  Histogram histogram = s.histogram;
  histogram.low *= factor;
  histogram.width *= factor;
  const auto shown = [&](const std::optional<double>& limit) {
    return limit ? std::optional<double>(factor * *limit) : std::nullopt;
  };
  return histogramChart(histogram, {factor * nominal, factor * s.mean, factor * s.sigma, shown(measure.lower),
                                    shown(measure.upper)});
}

// The largest shares of a measure's variance.
std::string contributionBars(const Scene& scene, const SimulationStatistics& statistics,
                             const Eigen::MatrixXd& share, std::size_t measure) {
  const auto value = [&](std::size_t j) {
    return share(static_cast<Eigen::Index>(measure), static_cast<Eigen::Index>(j));
  };
  std::vector<std::size_t> order(statistics.variables.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return value(a) > value(b); });
  order.resize(std::min(order.size(), kMostBars));
  std::vector<Bar> bars;
  bars.reserve(order.size());
  for (const std::size_t j : order) {
    bars.push_back({scene.design_variables[statistics.variables[j]].name, std::max(value(j), 0.0),
                    percent(std::round(1e3 * value(j)) / 1e3)});
  }
  return barChart(bars);
}

void addCharts(const Scene& scene, const SimulationStatistics& statistics, ReportSection& section) {
  section.heading("Histograms and what drives them");
  section.paragraph(
      "Solid line: mean; dotted: nominal; curve: the normal distribution of the same mean and σ; dashed red: "
      "specification limits, red: beyond them. Bars: share of the variance that would go with the variable's "
      "tolerance (first-order Sobol' index).");
  const Eigen::MatrixXd& share = statistics.contributions.first_order;
  for (std::size_t i = 0; i < statistics.measures.size(); ++i) {
    const Measure& measure = scene.measures[statistics.measures[i]];
    const MeasureStatistics& s = statistics.statistics[i];
    const std::string unit = displayUnit(measure.unit).symbol;
    section.chart(histogramOf(measure, s, statistics.nominal[i]),
                  measure.name + (unit.empty() ? "" : " [" + unit + "]"));
    const auto row = static_cast<Eigen::Index>(i);
    if (row < share.rows() && !std::isnan(share(row, 0))) {
      section.chart(contributionBars(scene, statistics, share, i), measure.name + ", shares of the variance");
    }
  }
}

// Shares that the linear analysis has for the simulated variables and measures; not a number: it has none.
Eigen::MatrixXd linearShare(const SimulationStatistics& statistics, const StabilityAnalysis& analysis) {
  Eigen::MatrixXd share = Eigen::MatrixXd::Constant(static_cast<Eigen::Index>(statistics.measures.size()),
                                                    static_cast<Eigen::Index>(statistics.variables.size()),
                                                    std::numeric_limits<double>::quiet_NaN());
  const auto placeOf = [](const std::vector<std::size_t>& all, std::size_t one) {
    return static_cast<Eigen::Index>(std::find(all.begin(), all.end(), one) - all.begin());
  };
  for (Eigen::Index i = 0; i < share.rows(); ++i) {
    const Eigen::Index row = placeOf(analysis.measures, statistics.measures[static_cast<std::size_t>(i)]);
    for (Eigen::Index j = 0; j < share.cols(); ++j) {
      const Eigen::Index column =
          placeOf(analysis.variables, statistics.variables[static_cast<std::size_t>(j)]);
      if (row < analysis.contribution.rows() && column < analysis.contribution.cols()) {
        share(i, j) = analysis.contribution(row, column);
      }
    }
  }
  return share;
}

void addContributions(const Scene& scene, const SimulationStatistics& statistics,
                      const StabilityAnalysis* linear, ReportSection& section) {
  const VarianceContributions& found = statistics.contributions;
  section.heading("Shares of the variance");
  if (found.first_order.size() > 0) {
    section.table(
        shareTable(scene, statistics,
                   "First-order Sobol' index, by " + std::to_string(found.bins) +
                       " bins of each variable: independent variables alone add up to less than 100 %, "
                       "the rest is by several together",
                   found.first_order));
  }
  if (found.regression_share.size() > 0) {
    ReportTable table =
        shareTable(scene, statistics, "Linear regression on all variables, and what it explains in all (R²)",
                   found.regression_share);
    std::vector<ReportCell> row{{"R²", 0.0, false}};
    for (Eigen::Index i = 0; i < found.r_squared.size(); ++i) {
      row.push_back({percent(found.r_squared[i]), 0.0, false});
    }
    table.rows.push_back(row);
    section.table(table);
  }
  if (linear != nullptr) {
    section.table(shareTable(scene, statistics,
                             "By the derivatives at the nominal design (stability analysis)",
                             linearShare(statistics, *linear)));
  }
  if (found.left_out > 0) {
    section.paragraph(countText(found.left_out, "sample is", "samples are") +
                      " left out here: some measure has no finite value.");
  }
}

}  // namespace

ReportSection simulationSection(const Scene& scene, const SimulationStatistics& statistics,
                                const DesignValues& values, const StabilityAnalysis* linear) {
  ReportSection section("Variation simulation");
  addOutcome(scene, statistics, values, section);
  if (statistics.measures.empty() || statistics.samples == 0) return section;
  section.heading("Measures");
  section.table(meanTable(scene, statistics));
  const ReportTable capability = capabilityTable(scene, statistics);
  if (!capability.rows.empty()) section.table(capability);
  section.table(percentileTable(scene, statistics));
  section.table(controlTable(scene, statistics));
  if (statistics.sampler != SamplerType::monte_carlo) {
    section.paragraph("Intervals are those of independent samples; these lie closer to the true figures.");
  }
  addCharts(scene, statistics, section);
  addContributions(scene, statistics, linear, section);
  return section;
}

}  // namespace cable_variation
