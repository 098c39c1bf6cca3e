#include <cable_variation/harness/minimise.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include <cable_variation/harness/smallest_eigenvalue.h>

namespace cable_variation {
namespace {

constexpr double kLargestTurn = 0.7;    // of a step, at any node [rad]
constexpr double kLargestShift = 0.25;  // of a step, over the length of the harness
constexpr double kShiftGrowth = 8.0;
constexpr double kFirstShift = 0.1;
constexpr int kLongestClimb = 8;         // steps in a row without a new lowest energy
constexpr double kSmallestShift = 1e-3;  // below it, none
constexpr double kSmallTurn = 1e-2;      // of a step close to rest [rad]
constexpr double kGentleGrowth = 100.0;
constexpr double kLargestNeutralShift = 2e-5;
constexpr int kFinalSteps = 4;
constexpr double kLargestLmShift = 1e12;
// A full Newton step below this, relative to length and in radians, leaves an error near its square.
constexpr double kFinalStep = 1e-6;

struct StepSize {
  double shift = 0.0;  // [m]
  double turn = 0.0;   // [rad]
};

StepSize sizeOf(const NodalField& motion) {
  StepSize size;
  for (const auto& nodes : motion.spans) {
    size.shift = std::max(size.shift, nodes.topRows<3>().colwise().norm().maxCoeff());
    size.turn = std::max(size.turn, nodes.bottomRows<3>().colwise().norm().maxCoeff());
  }
  return size;
}

// The state of one descent.
class Descent {
 public:
  Descent(RodSystem& system, Configuration& configuration, const MinimiseOptions& options)
      : system_(system), configuration_(configuration), options_(options), metric_(system.bendingMetric()) {}

  Minimum run() {
    if (options_.relaxed) system_.relaxStress();
    system_.evaluate(configuration_, options_.relaxed ? Hessian::predicted : Hessian::exact);
    predicted_ = options_.relaxed;
    metric_ = system_.bendingMetric();
    length_ = largestArcLength(configuration_);
    lowest_ = {configuration_, system_.energy().total()};
    if (options_.settle) {
      settle();
      return result_;
    }
    while (result_.iterations < options_.max_iterations) {
      if (!factorise()) break;
      NodalField force = system_.gradient();
      force.scale(-1.0);
      system_.solve(force, step_);
      const StepSize size = sizeOf(step_);
      if (!std::isfinite(size.shift) || !std::isfinite(size.turn)) break;
      ++result_.iterations;
      const bool final = size.shift < kFinalStep * length_ && size.turn < kFinalStep;
      if (!final) {
        tryStep(size);
      } else if (shift_ > kLargestNeutralShift) {
        if (!smallest_shift_) {  // the step may be small because of the shift
          shift_ = kNeutralShift;
          evaluateExactly();
          smallest_shift_ = true;
        } else if (!leaveSaddle()) {
          settle();
          break;
        }
      } else if (finalStep()) {
        break;
      }
    }
    result_.residual = system_.residual();
    return result_;
  }

 private:
  using Hessian = RodSystem::Hessian;

  void evaluateExactly() {
    system_.evaluate(configuration_, Hessian::exact);
    predicted_ = false;
  }

  // Raises the shift until the shifted Hessian is positive definite.
  bool factorise() {
    while (system_.factorise(shift_, metric_) > 0) {
      // close to rest a negative pivot may be that of a neutral motion, off zero by what is left of the
      // residual
      const bool gently = last_turn_ < kSmallTurn && shift_ < kSmallestShift;
      shift_ = gently ? kGentleGrowth * shift_ : std::max(kFirstShift, shift_ * kShiftGrowth);
      if (shift_ > kLargestLmShift) return false;
      system_.evaluate(configuration_, predicted_ ? Hessian::predicted : Hessian::exact);
    }
    return true;
  }

  double tolerance() const { return residualTolerance(system_); }

  // A full Newton step so small that it ends the iteration, unless the residual or a negative pivot says
  // otherwise.
  bool finalStep() {
    system_.move(step_, configuration_);
    system_.evaluate(configuration_, Hessian::none);
    if (system_.residual() > tolerance() && ++final_steps_ <= kFinalSteps) {
      evaluateExactly();
      return false;
    }
    result_.stationary = result_.stable = system_.residual() <= 1e3 * tolerance();
    if (!result_.stationary || shift_ == kNeutralShift) return true;
    evaluateExactly();
    const bool saddle = system_.factorise(kGentleGrowth * kNeutralShift, metric_) > 0;
    if (saddle && leaveSaddle()) return false;
    system_.evaluate(configuration_, Hessian::none);
    result_.stable = !saddle;
    return true;
  }

  void tryStep(const StepSize& size) {
    smallest_shift_ = false;
    last_turn_ = size.turn;
    const double limit = std::min(
        1.0, std::min(kLargestTurn / (size.turn + 1e-300), kLargestShift * length_ / (size.shift + 1e-300)));
    if (limit < 1.0) step_.scale(limit);
    const double before = system_.energy().total();
    const double slope = system_.gradient().dot(step_);
    system_.predictStress(step_);
    Configuration trial = configuration_;
    const double work = system_.move(step_, trial);
    if (!system_.arcLengthsInOrder(trial)) {
      raiseShift();
      return;
    }
    system_.evaluate(trial, Hessian::predicted);
    predicted_ = true;
    const double change = system_.energy().total() - before - work;
    if (!std::isfinite(change)) {
      raiseShift();
      return;
    }
    configuration_ = std::move(trial);
    climbed_ += change;
    const double noise = 1e-13 * (std::abs(before) + system_.energy().elastic);
    if (climbed_ <= 1e-4 * slope + noise) {
      lowest_ = {configuration_, system_.energy().total()};
      climbed_ = 0.0;
      steps_above_ = 0;
      lowerShift(limit, change / slope);
    } else if (++steps_above_ > kLongestClimb) {
      configuration_ = lowest_.configuration;
      climbed_ = 0.0;
      steps_above_ = 0;
      raiseShift();
    }
  }

  // After a step whose energy changed by `gain` times the slope; a Newton step on a quadratic gains half.
  void lowerShift(double limit, double gain) {
    if (limit < 1.0) {
      shift_ *= 0.5;
    } else if (gain > 0.4 && gain < 0.6) {
      shift_ *= 1e-3;
    } else if (gain > 0.2) {
      shift_ /= kShiftGrowth;
    }
    if (shift_ < kSmallestShift) shift_ = kNeutralShift;
  }

  void raiseShift() {
    shift_ = std::max(kFirstShift, shift_ * kShiftGrowth);
    if (shift_ > kLargestLmShift) result_.iterations = options_.max_iterations;
    evaluateExactly();
  }

  // Plain Newton steps, whatever the Hessian's inertia.
  void settle() {
    constexpr int kSteps = 12;
    shift_ = kNeutralShift;
    bool positive = false;
    for (int k = 0; k < kSteps; ++k) {
      evaluateExactly();
      positive = system_.factorise(shift_, metric_) == 0;
      NodalField force = system_.gradient();
      force.scale(-1.0);
      system_.solve(force, step_);
      const StepSize size = sizeOf(step_);
      if (!(size.turn < kLargestTurn) || !(size.shift < kLargestShift * length_)) return;
      ++result_.iterations;
      system_.move(step_, configuration_);
      if (size.shift < kFinalStep * length_ && size.turn < kFinalStep) break;
    }
    system_.evaluate(configuration_, Hessian::none);
    result_.residual = system_.residual();
    result_.stationary = result_.residual <= 1e3 * tolerance();
    result_.stable = result_.stationary && positive;
  }

  // Off a stationary point with a negative pivot, along the motion of least stiffness, by an angle that is
  // another one at every attempt. Whether the energy has fallen is judged a few steps later.
  bool leaveSaddle() {
    constexpr double kPushes[] = {0.05, -0.05, 0.2, -0.2, 0.5, -0.5, 0.01, -0.01};  // [rad]
    if (saddles_ == std::size(kPushes)) return false;
    NodalField push;
    evaluateExactly();
    smallestEigenvalue(system_, configuration_, &push);
    const StepSize size = sizeOf(push);
    push.scale(kPushes[saddles_++] / std::max(size.turn, 4.0 * size.shift / length_));
    evaluateExactly();
    lowest_ = {configuration_, system_.energy().total()};
    system_.predictStress(push);
    const double work = system_.move(push, configuration_);
    if (!system_.arcLengthsInOrder(configuration_)) return false;
    system_.evaluate(configuration_, Hessian::predicted);
    predicted_ = true;
    climbed_ = system_.energy().total() - lowest_.energy - work;
    steps_above_ = 0;
    smallest_shift_ = false;
    shift_ = kFirstShift;
    return true;
  }

  struct Lowest {
    Configuration configuration;
    double energy = 0.0;
  };

  RodSystem& system_;
  Configuration& configuration_;
  MinimiseOptions options_;
  Lowest lowest_;
  double climbed_ = 0.0;  // energy above the lowest, dead moments' work taken off [J]
  int steps_above_ = 0;
  bool predicted_ = false;
  double last_turn_ = INFINITY;  // of the last step [rad]
  std::vector<RodSystem::Metric> metric_;
  NodalField step_;
  Minimum result_;
  double length_ = 0.0;
  double shift_ = kNeutralShift;
  int final_steps_ = 0;
  std::size_t saddles_ = 0;
  bool smallest_shift_ = false;  // the shift is no larger than the Hessian's inertia asks for
};

}  // namespace

double residualTolerance(const RodSystem& system) {
  double force = 0.0;
  for (const auto& metric : system.bendingMetric()) force = std::max(force, metric.bend);  // EI (π/L)²
  return std::max(20.0 * system.residualNoise(), 1e-10 * force);
}

Minimum minimise(RodSystem& system, Configuration& configuration, const MinimiseOptions& options) {
  return Descent(system, configuration, options).run();
}

}  // namespace cable_variation
