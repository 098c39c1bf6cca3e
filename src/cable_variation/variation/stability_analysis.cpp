#include <cable_variation/variation/stability_analysis.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include <cable_variation/math/seconds_since.h>
#include <cable_variation/variation/chosen_indices.h>
#include <cable_variation/variation/tolerances.h>

namespace cable_variation {
namespace {

// One analysis on its way.
class Analysis {
 public:
  Analysis(const Scene& scene, const StabilityOptions& options, EquilibriumSolver solver)
      : scene_(scene), options_(options), solver_(std::move(solver)) {
    result_.variables = allOrChosen(options.variables, scene.design_variables.size(), "design variable");
    result_.measures = allOrChosen(options.measures, scene.measures.size(), "measure");
  }

  StabilityAnalysis run(const MeasureEvaluator& of_scene) {
    const Harness harness = harnessAt(scene_, options_.values, options_.moved);
    const ComponentPoses components = componentPosesAt(scene_, options_.values, options_.moved);
    const Spread spread = spreadOf(scene_, result_.variables);
    result_.nominal = solver_.update(harness);
    if (!result_.nominal.converged()) return std::move(result_);
    const SolvedScene nominal{harness, result_.nominal, components};
    const MeasureEvaluator evaluator = of_scene.with(scene_, nominal);
    differentiate(nominal, evaluator);
    propagate(spread);
    if (options_.low_high) resolve(evaluator);
    return std::move(result_);
  }

 private:
  const Measure& measure(std::size_t row) const { return scene_.measures[result_.measures[row]]; }
  const DesignVariable& variable(std::size_t column) const {
    return scene_.design_variables[result_.variables[column]];
  }

  void differentiate(const SolvedScene& nominal, const MeasureEvaluator& evaluator) {
    result_.values = evaluator.evaluate(nominal, result_.measures);
    const auto start = Clock::now();
    const std::vector<DesignRate> design =
        designRates(scene_, options_.values, options_.moved, result_.variables);
    std::vector<HarnessRate> harness_rates;
    harness_rates.reserve(design.size());
    for (const DesignRate& rate : design) harness_rates.push_back(rate.harness);
    result_.rates = solver_.differentiate(harness_rates);
    result_.jacobian = evaluator.jacobian(nominal, result_.measures, result_.values, design, result_.rates);
    std::vector<double> eigenvalue_rates;
    for (std::size_t row = 0; row < result_.measures.size(); ++row) {
      result_.one_sided.push_back(measure(row).type == Measure::Type::similarity);
      if (!result_.values[row].unique) {
        warn(measure(row).name, ": ",
             result_.values[row].note.empty() ? "another place has the same value" : result_.values[row].note,
             "; its derivatives are those of the place named");
      }
      if (measure(row).type != Measure::Type::eigenvalue) continue;
      if (eigenvalue_rates.empty()) eigenvalue_rates = solver_.eigenvalueRates(harness_rates);
      for (std::size_t column = 0; column < eigenvalue_rates.size(); ++column) {
        result_.jacobian(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
            eigenvalue_rates[column];
      }
    }
    result_.linear_time = secondsSince(start);
  }

  // First order: mean, variance, contributions, worst case, coupling.
  void propagate(const Spread& spread) {
    const auto start = Clock::now();
    const Eigen::MatrixXd& jacobian = result_.jacobian;
    const Eigen::Index rows = jacobian.rows(), columns = jacobian.cols();
    result_.variable_sigma = spread.covariance.diagonal().cwiseSqrt();
    result_.mean_shift.setZero(rows);
    result_.sigma.setZero(rows);
    result_.contribution.setZero(rows, columns);
    result_.worst_low.setZero(rows);
    result_.worst_high.setZero(rows);
    for (Eigen::Index row = 0; row < rows; ++row) {
      const Eigen::VectorXd gradient = jacobian.row(row).transpose();
      const Eigen::VectorXd parts = gradient.cwiseProduct(spread.covariance * gradient);
      const double variance = parts.sum();
      result_.sigma[row] = std::sqrt(std::max(variance, 0.0));
      if (variance > 0.0) result_.contribution.row(row) = parts.transpose() / variance;
      const WorstCase worst = worstCase(scene_, result_.variables, gradient);
      if (result_.one_sided[static_cast<std::size_t>(row)]) {
        // it grows whichever way the variables go
        result_.mean_shift[row] = gradient.dot(spread.mean.cwiseAbs());
        result_.worst_high[row] = std::max(-worst.low, worst.high);
      } else {
        result_.mean_shift[row] = gradient.dot(spread.mean);
        result_.worst_low[row] = worst.low;
        result_.worst_high[row] = worst.high;
      }
    }
    Eigen::MatrixXd effects = jacobian;
    for (Eigen::Index column = 0; column < columns; ++column) {
      effects.col(column) *= toleranceOf(static_cast<std::size_t>(column));
    }
    result_.coupling = couplingOf(effects);
    result_.linear_time += secondsSince(start);
  }

  double toleranceOf(std::size_t column) const {
    return std::max(-variable(column).lower, variable(column).upper);
  }

  // Every variable at its limits, the others nominal.
  void resolve(const MeasureEvaluator& evaluator) {
    const auto start = Clock::now();
    result_.low_high.assign(result_.measures.size(), std::vector<LowHigh>(result_.variables.size()));
    double lowest_together = result_.nominal.smallest_eigenvalue;
    for (std::size_t column = 0; column < result_.variables.size(); ++column) {
      const double low = resolveAt(evaluator, column, false);
      const double high = resolveAt(evaluator, column, true);
      result_.eigenvalue_low.push_back(low);
      result_.eigenvalue_high.push_back(high);
      const double lowest = std::fmin(low, high);
      const double nominal = result_.nominal.smallest_eigenvalue;
      if (lowest < nominal) lowest_together -= nominal - lowest;
      if (lowest < kMuchSofter * nominal) {
        warn("within its tolerance ", variable(column).name, " takes the smallest eigenvalue from ", nominal,
             " to ", lowest, " N/m: the shape is close to losing its stability");
      }
    }
    if (result_.nominal.smallest_eigenvalue > 0.0 && lowest_together <= 0.0) {
      warn("all tolerances together, each with its own loss of the smallest eigenvalue, use up all ",
           result_.nominal.smallest_eigenvalue, " N/m of it: some harness within the tolerances may snap");
    }
    result_.resolve_time = secondsSince(start);
  }

  // Fills a column of low_high; returns the smallest eigenvalue.
  double resolveAt(const MeasureEvaluator& evaluator, std::size_t column, bool high) {
    const DesignVariable& varied = variable(column);
    const auto given = options_.values.find(varied.name);
    const double nominal = given == options_.values.end() ? varied.nominal : given->second;
    const double deviation = high ? varied.upper : varied.lower;
    const char* const limit = high ? " at its upper limit" : " at its lower limit";
    DesignValues values = options_.values;
    values[varied.name] = nominal + deviation;
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    std::vector<MeasureValue> measured(result_.measures.size());
    for (MeasureValue& value : measured) value.value = kNone;
    double eigenvalue = kNone;
    try {
      const Harness harness = harnessAt(scene_, values, options_.moved);
      const ComponentPoses components = componentPosesAt(scene_, values, options_.moved);
      EquilibriumSolver aside = solver_;
      const Equilibrium found = aside.update(harness);
      if (found.converged()) {
        measured = evaluator.evaluate({harness, found, components}, result_.measures, &result_.values);
        eigenvalue = found.smallest_eigenvalue;
        warnOfSnap(found, column, deviation, limit);
      } else {
        warn(varied.name, limit, ": ", found.message);
      }
    } catch (const std::invalid_argument& error) {
      warn(varied.name, limit, ": ", error.what());
    }
    for (std::size_t row = 0; row < measured.size(); ++row) {
      LowHigh& entry = result_.low_high[row][column];
      (high ? entry.high : entry.low) = measured[row].value;
    }
    return eigenvalue;
  }

  // Whether the shape went much further than its derivative says.
  void warnOfSnap(const Equilibrium& found, std::size_t column, double deviation, const char* limit) {
    double expected = 0.0, moved = 0.0, length = 0.0;
    for (std::size_t cable = 0; cable < found.shapes.size(); ++cable) {
      const auto& points = result_.nominal.shapes[cable].points;
      const auto& rates = result_.rates[column].shapes[cable];
      length = std::max(length, points.back().arc_length);
      for (std::size_t i = 0; i < points.size(); ++i) {
        const double there = points[i].arc_length + deviation * rates[i].arc_length;
        expected = std::max(expected, std::abs(deviation) * rates[i].position.norm());
        moved = std::max(moved, (found.shapes[cable].position(there) - points[i].pose.position).norm());
      }
    }
    if (moved > kSnap * expected && moved > kSmallMotion * length) {
      warn(variable(column).name, limit, ": the cables move by ", 1e3 * moved,
           " mm where their derivative says ", 1e3 * expected, " mm: they snap to another equilibrium");
    }
  }

  template <class... Parts>
  void warn(const Parts&... parts) {
    std::ostringstream text;
    text.precision(3);
    (text << ... << parts);
    result_.warnings.push_back(text.str());
  }

  static constexpr double kMuchSofter = 0.5;
  static constexpr double kSnap = 3.0;          // times the expected motion
  static constexpr double kSmallMotion = 0.02;  // of a cable's length

  const Scene& scene_;
  const StabilityOptions& options_;
  EquilibriumSolver solver_;
  StabilityAnalysis result_;
};

}  // namespace

StabilityAnalysis analyseStability(const Scene& scene, const MeasureEvaluator& evaluator,
                                   const StabilityOptions& options, EquilibriumSolver solver) {
  return Analysis(scene, options, std::move(solver)).run(evaluator);
}

}  // namespace cable_variation
