#include <cable_variation/equilibrium/search/minimise.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <cable_variation/equilibrium/search/smallest_eigenvalue.h>

namespace cable_variation {
namespace {

constexpr double kLargestRotation = 0.35;     // of a step, at any node [rad]
constexpr double kLargestDisplacement = 0.1;  // of a step, over the length of the harness
constexpr double kShiftGrowth = 8.0;
constexpr double kFirstShift = 0.1;
constexpr int kLongestClimb = 8;         // steps in a row without a new lowest energy
constexpr double kSmallestShift = 1e-3;  // below it, none
constexpr double kSmallRotation = 1e-2;  // of a step close to rest [rad]
constexpr double kGentleGrowth = 100.0;
constexpr double kLargestNeutralShift = 2e-5;
constexpr int kFinalSteps = 4;
constexpr double kLargestShift = 1e12;
// A full Newton step below this, relative to length and in radians, leaves an error near its square.
constexpr double kFinalStep = 1e-6;
// After a Newton step below this, the same factors serve for the next steps, each this much shorter at least.
constexpr double kNear = 1e-2;
constexpr double kContraction = 0.1;
constexpr double kLeft = 1e-14;  // relative to length and in radians, as a Newton step of kFinalStep leaves
// Of a rough descent, likewise: the energy is off by the square of what is left.
constexpr double kRoughStep = 1e-3;
constexpr double kRoughlyLeft = 1e-5;

struct StepSize {
  double displacement = 0.0;  // [m]
  double rotation = 0.0;      // [rad]
};

StepSize sizeOf(const NodalField& motion) {
  StepSize size;
  for (const auto& nodes : motion.spans) {
    size.displacement = std::max(size.displacement, nodes.topRows<3>().colwise().norm().maxCoeff());
    size.rotation = std::max(size.rotation, nodes.bottomRows<3>().colwise().norm().maxCoeff());
  }
  return size;
}

// The state of one descent.
class Descent {
 public:
  Descent(RodSystem& system, Configuration& configuration, const MinimiseOptions& options)
      : system_(system), configuration_(configuration), options_(options), metric_(system.bendingMetric()) {}

  Minimum run() {
    if (options_.stress == StartStress::none) system_.relaxStress();
    predicted_ = options_.stress != StartStress::own;
    system_.evaluate(configuration_, predicted_ ? Hessian::predicted : Hessian::exact);
    metric_ = system_.bendingMetric();
    neutral_ = shift_ = neutralShift(system_);
    length_ = largestArcLength(configuration_);
    lowest_ = {configuration_, system_.energy().total()};
    if (options_.settle) {
      settle();
      return result_;
    }
    while (result_.iterations < options_.max_iterations) {
      if (!factorise()) break;
      const StepSize size = lengthen(findStep());
      if (!std::isfinite(size.displacement) || !std::isfinite(size.rotation)) break;
      if (isRoughlyFinal(size)) {
        if (endRoughly()) break;
        continue;
      }
      if (!isFinal(size)) {
        if (tryStep(size) && judge()) break;
      } else if (shift_ > std::max(kLargestNeutralShift, 10.0 * neutral_)) {
        if (!smallest_shift_) {  // the step may be small because of the shift
          shift_ = neutral_;
          evaluateExactly();
          smallest_shift_ = true;
        } else if (!leaveSaddle()) {
          settle();
          break;
        }
      } else {
        const bool exact = !predicted_ || !system_.slides();
        system_.move(step_, configuration_);
        if (!exact) {
          evaluateExactly();  // the last step along a slid cable is one by its own section forces
        } else if (judge()) {
          break;
        }
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
    too_small_shift_ = 0.0;
    while (system_.factorise(shift_, metric_) > 0) {
      too_small_shift_ = shift_;
      // close to rest a negative pivot may be that of a neutral motion, off zero by what is left of the
      // residual
      const bool gently = last_rotation_ < kSmallRotation && shift_ < kSmallestShift;
      shift_ = gently ? kGentleGrowth * shift_ : std::max(kFirstShift, shift_ * kShiftGrowth);
      if (shift_ > kLargestShift) return false;
      evaluateAgain();
    }
    return true;
  }

  // Where the Hessian is indefinite, a shift just large enough leads far along its direction of negative
  // curvature, and one of several times that creeps: the former is looked for while steps are short.
  StepSize lengthen(StepSize size) {
    constexpr int kTrials = 3;
    constexpr double kShort = 0.2;  // of the longest step
    const auto isShort = [&] {
      return size.rotation < kShort * kLargestRotation &&
             size.displacement < kShort * kLargestDisplacement * length_;
    };
    for (int trial = 0; too_small_shift_ > kFirstShift && isShort() && trial < kTrials; ++trial) {
      const double between = std::sqrt(too_small_shift_ * shift_);
      evaluateAgain();
      if (system_.factorise(between, metric_) > 0) {
        too_small_shift_ = between;
        continue;
      }
      shift_ = between;
      size = findStep();
    }
    return size;
  }

  void evaluateAgain() { system_.evaluate(configuration_, predicted_ ? Hessian::predicted : Hessian::exact); }

  // The step against the gradient, with the factors at hand.
  StepSize findStep() {
    force_ = system_.gradient();
    force_.scale(-1.0);
    system_.solve(force_, step_);
    ++result_.iterations;
    return sizeOf(step_);
  }

  bool isFinal(const StepSize& size) const {
    return size.displacement < kFinalStep * length_ && size.rotation < kFinalStep;
  }

  // A step that leaves next to nothing for a rough descent, and with factors that are positive.
  bool isRoughlyFinal(const StepSize& size) const {
    return options_.rough && shift_ == neutral_ && size.displacement < kRoughStep * length_ &&
           size.rotation < kRoughStep;
  }

  // Goes the last step. Whether the Hessian there is positive, by the section forces that the step leads to;
  // else the descent is no longer a rough one.
  bool endRoughly() {
    system_.predictStress(step_);
    system_.move(step_, configuration_);
    system_.evaluate(configuration_, Hessian::predicted);
    predicted_ = true;
    options_.rough = result_.stationary = result_.stable =
        system_.factorise(kGentleGrowth * neutral_, metric_) == 0;
    if (!options_.rough) evaluateAgain();
    return options_.rough;
  }

  double tolerance() const { return residualTolerance(system_); }

  // After a step so small that it ends the iteration, unless the residual or the Hessian here says otherwise.
  bool judge() {
    if (options_.rough) return true;  // it was
    evaluateExactly();
    const double residual = system_.residual();
    if (residual > tolerance() && ++final_steps_ <= kFinalSteps) return false;
    result_.stationary = residual <= 1e3 * tolerance();
    const bool saddle = system_.factorise(kGentleGrowth * neutral_, metric_) > 0;
    if (saddle && leaveSaddle()) return false;
    result_.stable = result_.stationary && !saddle;
    return true;
  }

  // Goes one step. Whether it has come to rest, by steps with the same factors close to it.
  bool tryStep(const StepSize& size) {
    smallest_shift_ = false;
    last_rotation_ = size.rotation;
    const double limit =
        std::min(1.0, std::min(kLargestRotation / (size.rotation + 1e-300),
                               kLargestDisplacement * length_ / (size.displacement + 1e-300)));
    if (limit < 1.0) step_.scale(limit);
    const double before = system_.energy().total();
    const double slope = system_.gradient().dot(step_);
    system_.predictStress(step_);
    trial_ = configuration_;
    const double work = system_.move(step_, trial_);
    if (!system_.arcLengthsInOrder(trial_)) {
      raiseShift();
      return false;
    }
    const bool near = shift_ == neutral_ && size.rotation < kNear && size.displacement < kNear * length_ &&
                      system_.keepsFactors();
    system_.evaluate(trial_, near ? Hessian::none : Hessian::predicted);
    predicted_ = true;
    const double change = system_.energy().total() - before - work;
    if (!std::isfinite(change)) {
      raiseShift();
      return false;
    }
    std::swap(configuration_, trial_);
    climbed_ += change;
    const double noise = 1e-13 * (std::abs(before) + system_.energy().elastic);
    if (climbed_ <= 1e-4 * slope + noise) {
      lowest_.configuration = configuration_;
      lowest_.energy = system_.energy().total();
      climbed_ = 0.0;
      steps_above_ = 0;
      lowerShift(limit, change / slope);
    } else if (++steps_above_ > kLongestClimb) {
      configuration_ = lowest_.configuration;
      climbed_ = 0.0;
      steps_above_ = 0;
      raiseShift();
      return false;
    }
    return near && approach(size);
  }

  // Steps with the factors at hand for as long as each is much shorter than the one before; at rest when what
  // the next ones would add up to is next to nothing.
  bool approach(StepSize last) {
    while (true) {
      const StepSize size = findStep();
      const double contraction =
          std::max(size.rotation / last.rotation, size.displacement / last.displacement);
      if (!(contraction < kContraction)) break;
      const double left = std::max(size.rotation, size.displacement / length_) * contraction;
      if (options_.rough && left < kRoughlyLeft) return endRoughly();
      system_.move(step_, configuration_);
      if (left < kLeft) return true;
      system_.evaluate(configuration_, Hessian::none);
      last = size;
    }
    evaluateExactly();
    return false;
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
    if (shift_ < kSmallestShift) shift_ = neutral_;
  }

  void raiseShift() {
    shift_ = std::max(kFirstShift, shift_ * kShiftGrowth);
    if (shift_ > kLargestShift) result_.iterations = options_.max_iterations;
    evaluateExactly();
  }

  // Plain Newton steps, whatever the Hessian's inertia.
  void settle() {
    constexpr int kSteps = 12;
    constexpr double kNearStep = 0.7;  // of a step that leads to a shape near by [rad]
    shift_ = neutral_;
    for (int k = 0; k < kSteps; ++k) {
      system_.evaluate(configuration_, predicted_ ? Hessian::predicted : Hessian::exact);
      system_.factorise(shift_, metric_);
      const StepSize size = findStep();
      if (!(size.rotation < kNearStep) || !(size.displacement < kNearStep * length_)) return;
      system_.predictStress(step_);
      predicted_ = true;
      system_.move(step_, configuration_);
      if (isFinal(size)) break;
    }
    evaluateExactly();
    result_.residual = system_.residual();
    result_.stationary = result_.residual <= 1e3 * tolerance();
    result_.stable = system_.factorise(kGentleGrowth * neutral_, metric_) == 0 && result_.stationary;
  }

  // Off a stationary point with a negative pivot, along the motion of least stiffness, by an angle that is
  // another one at every attempt. Whether the energy has fallen is judged a few steps later. Without a push
  // left, or room for one, all is as it was, the Hessian factorised anew.
  bool leaveSaddle() {
    constexpr double kPushes[] = {0.05, -0.05, 0.2, -0.2, 0.5, -0.5, 0.01, -0.01};  // [rad]
    NodalField motion;
    evaluateExactly();
    smallestEigenvalue(system_, configuration_, &motion);
    const StepSize size = sizeOf(motion);
    while (saddles_ < std::size(kPushes)) {
      NodalField push = motion;
      push.scale(kPushes[saddles_++] / std::max(size.rotation, 4.0 * size.displacement / length_));
      Configuration aside = configuration_;
      evaluateExactly();
      const double before = system_.energy().total();
      system_.predictStress(push);
      const double work = system_.move(push, aside);
      if (!system_.arcLengthsInOrder(aside)) continue;
      lowest_ = {configuration_, before};
      configuration_ = std::move(aside);
      system_.evaluate(configuration_, Hessian::predicted);
      predicted_ = true;
      climbed_ = system_.energy().total() - before - work;
      steps_above_ = 0;
      final_steps_ = 0;
      smallest_shift_ = false;
      shift_ = kFirstShift;
      return true;
    }
    evaluateExactly();
    system_.factorise(kGentleGrowth * neutral_, metric_);
    return false;
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
  double last_rotation_ = INFINITY;  // of the last step [rad]
  std::vector<RodSystem::Metric> metric_;
  NodalField force_, step_;
  Configuration trial_;
  Minimum result_;
  double length_ = 0.0;
  double neutral_ = kNeutralShift;
  double shift_ = kNeutralShift;
  double too_small_shift_ = 0.0;  // the largest one tried that left the Hessian indefinite; 0: none
  int final_steps_ = 0;
  std::size_t saddles_ = 0;
  bool smallest_shift_ = false;  // the shift is no larger than the Hessian's inertia asks for
};

}  // namespace

Minimum minimise(RodSystem& system, Configuration& configuration, const MinimiseOptions& options) {
  return Descent(system, configuration, options).run();
}

}  // namespace cable_variation
