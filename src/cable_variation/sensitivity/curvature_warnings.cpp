#include <cable_variation/sensitivity/curvature_warnings.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <cable_variation/util/display_unit.h>

namespace cable_variation {

namespace {

constexpr double kCurved = 0.25;
constexpr double kNoteworthy = 1e-5;  // SI, of a limit off its line: less may be the solver's accuracy

// What a variable does to a measure: by how much a solved limit is off the line, at most, and changes the
// measure.
struct Curve {
  double off_line = 0.0, change = 0.0;
};

Curve curveOf(const LowHigh& solved, double value, double slope, const DesignVariable& variable) {
  Curve curve;
  for (const auto& [found, deviation] :
       {std::pair{solved.low, variable.lower}, std::pair{solved.high, variable.upper}}) {
    if (!std::isfinite(found)) continue;
    curve.change = std::max(curve.change, std::abs(found - value));
    curve.off_line = std::max(curve.off_line, std::abs(found - value - slope * deviation));
  }
  return curve;
}

}  // namespace

std::vector<std::string> curvatureWarnings(const Scene& scene, const StabilityAnalysis& analysis) {
  std::vector<std::string> warnings;
  for (std::size_t row = 0; row < analysis.low_high.size(); ++row) {
    if (!analysis.whyUndefined(row).empty() || analysis.one_sided[row]) continue;
    const auto r = static_cast<Eigen::Index>(row);
    const Measure& measure = scene.measures[analysis.measures[row]];
    const double value = analysis.values[row].value;
    double together = std::max(-analysis.worst_low[r], analysis.worst_high[r]), most = kNoteworthy;
    std::size_t by = analysis.variables.size();
    for (std::size_t column = 0; column < analysis.variables.size(); ++column) {
      const Curve curve = curveOf(analysis.low_high[row][column], value,
                                  analysis.jacobian(r, static_cast<Eigen::Index>(column)),
                                  scene.design_variables[analysis.variables[column]]);
      together = std::max(together, curve.change);
      if (curve.off_line <= most) continue;
      most = curve.off_line;
      by = column;
    }
    if (by == analysis.variables.size() || most < kCurved * together) continue;
    const DesignVariable& variable = scene.design_variables[analysis.variables[by]];
    const double slope = analysis.jacobian(r, static_cast<Eigen::Index>(by));
    const LowHigh& solved = analysis.low_high[row][by];
    const auto shown = [&](double x) { return displayValue(x, measure.unit); };
    warnings.push_back(
        measure.name + ": not straight over the tolerance of " + variable.name + ": " + shown(solved.low) +
        " at its lower limit, " + shown(value) + " in the design, " + shown(solved.high) +
        " at its upper limit, where the derivative has " + shown(value + slope * variable.lower) + " and " +
        shown(value + slope * variable.upper) + "; spread and worst case are rough, a simulation tells them");
  }
  return warnings;
}

}  // namespace cable_variation
