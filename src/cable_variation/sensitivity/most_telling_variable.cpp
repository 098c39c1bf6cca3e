#include <cable_variation/sensitivity/most_telling_variable.h>

#include <algorithm>
#include <limits>

namespace cable_variation {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

/// To the nearer limit, negative beyond it, in standard deviations; infinite
/// without limits or variation.
double marginOf(const Measure& measure, double value, double sigma) {
  if (!(sigma > 0.0)) return kNone;
  const double below = measure.lower ? value - *measure.lower : kNone;
  const double above = measure.upper ? *measure.upper - value : kNone;
  return std::min(below, above) / sigma;
}

std::size_t largestOf(const Eigen::VectorXd& values) {
  Eigen::Index at = 0;
  values.maxCoeff(&at);
  return static_cast<std::size_t>(at);
}

double largestShift(const EquilibriumRate& rate, const DesignVariable& variable) {
  double largest = 0.0;
  for (const auto& cable : rate.shapes) {
    for (const auto& point : cable) largest = std::max(largest, point.position.norm());
  }
  return largest * std::max(-variable.lower, variable.upper);
}

}  // namespace

std::optional<std::size_t> mostTellingVariable(const Scene& scene, const StabilityAnalysis& analysis) {
  if (analysis.variables.empty()) return std::nullopt;
  double least = kNone;
  Eigen::Index tightest = 0;
  for (std::size_t i = 0; i < analysis.measures.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const double value = analysis.values[i].value + analysis.mean_shift[row];
    const double margin = marginOf(scene.measures[analysis.measures[i]], value, analysis.sigma[row]);
    if (margin >= least) continue;
    least = margin;
    tightest = row;
  }
  if (least < kNone) return largestOf(analysis.contribution.row(tightest));

  Eigen::VectorXd shifts(static_cast<Eigen::Index>(analysis.variables.size()));
  for (std::size_t j = 0; j < analysis.variables.size(); ++j) {
    shifts[static_cast<Eigen::Index>(j)] =
        largestShift(analysis.rates[j], scene.design_variables[analysis.variables[j]]);
  }
  return largestOf(shifts);
}

}  // namespace cable_variation
