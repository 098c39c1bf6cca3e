#include <cable_variation/sensitivity/stability_analysis.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

#include <cable_variation/equilibrium/neutral_note.h>
#include <cable_variation/measures/open_parts.h>
#include <cable_variation/scene/measure_traits.h>
#include <cable_variation/sensitivity/curvature_warnings.h>
#include <cable_variation/tolerances/tolerances.h>
#include <cable_variation/util/chosen_indices.h>
#include <cable_variation/util/seconds_since.h>

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
    if (std::string neutral = neutralNote(result_.nominal); !neutral.empty())
      result_.warnings.push_back(std::move(neutral));
    const SolvedScene nominal{harness, result_.nominal, components};
    const MeasureEvaluator evaluator = of_scene.with(scene_, nominal);
    differentiate(nominal, evaluator);
    propagate(spread);
    if (options_.low_high) resolve(harness, evaluator);
    return std::move(result_);
  }

 private:
  const Measure& measure(std::size_t row) const { return scene_.measures[result_.measures[row]]; }
  const DesignVariable& variable(std::size_t column) const {
    return scene_.design_variables[result_.variables[column]];
  }

  void differentiate(const SolvedScene& nominal, const MeasureEvaluator& evaluator) {
    result_.values = evaluator.evaluate(nominal, result_.measures);
    for (std::string& warning :
         openPartWarnings(scene_, evaluator.parts(), componentsMeasured(scene_, result_.measures))) {
      result_.warnings.push_back(std::move(warning));
    }
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
      const MeasureTraits& traits = traitsOf(measure(row).type);
      result_.one_sided.push_back(traits.from_nominal);
      if (result_.values[row].undecided) warn(measure(row).name, ": ", result_.values[row].note);
      if (!result_.values[row].unique) {
        warn(measure(row).name, ": ",
             result_.values[row].note.empty() ? "another place has the same value" : result_.values[row].note,
             "; its derivatives are those of the place named");
      }
      if (!traits.eigenvalue) continue;
      if (!result_.nominal.contacts.empty()) {
        result_.jacobian.row(static_cast<Eigen::Index>(row))
            .setConstant(std::numeric_limits<double>::quiet_NaN());
        continue;
      }
      if (eigenvalue_rates.empty()) eigenvalue_rates = solver_.eigenvalueRates(harness_rates);
      for (std::size_t column = 0; column < eigenvalue_rates.size(); ++column) {
        result_.jacobian(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
            eigenvalue_rates[column];
      }
    }
    for (std::size_t row = 0; row < result_.measures.size(); ++row) {
      const auto r = static_cast<Eigen::Index>(row);
      result_.undefined.push_back(whyUndefined(row, result_.jacobian.row(r)));
      if (result_.undefined.back().empty()) continue;
      result_.jacobian.row(r).setConstant(std::numeric_limits<double>::quiet_NaN());
      warn(measure(row).name, ": derivatives and spread are not defined: ", result_.undefined.back());
    }
    if (touchesAlongStretch()) differentiateBySteps(evaluator);
    warnOfTouches();
    result_.linear_time = secondsSince(start);
  }

  // Where a cable lies along a part, what touches begins and ends elsewhere at once, which derivatives with
  // the places held do not know of.
  bool touchesAlongStretch() const {
    return std::any_of(result_.nominal.contacts.begin(), result_.nominal.contacts.end(),
                       [](const ContactInterval& at) { return at.places.size() > 1; });
  }

  // Replaces the derivatives that are defined by differences of solved shapes a step to either side.
  void differentiateBySteps(const MeasureEvaluator& evaluator) {
    for (std::size_t column = 0; column < result_.variables.size(); ++column) {
      const double step = kStepOfTolerance * toleranceOf(column);
      const std::vector<MeasureValue> below = valuesAt(evaluator, column, -step);
      const std::vector<MeasureValue> above = valuesAt(evaluator, column, step);
      for (std::size_t row = 0; row < result_.measures.size(); ++row) {
        if (!result_.undefined[row].empty() || result_.one_sided[row]) continue;
        double& slope = result_.jacobian(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column));
        slope = (above[row].value - below[row].value) / (2.0 * step);
        if (!std::isfinite(slope)) {
          result_.undefined[row] =
              "a tenth of the tolerance of " + variable(column).name + " off it has no value";
          warn(measure(row).name, ": derivatives and spread are not defined: ", result_.undefined[row]);
        }
      }
    }
    for (std::size_t row = 0; row < result_.measures.size(); ++row) {
      if (result_.undefined[row].empty()) continue;
      result_.jacobian.row(static_cast<Eigen::Index>(row))
          .setConstant(std::numeric_limits<double>::quiet_NaN());
    }
    warn(
        "a cable touches along a stretch: derivatives are differences of shapes that are solved a tenth of "
        "the "
        "tolerances to either side");
  }

  // With a variable off its value in the design; not a number where that has no equilibrium.
  std::vector<MeasureValue> valuesAt(const MeasureEvaluator& evaluator, std::size_t column,
                                     double off) const {
    std::vector<MeasureValue> values(result_.measures.size());
    for (MeasureValue& value : values) value.value = std::numeric_limits<double>::quiet_NaN();
    DesignValues design = options_.values;
    const auto known = design.find(variable(column).name);
    design[variable(column).name] = (known == design.end() ? variable(column).nominal : known->second) + off;
    EquilibriumSolver aside = solver_;
    const Harness harness = harnessAt(scene_, design, options_.moved);
    const Equilibrium found = aside.update(harness);
    if (!found.converged()) return values;
    return evaluator.evaluate({harness, found, componentPosesAt(scene_, design, options_.moved)},
                              result_.measures, &result_.values);
  }

  // Derivatives hold as long as cables touch what they touch.
  void warnOfTouches() {
    if (result_.nominal.contacts.empty() && std::abs(result_.nominal.smallest_gap) < kNearlyTouching) {
      warn("a cable all but touches a part, with ", 1e3 * result_.nominal.smallest_gap,
           " mm between them: derivatives are those of one that does not");
    }
    std::map<Touch, double> forces;
    for (const ContactInterval& interval : result_.nominal.contacts)
      forces[{interval.cable, interval.contact}] += interval.total;
    for (const auto& [touch, force] : forces) {
      for (std::size_t column = 0; column < result_.variables.size(); ++column) {
        double rate = 0.0;
        for (const ContactForceRate& at : result_.rates[column].contacts) {
          if (at.cable == touch.first && at.contact == touch.second) rate += at.force;
        }
        if (force + std::min(rate * variable(column).lower, rate * variable(column).upper) >= 0.0) continue;
        warn("within its tolerance ", variable(column).name, " takes all of the ", force,
             " N by which part '", scene_.harness.contacts[touch.second].part, "' presses cable '",
             scene_.harness.cables[touch.first].name, "', to first order: derivatives hold while they touch");
      }
    }
  }

  // A cable and a contact, by their indices.
  using Touch = std::pair<std::size_t, std::size_t>;

  std::string whyUndefined(std::size_t row, const Eigen::RowVectorXd& gradient) const {
    const MeasureValue& value = result_.values[row];
    const std::string note = value.note.empty() ? "" : " (" + value.note + ")";
    if (std::isnan(value.value)) return "the nominal design has no value" + note;
    if (std::isinf(value.value)) return "the value is infinite at the nominal design" + note;
    if (measure(row).type == Measure::Type::contact_length)
      return "where a cable begins and ceases to touch is known in steps; low and high tell how it changes";
    if (traitsOf(measure(row).type).eigenvalue && !result_.nominal.contacts.empty())
      return "not yet known where a cable touches a part; low and high tell how it changes";
    for (Eigen::Index column = 0; column < gradient.size(); ++column) {
      if (std::isfinite(gradient[column])) continue;
      return "it has no finite derivative by " + variable(static_cast<std::size_t>(column)).name +
             " at the nominal design" + note;
    }
    return "";
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
      if (!result_.undefined[static_cast<std::size_t>(row)].empty()) {
        constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
        result_.mean_shift[row] = result_.sigma[row] = kNone;
        result_.worst_low[row] = result_.worst_high[row] = kNone;
        result_.contribution.row(row).setConstant(kNone);
        continue;
      }
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
    Eigen::MatrixXd effects = jacobian.unaryExpr([](double x) { return std::isnan(x) ? 0.0 : x; });
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
  void resolve(const Harness& harness, const MeasureEvaluator& evaluator) {
    const auto start = Clock::now();
    const LimitFinder finder(scene_, options_.values, options_.moved, harness, result_.nominal, solver_);
    result_.low_high.assign(result_.measures.size(), std::vector<LowHigh>(result_.variables.size()));
    double lowest_together = result_.nominal.smallest_eigenvalue;
    for (std::size_t column = 0; column < result_.variables.size(); ++column) {
      const Softness low = resolveAt(finder, evaluator, column, false);
      const Softness high = resolveAt(finder, evaluator, column, true);
      result_.eigenvalue_low.push_back(low.eigenvalue);
      result_.eigenvalue_high.push_back(high.eigenvalue);
      const double lowest = std::fmin(low.comparable, high.comparable);
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
    for (std::string& warning : curvatureWarnings(scene_, result_))
      result_.warnings.push_back(std::move(warning));
    result_.resolve_time = secondsSince(start);
  }

  // The smallest eigenvalue at a limit [N/m].
  struct Softness {
    double eigenvalue = std::numeric_limits<double>::quiet_NaN();
    // Not a number where a motion that costs nothing in the design costs something, or the other way round:
    // then it is no other figure of the same motions.
    double comparable = std::numeric_limits<double>::quiet_NaN();
  };

  // Fills a column of low_high.
  Softness resolveAt(const LimitFinder& finder, const MeasureEvaluator& evaluator, std::size_t column,
                     bool high) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    std::vector<MeasureValue> measured(result_.measures.size());
    for (MeasureValue& value : measured) value.value = kNone;
    Softness softness;
    const AtLimit found = finder.find(result_.variables[column], high);
    if (found.equilibrium.converged()) {
      measured = evaluator.evaluate({found.harness, found.equilibrium, found.components}, result_.measures,
                                    &result_.values);
      softness.eigenvalue = found.equilibrium.smallest_eigenvalue;
      if (neutralNote(found.equilibrium).empty() == neutralNote(result_.nominal).empty())
        softness.comparable = softness.eigenvalue;
      warnOfOtherTouches(found.equilibrium, column, high);
    }
    if (found.snap) result_.snaps.push_back(*found.snap);
    if (!found.message.empty()) {
      warn(variable(column).name, high ? " at its upper limit: " : " at its lower limit: ", found.message);
    }
    for (std::size_t row = 0; row < measured.size(); ++row) {
      LowHigh& entry = result_.low_high[row][column];
      (high ? entry.high : entry.low) = measured[row].value;
    }
    return softness;
  }

  // A touch that begins or ends on the way to a limit.
  void warnOfOtherTouches(const Equilibrium& there, std::size_t column, bool high) {
    std::map<Touch, std::pair<bool, bool>> touches;  // here, there
    for (const ContactInterval& interval : result_.nominal.contacts)
      touches[{interval.cable, interval.contact}].first = true;
    for (const ContactInterval& interval : there.contacts)
      touches[{interval.cable, interval.contact}].second = true;
    for (const auto& [touch, at] : touches) {
      if (at.first == at.second) continue;
      warn(variable(column).name, high ? " at its upper limit" : " at its lower limit",
           at.first ? " has taken " : " has brought ",
           "cable '" + scene_.harness.cables[touch.first].name + "' ", at.first ? "off" : "to touch",
           " part '" + scene_.harness.contacts[touch.second].part + "': derivatives do not know of it");
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
  static constexpr double kNearlyTouching = 1e-5;  // [m]
  static constexpr double kStepOfTolerance = 0.1;

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
