#include <cable_variation/report/verdict_table.h>

#include <algorithm>
#include <cmath>

#include <cable_variation/report/markup.h>
#include <cable_variation/util/display_unit.h>

namespace cable_variation {

namespace {

bool any(const std::vector<MeasureVerdict>& verdicts, double MeasureVerdict::*figure) {
  return std::any_of(verdicts.begin(), verdicts.end(),
                     [&](const MeasureVerdict& each) { return !std::isnan(each.*figure); });
}

bool judgedBy(const std::vector<MeasureVerdict>& verdicts, const std::string& basis) {
  return std::any_of(verdicts.begin(), verdicts.end(),
                     [&](const MeasureVerdict& each) { return each.basis == basis; });
}

std::string limitText(const Measure& measure, double factor) {
  const auto shown = [&](double limit) { return figure(factor * limit); };
  if (measure.lower && measure.upper) return shown(*measure.lower) + " … " + shown(*measure.upper);
  return measure.lower ? "≥ " + shown(*measure.lower) : measure.upper ? "≤ " + shown(*measure.upper) : "";
}

std::string worstText(const MeasureVerdict& verdict, double factor) {
  if (std::isnan(verdict.worst_low)) return "–";
  const std::string low = figure(factor * verdict.worst_low);
  return std::isnan(verdict.worst_high) ? "≥ " + low : low + " … " + figure(factor * verdict.worst_high);
}

}  // namespace

Tone toneOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return Tone::good;
    case Verdict::fail:
      return Tone::bad;
    case Verdict::marginal:
    case Verdict::unknown:
      return Tone::doubtful;
    case Verdict::no_limits:
      break;
  }
  return Tone::plain;
}

ReportCell verdictCell(Verdict verdict) {
  ReportCell cell{verdict == Verdict::no_limits ? "" : toString(verdict), 0.0, false, toneOf(verdict)};
  if (verdict == Verdict::pass) cell.text = "✓ " + cell.text;
  if (verdict == Verdict::fail) cell.text = "✗ " + cell.text;
  return cell;
}

ReportTable verdictTable(const Scene& scene, const std::vector<MeasureVerdict>& verdicts,
                         const std::string& value) {
  const bool cpk = any(verdicts, &MeasureVerdict::cpk), worst = any(verdicts, &MeasureVerdict::worst_low);
  const bool outside = any(verdicts, &MeasureVerdict::outside), sigma = any(verdicts, &MeasureVerdict::sigma);
  ReportTable table{"", {"measure", "verdict", "unit", value, "limits"}, {}};
  if (cpk) table.columns.emplace_back("Cpk");
  if (worst) table.columns.emplace_back("worst case");
  if (sigma) table.columns.emplace_back("σ");
  if (outside) table.columns.emplace_back("outside");
  for (const MeasureVerdict& each : verdicts) {
    const Measure& measure = scene.measures[each.measure];
    const DisplayUnit unit = displayUnit(measure.unit);
    std::vector<ReportCell> row{plain(measure.name),
                                verdictCell(each.verdict),
                                plain(unit.symbol),
                                {figure(unit.factor * withoutRounding(each.value, measure.unit)), 0.0,
                                 beyondLimits(measure, each.value)},
                                plain(limitText(measure, unit.factor))};
    if (cpk) row.push_back({std::isnan(each.cpk) ? "" : figure(each.cpk, 3), 0.0, each.cpk < 1.0});
    if (worst) {
      row.push_back({worstText(each, unit.factor), 0.0,
                     beyondLimits(measure, each.worst_low) || beyondLimits(measure, each.worst_high)});
    }
    if (sigma) row.push_back(plain(figure(unit.factor * each.sigma, 3)));
    if (outside) row.push_back(plain(std::isnan(each.outside) ? "" : rejectText(each.outside)));
    table.rows.push_back(row);
  }
  return table;
}

std::string verdictRule(const std::vector<MeasureVerdict>& verdicts) {
  std::string text;
  if (judgedBy(verdicts, "simulation") || judgedBy(verdicts, "first order")) {
    text += "A measure passes with a Cpk of " + figure(kCapable) +
            " or more, is marginal from 1 on, and fails below";
    text += judgedBy(verdicts, "simulation")
                ? ", or with more than 0.27 % of the samples outside or without a value. "
                : "; Cpk is of the first-order spread. ";
  }
  if (any(verdicts, &MeasureVerdict::worst_high)) {
    text += "Worst case: the smallest and the largest value within the tolerances, to first order. ";
  } else if (any(verdicts, &MeasureVerdict::worst_low)) {
    text +=
        "Worst case: what the envelope keeps at least; a measure fails where a harness solved breaks its "
        "limit, "
        "and is marginal where only the envelope does. ";
  }
  return text + "What is outside its limits at the design fails in any case; beyond a limit in bold red.";
}

}  // namespace cable_variation
