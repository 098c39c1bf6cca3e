#include <cable_variation/report/stability_section.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <cable_variation/report/chart.h>
#include <cable_variation/report/markup.h>
#include <cable_variation/report/stability_tables.h>
#include <cable_variation/util/display_unit.h>

namespace cable_variation {

namespace {

constexpr std::size_t kMostBars = 8;

/// Indices of the variables by falling share in a measure's variance.
std::vector<std::size_t> byShare(const StabilityAnalysis& analysis, std::size_t measure) {
  std::vector<std::size_t> order(analysis.variables.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto share = [&](std::size_t j) {
    return analysis.contribution(static_cast<Eigen::Index>(measure), static_cast<Eigen::Index>(j));
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return share(a) > share(b); });
  return order;
}

void addContributions(const Scene& scene, const StabilityAnalysis& analysis, ReportSection& section) {
  section.heading("What drives the variation");
  section.paragraph("Share of each variable in the variance of a measure, to first order.");
  for (std::size_t i = 0; i < analysis.measures.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const Measure& measure = scene.measures[analysis.measures[i]];
    if (!analysis.whyUndefined(i).empty()) {
      section.paragraph(measure.name + ": not defined: " + analysis.whyUndefined(i) + ".");
      continue;
    }
    if (!(analysis.sigma[row] > 0.0)) {
      section.paragraph(measure.name + " does not vary to first order.");
      continue;
    }
    std::vector<Bar> bars;
    double shown = 0.0;
    const std::vector<std::size_t> order = byShare(analysis, i);
    for (std::size_t k = 0; k < std::min(kMostBars, order.size()); ++k) {
      const double share = analysis.contribution(row, static_cast<Eigen::Index>(order[k]));
      // Correlated variables may share variance with either sign; a bar has a length only.
      bars.push_back(
          {scene.design_variables[analysis.variables[order[k]]].name, std::max(share, 0.0), percent(share)});
      shown += share;
    }
    if (order.size() > kMostBars) {
      const double rest = analysis.contribution.row(row).sum() - shown;
      bars.push_back(
          {std::to_string(order.size() - kMostBars) + " others", std::max(rest, 0.0), percent(rest)});
    }
    const DisplayUnit unit = displayUnit(measure.unit);
    section.chart(barChart(bars),
                  measure.name + ", σ = " + figure(unit.factor * analysis.sigma[row]) + " " + unit.symbol);
  }
}

void addLowHigh(const Scene& scene, const StabilityAnalysis& analysis, ReportSection& section) {
  section.heading("High, low, median");
  section.paragraph(
      "Each variable at its lower and at its upper limit, the others nominal, solved again. Lines that bend "
      "show what derivatives do not; dashed red: specification limits. Of each measure the variables that "
      "move it most; a line that ends at nominal has no equilibrium beyond. Followed step by step: where a "
      "snap lies on the way, it is told above, and the end of the line is of another equilibrium.");
  for (std::size_t i = 0; i < analysis.measures.size(); ++i) {
    const Measure& measure = scene.measures[analysis.measures[i]];
    const DisplayUnit unit = displayUnit(measure.unit);
    const double nominal = analysis.values[i].value;
    if (!std::isfinite(nominal)) {
      section.paragraph(measure.name + ": no lines, for " + analysis.whyUndefined(i) + ".");
      continue;
    }
    std::vector<std::size_t> order(analysis.variables.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto reach = [&](std::size_t j) {
      const LowHigh& entry = analysis.low_high[i][j];
      if (!std::isfinite(entry.low) || !std::isfinite(entry.high)) return HUGE_VAL;
      return std::max(std::abs(entry.low - nominal), std::abs(entry.high - nominal));
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return reach(a) > reach(b); });
    order.resize(std::min(kMostBars, order.size()));
    std::vector<LowHighLine> lines;
    for (const std::size_t j : order) {
      const LowHigh& entry = analysis.low_high[i][j];
      lines.push_back({scene.design_variables[analysis.variables[j]].name, unit.factor * entry.low,
                       unit.factor * entry.high});
    }
    const auto shown = [&](const std::optional<double>& limit) {
      return limit ? std::optional<double>(unit.factor * *limit) : std::nullopt;
    };
    section.chart(lowHighChart(unit.factor * nominal, lines, shown(measure.lower), shown(measure.upper)),
                  measure.name + (unit.symbol.empty() ? "" : " [" + unit.symbol + "]"));
  }
}

}  // namespace

std::string couplingText(Coupling coupling) {
  switch (coupling) {
    case Coupling::uncoupled:
      return "The design is uncoupled: no variable moves more than one measure.";
    case Coupling::decoupled:
      return "The design is decoupled: tuned in the right order, no measure undoes another.";
    case Coupling::coupled:
      break;
  }
  return "The design is coupled: tuning one measure changes others.";
}

ReportSection stabilitySection(const Scene& scene, const StabilityAnalysis& analysis,
                               const DesignValues& values) {
  ReportSection section("Stability analysis");
  if (!analysis.nominal.converged()) {
    section.warning("The design has no equilibrium (" + std::string(toString(analysis.nominal.status)) +
                    "): " + analysis.nominal.message);
    return section;
  }
  for (const std::string& warning : analysis.warnings) section.warning(warning);
  const double eigenvalue = analysis.nominal.smallest_eigenvalue;
  section.paragraph(
      (std::isnan(eigenvalue)
           ? "The smallest eigenvalue is not known where cables touch parts. "
           : "Smallest eigenvalue " + figure(eigenvalue) +
                 " N/m: how stiffly the shape resists its softest motion; at 0 it snaps over. ") +
      "Centrelines are within about " + figure(1e3 * analysis.nominal.discretisation_error, 2) +
      " mm of the exact ones. " + (analysis.measures.empty() ? "" : couplingText(analysis.coupling)));

  if (!analysis.measures.empty()) {
    section.heading("Measures");
    section.table(measureTable(scene, analysis));
    section.table(spreadTable(scene, analysis));
  }
  if (!analysis.variables.empty() && !analysis.measures.empty()) {
    section.heading("Sensitivities");
    section.table(sensitivityTable(scene, analysis));
    if (std::find(analysis.one_sided.begin(), analysis.one_sided.end(), true) != analysis.one_sided.end()) {
      section.paragraph(
          "* The measure has its least value at the nominal design, with a kink: derivatives are "
          "limits from one side, the same for both.");
    }
    addContributions(scene, analysis, section);
    if (!analysis.low_high.empty()) addLowHigh(scene, analysis, section);
  }
  if (!analysis.variables.empty()) {
    section.heading("Design variables");
    section.table(variableTable(scene, analysis, values));
  }
  return section;
}

}  // namespace cable_variation
