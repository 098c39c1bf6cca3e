#include <cable_variation/simulation/worst_over_motion.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>

#include <cable_variation/equilibrium/require_converged.h>
#include <cable_variation/scene/measure_traits.h>
#include <cable_variation/scene/severity.h>
#include <cable_variation/tracking/motion_phases.h>

namespace cable_variation {
namespace {

// A phase lasts while clips stay within so many radii of the thinnest cable; a clip's turn counts with this
// share of the longest cable's length. As envelopes, a little finer.
constexpr double kStride = 0.25, kLever = 0.25;
// What is missed by less than this share of a measure's spread does not count.
constexpr double kNegligible = 0.01;

// First order about the design at a phase's reference.
struct PhaseModel {
  MotionPhase phase;
  Eigen::VectorXd values;    // per measure
  Eigen::MatrixXd jacobian;  // measures by coordinates of the space
};

class Search {
 public:
  Search(const SampleSpace& space, const std::vector<std::size_t>& measures, const Sampler& sampler)
      : space_(space), indices_(measures) {
    for (const std::size_t index : measures) measures_.push_back(&space.scene().measures[index]);
    trials_.resize(static_cast<Eigen::Index>(sampler.variableCount()),
                   static_cast<Eigen::Index>(sampler.points().count()));
    for (Eigen::Index j = 0; j < trials_.cols(); ++j)
      sampler.sample(static_cast<std::uint64_t>(j), trials_.col(j).data());
  }

  // Whether it was not left.
  bool model(const MeasureEvaluator& evaluator, double from, double to, EquilibriumSolver solver,
             const std::function<bool()>& goes_on) {
    const Harness first = space_.harness(space_.designAt(from));
    const Equilibrium start = solver.update(first);
    double thinnest = std::numeric_limits<double>::infinity(), longest = 0.0;
    for (const CableShape& shape : start.shapes) thinnest = std::min(thinnest, shape.radius);
    for (const Cable& cable : first.cables) longest = std::max(longest, cable.length);
    std::vector<MeasureValue> near;
    PhaseRule rule;
    rule.stride = kStride * thinnest;
    rule.lever = kLever * longest;
    for (MotionPhase& phase : cutIntoPhases(space_, {"world"}, from, to, rule)) {
      if (!goes_on()) return false;
      const SamplePlace place = space_.designAt(phase.reference);
      const Harness harness = space_.harness(place);
      const Equilibrium equilibrium = solver.update(harness);
      std::ostringstream what;
      what << "the design has no equilibrium at " << phase.reference << " s";
      requireConverged(equilibrium, what.str());
      const ComponentPoses components = space_.components(place);
      const SolvedScene solved{harness, equilibrium, components};
      const std::vector<DesignRate> rates = space_.rates(place);
      std::vector<HarnessRate> harness_rates;
      harness_rates.reserve(rates.size());
      for (const DesignRate& rate : rates) harness_rates.push_back(rate.harness);
      const MeasureEvaluator here = evaluator.with(space_.scene(), solved);
      near = here.evaluate(solved, indices_, near.empty() ? nullptr : &near);
      PhaseModel model{std::move(phase), Eigen::VectorXd(static_cast<Eigen::Index>(near.size())),
                       here.jacobian(solved, indices_, near, rates, solver.differentiate(harness_rates))};
      for (std::size_t i = 0; i < near.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        model.values[row] = near[i].value;
        if (!traitsOf(measures_[i]->type).eigenvalue) continue;
        const std::vector<double> of = solver.eigenvalueRates(harness_rates);
        model.jacobian.row(row) = Eigen::Map<const Eigen::RowVectorXd>(of.data(), model.jacobian.cols());
      }
      models_.push_back(std::move(model));
    }
    nominal_ = models_.front().values;
    return true;
  }

  // No times: it was left.
  WorstTimes choose(std::size_t most, const std::function<bool()>& goes_on) {
    WorstTimes result;
    result.phases = models_.size();
    countUnknown(result);
    result.missed.assign(measures_.size(), 0.0);
    if (!findWorst(goes_on)) return {};
    if (!(worst_.array() > kNone).any()) {
      for (std::size_t i = 0; i < std::min(most, models_.size()); ++i)
        result.times.push_back(models_[i * models_.size() / std::min(most, models_.size())].phase.reference);
      return result;
    }
    Eigen::MatrixXd reached = Eigen::MatrixXd::Constant(worst_.rows(), worst_.cols(), kNone);
    for (Where next = mostOften(); result.times.size() < most;) {
      result.times.push_back(next.time);
      reached = reached.cwiseMax(severityAt(next));
      Eigen::Index row = 0, column = 0;
      if (!(inSpreads(missedBy(reached)).maxCoeff(&row, &column) > kNegligible)) break;
      next = worst_at_[static_cast<std::size_t>(row + column * worst_.rows())];
    }
    std::sort(result.times.begin(), result.times.end());
    const Eigen::VectorXd missed = missedBy(reached).rowwise().maxCoeff();
    result.missed.assign(missed.data(), missed.data() + missed.size());
    return result;
  }

 private:
  struct Where {
    std::size_t model = 0;
    double time = 0.0;
  };

  // As good as can be, or not known: no time has a say by it.
  static constexpr double kNone = -std::numeric_limits<double>::infinity();

  void countUnknown(WorstTimes& result) const {
    result.unknown.assign(measures_.size(), 0);
    for (const PhaseModel& model : models_) {
      for (std::size_t i = 0; i < measures_.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        if (!std::isfinite(model.values[row]) || !model.jacobian.row(row).allFinite()) ++result.unknown[i];
      }
    }
  }

  // Infinities of the same sign miss nothing.
  Eigen::MatrixXd missedBy(const Eigen::MatrixXd& reached) const {
    return worst_.binaryExpr(
        reached, [](double worst, double so_far) { return worst > so_far ? worst - so_far : 0.0; });
  }

  // Of a measure that does not vary only an infinity counts.
  Eigen::MatrixXd inSpreads(Eigen::MatrixXd missed) const {
    for (Eigen::Index i = 0; i < missed.rows(); ++i) {
      missed.row(i) =
          missed.row(i).unaryExpr([&](double by) { return std::isinf(by) ? by : by / scale_[i]; });
    }
    return missed;
  }

  // Whether it was not left.
  bool findWorst(const std::function<bool()>& goes_on) {
    const auto rows = static_cast<Eigen::Index>(measures_.size());
    worst_.setConstant(rows, trials_.cols(), kNone);
    worst_at_.resize(static_cast<std::size_t>(worst_.size()));
    for (std::size_t m = 0; m < models_.size(); ++m) {
      for (const double time : models_[m].phase.times) {
        if (!goes_on()) return false;
        const Eigen::MatrixXd at = severityAt({m, time});
        for (Eigen::Index k = 0; k < at.size(); ++k) {
          if (!(at(k) > worst_(k))) continue;
          worst_(k) = at(k);
          worst_at_[static_cast<std::size_t>(k)] = {m, time};
        }
      }
    }
    scale_.resize(rows);
    for (Eigen::Index i = 0; i < rows; ++i) {
      const double spread = spreadOf(worst_.row(i));
      scale_[i] = spread > 0.0 ? spread : std::numeric_limits<double>::infinity();
    }
    return true;
  }

  // Standard deviation of those that are finite.
  static double spreadOf(const Eigen::RowVectorXd& values) {
    double count = 0.0, mean = 0.0, squares = 0.0;
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      const double value = values[i];
      if (!std::isfinite(value)) continue;
      const double step = value - mean;
      mean += step / ++count;
      squares += step * (value - mean);
    }
    return count > 0.0 ? std::sqrt(squares / count) : 0.0;
  }

  // Severity of every trial and measure: rows measures, columns trials.
  Eigen::MatrixXd severityAt(const Where& where) const {
    const PhaseModel& model = models_[where.model];
    const Eigen::VectorXd moved = space_.coordinates(space_.designAt(where.time), model.phase.reference);
    const Eigen::Index variables = trials_.rows();
    Eigen::MatrixXd bad = model.jacobian.leftCols(variables) * trials_;
    bad.colwise() += model.values + model.jacobian * moved;
    for (Eigen::Index i = 0; i < bad.rows(); ++i) {
      const Measure& measure = *measures_[static_cast<std::size_t>(i)];
      // to the design at the same time, and growing whichever way a variable goes
      if (traitsOf(measure.type).from_nominal)
        bad.row(i) = model.jacobian.row(i).head(variables).cwiseAbs() * trials_.cwiseAbs();
      for (Eigen::Index j = 0; j < bad.cols(); ++j) {
        const double known = severity(measure, nominal_[i], bad(i, j));
        bad(i, j) = std::isnan(known) ? kNone : known;
      }
    }
    return bad;
  }

  // The time that is the worst for most; what has no worst time does not vote.
  Where mostOften() const {
    std::map<double, std::size_t> votes;
    for (std::size_t k = 0; k < worst_at_.size(); ++k) {
      if (worst_(static_cast<Eigen::Index>(k)) > kNone) ++votes[worst_at_[k].time];
    }
    const auto chosen = std::max_element(votes.begin(), votes.end(),
                                         [](const auto& a, const auto& b) { return a.second < b.second; });
    std::size_t k = 0;
    while (!(worst_(static_cast<Eigen::Index>(k)) > kNone && worst_at_[k].time == chosen->first)) ++k;
    return worst_at_[k];
  }

  const SampleSpace& space_;
  std::vector<std::size_t> indices_;
  std::vector<const Measure*> measures_;
  Eigen::MatrixXd trials_;  // variables by trials
  std::vector<PhaseModel> models_;
  Eigen::VectorXd nominal_;  // positions are judged against: at the start
  Eigen::MatrixXd worst_;    // severity over the motion: measures by trials
  std::vector<Where> worst_at_;
  Eigen::VectorXd scale_;
};

}  // namespace

WorstTimes findWorstTimes(const SampleSpace& space, const std::vector<std::size_t>& measures,
                          const MeasureEvaluator& evaluator, const Sampler& trials, double from, double to,
                          std::size_t most, EquilibriumSolver solver, const std::function<bool()>& goes_on) {
  Search search(space, measures, trials);
  if (!search.model(evaluator, from, to, std::move(solver), goes_on)) return {};
  return search.choose(most, goes_on);
}

}  // namespace cable_variation
