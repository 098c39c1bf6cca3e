#include <cable_variation/equilibrium/search/minimise.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include <cable_variation/equilibrium/discretisation/contact_system.h>
#include <cable_variation/equilibrium/search/smallest_eigenvalue.h>

namespace cable_variation {
namespace {

// What DescentOptions leaves alone. Sizes of steps are in radians, and as shares of the longest cable.

// A full Newton step below this leaves an error near its square: 1e-12, rounding.
constexpr double kFinalStep = 1e-6;
// So much as such a step leaves may be left by steps with the same factors, which contract linearly.
constexpr double kLeft = 1e-14;
// Rough descents: the energy is off by the square of what is left, so these know it to 1e-6 and 1e-10 at
// worst.
constexpr double kRoughStep = 1e-3;
constexpr double kRoughlyLeft = 1e-5;
// So often a final step may leave a residual above rounding before it is taken for what there is: where it is
// the sum of stiff and soft parts it takes a step or two more.
constexpr int kFinalSteps = 4;
// And may then be so many times rounding at most: rounding is estimated, and steps say that nothing moves.
constexpr double kOfResidual = 1e3;
// Close to rest, after a rotation below this, a negative pivot may be that of a motion which costs nothing (a
// round buckled column that rolls), off zero by what is left of the residual: then damping begins just above
// none and grows by this, lest the last steps creep.
constexpr double kSmallRotation = 1e-2;
constexpr double kGentleGrowth = 100.0;
// With more damping than that of such a motion, grown once or twice, a small step need not mean rest.
constexpr double kLargestNeutral = 2e-5;
// Damping so large that steps are nothing: the descent has failed.
constexpr double kLargestDamping = 1e12;
// Armijo's condition (Nocedal and Wright, Numerical Optimization, 3.4): the energy falls by this share of
// what the slope promises; it may rise by its rounding.
constexpr double kArmijo = 1e-4;
constexpr double kEnergyNoise = 1e-13;
// A Newton step on a quadratic gains half of the slope: near it, and well above, damping shrinks, fast and
// slowly.
constexpr double kQuadratic[] = {0.4, 0.6};
constexpr double kFair = 0.2;
constexpr double kFastShrink = 1e-3;

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
    neutral_ = damping_ = neutralShift(system_);
    length_ = largestArcLength(configuration_);
    lowest_ = {configuration_, system_.energy().total()};
    if (options_.settle) {
      settle();
      return result_;
    }
    while (result_.iterations < options_.max_iterations) {
      if (!factorise()) {
        result_.end = DescentEnd::indefinite;
        break;
      }
      const StepSize size = lengthen(findStep());
      if (!std::isfinite(size.displacement) || !std::isfinite(size.rotation)) {
        result_.end = DescentEnd::not_finite;
        break;
      }
      if (isRoughlyFinal(size)) {
        if (endRoughly()) break;
        continue;
      }
      if (!isFinal(size)) {
        if (tryStep(size) && judge()) break;
        if (damping_ > kLargestDamping) {
          result_.end = DescentEnd::no_descent;
          break;
        }
      } else if (damping_ > std::max(kLargestNeutral, 10.0 * neutral_)) {
        if (!least_damping_) {  // the step may be small because of the damping
          damping_ = neutral_;
          evaluateExactly();
          least_damping_ = true;
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

  // Raises the damping until the damped Hessian is positive definite.
  bool factorise() {
    too_little_damping_ = 0.0;
    while (system_.factorise(damping_, metric_) > 0) {
      too_little_damping_ = damping_;
      // close to rest a negative pivot may be that of a neutral motion, off zero by what is left of the
      // residual
      const bool gently = last_rotation_ < kSmallRotation && damping_ < options_.descent.smallest_damping;
      damping_ = gently
                     ? kGentleGrowth * damping_
                     : std::max(options_.descent.first_damping, damping_ * options_.descent.damping_growth);
      if (damping_ > kLargestDamping) return false;
      evaluateAgain();
    }
    return true;
  }

  // Where the Hessian is indefinite, damping just large enough leads far along its direction of negative
  // curvature, and several times that creeps: the former is looked for while steps are short. Each trial
  // halves what lies between on a scale of logarithms: three leave the eighth root of the damping's
  // growth, 1.3.
  StepSize lengthen(StepSize size) {
    constexpr int kTrials = 3;
    constexpr double kShort = 0.2;  // of the longest step
    const auto isShort = [&] {
      return size.rotation < kShort * options_.descent.largest_rotation &&
             size.displacement < kShort * options_.descent.largest_displacement * length_;
    };
    for (int trial = 0; too_little_damping_ > options_.descent.first_damping && isShort() && trial < kTrials;
         ++trial) {
      const double between = std::sqrt(too_little_damping_ * damping_);
      evaluateAgain();
      if (system_.factorise(between, metric_) > 0) {
        too_little_damping_ = between;
        continue;
      }
      damping_ = between;
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
    return options_.rough && damping_ == neutral_ && size.displacement < kRoughStep * length_ &&
           size.rotation < kRoughStep;
  }

  // Goes the last step. Whether the Hessian there is positive, by the section forces that the step leads to;
  // else the descent is no longer a rough one.
  bool endRoughly() {
    system_.predictStress(step_);
    system_.move(step_, configuration_);
    system_.evaluate(configuration_, Hessian::predicted);
    predicted_ = true;
    options_.rough = system_.factorise(kGentleGrowth * neutral_, metric_) == 0;
    if (options_.rough) {
      result_.end = DescentEnd::near_minimum;
    } else {
      evaluateAgain();
    }
    return options_.rough;
  }

  double tolerance() const { return residualTolerance(system_); }

  // Of a descent that has come to rest with a residual, `saddle`: by a Hessian that is not positive.
  DescentEnd endAt(double residual, bool saddle) const {
    if (!(residual <= kOfResidual * tolerance())) return DescentEnd::residual_left;
    return saddle ? DescentEnd::saddle : DescentEnd::minimum;
  }

  // After a step so small that it ends the iteration, unless the residual or the Hessian here says otherwise.
  bool judge() {
    if (result_.end == DescentEnd::near_minimum) return true;  // it was judged so
    evaluateExactly();
    const double residual = system_.residual();
    if (residual > tolerance() && ++final_steps_ <= kFinalSteps) return false;
    const bool saddle = system_.factorise(kGentleGrowth * neutral_, metric_) > 0;
    if (saddle && leaveSaddle()) return false;
    result_.end = endAt(residual, saddle);
    return true;
  }

  // Goes one step. Whether it has come to rest, by steps with the same factors close to it.
  bool tryStep(const StepSize& size) {
    least_damping_ = false;
    last_rotation_ = size.rotation;
    double limit = std::min(
        1.0, std::min(options_.descent.largest_rotation / (size.rotation + 1e-300),
                      options_.descent.largest_displacement * length_ / (size.displacement + 1e-300)));
    if (limit < 1.0) step_.scale(limit);
    if (system_.contact() && !keepOutside(limit)) {
      raiseDamping();
      return false;
    }
    const double before = system_.energy().total();
    const double slope = system_.gradient().dot(step_);
    system_.predictStress(step_);
    trial_ = configuration_;
    const double work = system_.move(step_, trial_);
    if (!system_.arcLengthsInOrder(trial_)) {
      raiseDamping();
      return false;
    }
    const bool near = damping_ == neutral_ && size.rotation < options_.descent.reuse_below &&
                      size.displacement < options_.descent.reuse_below * length_ && system_.keepsFactors() &&
                      !system_.contact();
    system_.evaluate(trial_, near ? Hessian::none : Hessian::predicted);
    predicted_ = true;
    const double change = system_.energy().total() - before - work;
    if (!std::isfinite(change)) {
      raiseDamping();
      return false;
    }
    std::swap(configuration_, trial_);
    climbed_ += change;
    const double noise = kEnergyNoise * (std::abs(before) + system_.energy().elastic);
    if (climbed_ <= kArmijo * slope + noise) {
      lowest_.configuration = configuration_;
      lowest_.energy = system_.energy().total();
      climbed_ = 0.0;
      steps_above_ = 0;
      lowerDamping(limit, change / slope);
    } else if (++steps_above_ > options_.descent.longest_climb) {
      configuration_ = lowest_.configuration;
      climbed_ = 0.0;
      steps_above_ = 0;
      raiseDamping();
      return false;
    }
    return near && approach(size);
  }

  // Shortens the step, of which `limit` is left, to what carries no cable through a part it has contact with,
  // and to where it has closed gaps that the step knows nothing of by no more than the step gains: the next
  // one knows of them. Whether any of it is left.
  bool keepOutside(double& limit) {
    constexpr double kShortest = 1e-5;
    constexpr double kOfGain = 0.5;
    constexpr int kTrials = 30;
    ContactSystem& contact = *system_.contact();
    double share = contact.freeShare(configuration_, step_);
    const std::array<double, 2> known = contact.energyAlong(step_);
    const double before = system_.energy().contact, gain = -system_.gradient().dot(step_);
    const double noise = kEnergyNoise * (std::abs(system_.energy().total()) + system_.energy().elastic);
    NodalField part = step_;
    for (int trial = 0; trial < kTrials && share > kShortest; ++trial) {
      part = step_;
      part.scale(share);
      trial_ = configuration_;
      system_.move(part, trial_);
      contact.evaluate(trial_);
      const double expected = share * (known[0] + share * known[1]);
      const double rise = contact.energy() - before - expected;
      const double most = kOfGain * share * std::max(gain, 0.0) + noise;
      if (rise <= most) break;
      // it grows with the square of the way beyond where gaps close
      share *= std::clamp(std::sqrt(most / rise), 0.2, 0.8);
    }
    step_ = part;
    limit *= share;
    return share > kShortest;
  }

  // Steps with the factors at hand for as long as each is much shorter than the one before; at rest when what
  // the next ones would add up to is next to nothing.
  bool approach(StepSize last) {
    while (true) {
      const StepSize size = findStep();
      const double contraction =
          std::max(size.rotation / last.rotation, size.displacement / last.displacement);
      if (!(contraction < options_.descent.contraction)) break;
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
  void lowerDamping(double limit, double gain) {
    if (limit < 1.0) {
      damping_ *= 0.5;
    } else if (gain > kQuadratic[0] && gain < kQuadratic[1]) {
      damping_ *= kFastShrink;
    } else if (gain > kFair) {
      damping_ /= options_.descent.damping_growth;
    }
    if (damping_ < options_.descent.smallest_damping) damping_ = neutral_;
  }

  void raiseDamping() {
    damping_ = std::max(options_.descent.first_damping, damping_ * options_.descent.damping_growth);
    evaluateExactly();
  }

  // Plain Newton steps, whatever the Hessian's inertia. From near by each doubles the digits: what is not
  // there after a dozen was not near. A step of twice what a descent's largest turns by is one to another
  // shape.
  void settle() {
    constexpr int kSteps = 12;
    constexpr double kNearStep = 0.7;  // [rad], and of the longest cable
    damping_ = neutral_;
    for (int k = 0; k < kSteps; ++k) {
      system_.evaluate(configuration_, predicted_ ? Hessian::predicted : Hessian::exact);
      system_.factorise(damping_, metric_);
      const StepSize size = findStep();
      if (!(size.rotation < kNearStep) || !(size.displacement < kNearStep * length_)) {
        result_.end = DescentEnd::far_away;
        return;
      }
      if (system_.contact() && system_.contact()->freeShare(configuration_, step_) < 1.0) {
        result_.end = DescentEnd::far_away;
        return;
      }
      system_.predictStress(step_);
      predicted_ = true;
      system_.move(step_, configuration_);
      if (isFinal(size)) break;
    }
    evaluateExactly();
    result_.residual = system_.residual();
    const bool saddle = system_.factorise(kGentleGrowth * neutral_, metric_) > 0;
    result_.end = endAt(result_.residual, saddle);
  }

  // Off a stationary point with a negative pivot, along the motion of least stiffness, by an angle that is
  // another one at every attempt. Whether the energy has fallen is judged a few steps later. Without a push
  // left, or room for one, all is as it was, the Hessian factorised anew. Pushes go both ways, as one of them
  // may lead back; far ones where the energy is flat, near ones last, for stiff cables that a push stretches
  // by more than it relieves.
  bool leaveSaddle() {
    constexpr double kPushes[] = {0.05, -0.05, 0.2, -0.2, 0.5, -0.5, 0.01, -0.01};  // [rad]
    evaluateExactly();
    const NodalField motion = motionOfLeastStiffness(system_, configuration_);
    const StepSize size = sizeOf(motion);
    while (saddles_ < std::size(kPushes)) {
      NodalField push = motion;
      push.scale(kPushes[saddles_++] / std::max(size.rotation, 4.0 * size.displacement / length_));
      if (system_.contact() && system_.contact()->freeShare(configuration_, push) < 1.0) continue;
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
      least_damping_ = false;
      damping_ = options_.descent.first_damping;
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
  double damping_ = kNeutralShift;
  double too_little_damping_ = 0.0;  // the largest one tried that left the Hessian indefinite; 0: none
  int final_steps_ = 0;
  std::size_t saddles_ = 0;
  bool least_damping_ = false;  // it is no more than the Hessian's inertia asks for
};

}  // namespace

const char* toString(DescentEnd end) {
  switch (end) {
    case DescentEnd::minimum:
      return "a minimum";
    case DescentEnd::near_minimum:
      return "near a minimum";
    case DescentEnd::saddle:
      return "a saddle that no way down was found from";
    case DescentEnd::residual_left:
      return "steps became next to nothing, but forces stayed out of balance";
    case DescentEnd::indefinite:
      return "no damping made the stiffness positive";
    case DescentEnd::no_descent:
      return "no damping made the energy fall";
    case DescentEnd::not_finite:
      return "a step was not a number";
    case DescentEnd::far_away:
      return "a step led far away";
    case DescentEnd::most_iterations:
      return "so many steps were not enough";
  }
  return "unknown";
}

Minimum minimise(RodSystem& system, Configuration& configuration, const MinimiseOptions& options) {
  return Descent(system, configuration, options).run();
}

}  // namespace cable_variation
