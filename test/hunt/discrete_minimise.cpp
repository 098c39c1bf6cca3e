#include <hunt/discrete_minimise.h>

#include <algorithm>
#include <cmath>

#include <Eigen/SparseCholesky>

namespace cable_variation::hunt {
namespace {

using Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;

constexpr double kSmallStep = 1e-9;  // of a cable's length, or rad

// LDLᵀ of H + shift·M; the signs of D are the inertia.
class Factor {
 public:
  /// Negative pivots; -1: the factorisation broke down.
  int compute(const Matrix& hessian, const VectorXd& metric, double shift) {
    Matrix shifted = hessian;
    if (shift != 0.0) {
      for (Eigen::Index i = 0; i < metric.size(); ++i) shifted.coeffRef(i, i) += shift * metric[i];
    }
    if (!analysed_) solver_.analyzePattern(shifted);
    analysed_ = true;
    solver_.factorize(shifted);
    if (solver_.info() != Eigen::Success) return -1;
    return static_cast<int>((solver_.vectorD().array() <= 0.0).count());
  }
  VectorXd solve(const VectorXd& b) const { return solver_.solve(b); }

 private:
  Eigen::SimplicialLDLT<Matrix> solver_;
  bool analysed_ = false;
};

// A sliding clip nearer than this share of its cable to what is next has left its room.
constexpr double kNoRoom = 1e-3;

// A shift, in units of the bending metric, within which rounding and neutral motions leave the sign of an
// eigenvalue undecided: rounding leaves some 1e-16 of the stiffest entry, that of stretch.
double neutralShift(const DiscreteRod& rod, const Matrix& hessian) {
  constexpr double kNeutral = 1e-9, kRounding = 1e-15;
  double stiffest = 0.0;
  for (Eigen::Index i = 0; i < hessian.rows(); ++i) {
    stiffest = std::max(stiffest, hessian.coeff(i, i) / rod.bendingMetric()[i]);
  }
  return std::max(kNeutral, kRounding * stiffest);
}

}  // namespace

Settling settle(const DiscreteRod& rod, DiscreteShape& shape) {
  constexpr int kMost = 30;
  Settling result;
  Factor factor;
  VectorXd gradient;
  Matrix hessian;
  RodModel model;
  model.given_force = true;
  // a neutral motion needs a shift, lest rounding is taken for a force along it
  for (double shift : {1e-12, 1e-9, 1e-6}) {
    DiscreteShape trial = shape;
    for (int i = 0; i < kMost && !result.stationary; ++i, ++result.iterations) {
      rod.assemble(trial, model, gradient, hessian);
      if (factor.compute(hessian, rod.bendingMetric(), shift) < 0) break;
      VectorXd step = -factor.solve(gradient);
      if (!step.allFinite()) break;
      step *= rod.largestShare(step, trial, 0.3, 0.05);
      rod.move(step, model, trial);
      result.stationary = rod.size(step) < kSmallStep;
    }
    if (!result.stationary) continue;
    shape = std::move(trial);
    break;
  }
  if (!result.stationary) return result;
  rod.assemble(shape, {}, gradient, hessian);
  result.stable = factor.compute(hessian, rod.bendingMetric(), neutralShift(rod, hessian)) == 0;
  return result;
}

namespace {

// Where a saddle falls off: the motion that the shifted Hessian resists least, by inverse iteration.
VectorXd softestMotion(const Factor& factor, const DiscreteRod& rod) {
  constexpr int kRounds = 8;
  VectorXd motion(rod.unknowns());
  for (Eigen::Index i = 0; i < motion.size(); ++i) motion[i] = std::sin(1.7 * static_cast<double>(i) + 0.3);
  for (int i = 0; i < kRounds; ++i) {
    motion = factor.solve(rod.bendingMetric().cwiseProduct(motion));
    motion /= rod.size(motion);
  }
  return motion;
}

// Downhill with the exact Hessian, shifted until it is positive definite.
bool descendAt(const DiscreteRod& rod, const RodModel& model, int most, double accuracy, DiscreteShape& shape,
               int& iterations) {
  constexpr double kFirstShift = 1e-3;
  Factor factor;
  VectorXd gradient;
  Matrix hessian;
  double shift = kFirstShift;
  for (int i = 0; i < most; ++i, ++iterations) {
    const DiscreteRod::Energy terms = rod.assemble(shape, model, gradient, hessian);
    const double energy = terms.total(), neutral = neutralShift(rod, hessian);
    // what rounding leaves of a sum of large terms
    const double noise =
        1e-13 * (terms.elastic() + terms.springs + std::abs(terms.gravity) + std::abs(terms.loads));
    bool moved = false;
    for (int attempt = 0; attempt < 40 && !moved; ++attempt) {
      const int negative = factor.compute(hessian, rod.bendingMetric(), shift);
      if (negative != 0) {
        shift = std::max(kFirstShift, 4.0 * shift);
        continue;
      }
      VectorXd step = -factor.solve(gradient);
      const double share = rod.largestShare(step, shape, 0.6, 0.15);
      step *= share;
      const double promised = gradient.dot(step);
      const bool arrived = share == 1.0 && rod.size(step) < accuracy;
      // along a neutral motion there is no end of steps, and nothing to win
      if (shift <= neutral && (arrived || std::abs(promised) < 1e-2 * noise)) {
        rod.move(step, model, shape);
        return true;
      }
      if (share == 1.0 && rod.size(step) < 1e-3 * accuracy) {
        if (factor.compute(hessian, rod.bendingMetric(), neutral) != 0) {
          factor.compute(hessian, rod.bendingMetric(), shift);
          step = softestMotion(factor, rod);
          step *= 0.01 / rod.size(step);
        }
        rod.move(rod.largestShare(step, shape, 0.6, 0.15) * step, model, shape);
        shift = neutral;
        moved = true;
        continue;
      }
      DiscreteShape trial = shape;
      rod.move(step, model, trial);
      if (rod.energy(trial, model).total() <= energy + 1e-4 * promised + noise) {
        shape = std::move(trial);
        shift = std::max(neutral, (share == 1.0 ? 0.1 : 0.3) * shift);
        if (shift < 1e-6) shift = neutral;
        moved = true;
      } else {
        shift = std::max(kFirstShift, 4.0 * shift);
      }
    }
    if (!moved || rod.smallestRoom(shape) < kNoRoom) return false;
  }
  return false;
}

// Newton with the forces' own prediction, for the last small part of the way at a higher EA.
bool convergeAt(const DiscreteRod& rod, RodModel model, DiscreteShape& shape, int& iterations) {
  constexpr int kMost = 25;
  model.given_force = true;
  Factor factor;
  VectorXd gradient;
  Matrix hessian;
  double shift = 0.0;  // beyond what neutral motions need
  for (int i = 0; i < kMost; ++i, ++iterations) {
    rod.assemble(shape, model, gradient, hessian);
    const double neutral = neutralShift(rod, hessian);
    int negative = factor.compute(hessian, rod.bendingMetric(), neutral + shift);
    for (int attempt = 0; attempt < 20 && negative != 0; ++attempt) {
      shift = std::max(1e-3, 4.0 * shift);
      negative = factor.compute(hessian, rod.bendingMetric(), neutral + shift);
    }
    if (negative != 0) return false;
    VectorXd step = -factor.solve(gradient);
    if (!step.allFinite()) return false;
    const double share = rod.largestShare(step, shape, 0.3, 0.05);
    step *= share;
    rod.move(step, model, shape);
    if (share == 1.0 && shift == 0.0 && rod.size(step) < kSmallStep) return true;
    shift = shift < 1e-6 ? 0.0 : 0.1 * shift;
  }
  return false;
}

}  // namespace

Settling descend(const DiscreteRod& rod, DiscreteShape& shape) {
  constexpr double kFirstCap = 30.0, kLastCap = 3e7, kRaise = 30.0;
  Settling result;
  VectorXd gradient;
  Matrix hessian;
  Factor factor;
  RodModel model;
  model.cap = kFirstCap;
  // what the start's own strain would do to sliding clips is none of the cable's doing
  model.hold_slides = true;
  descendAt(rod, model, 200, 1e-3, shape, result.iterations);
  model.hold_slides = false;
  if (!descendAt(rod, model, 400, 1e-5, shape, result.iterations)) return result;
  double reached = kFirstCap, raise = kRaise;
  while (std::isfinite(reached)) {
    const double next =
        reached * raise > kLastCap ? std::numeric_limits<double>::infinity() : reached * raise;
    model.cap = next;
    DiscreteShape trial = shape;
    bool there = convergeAt(rod, model, trial, result.iterations);
    if (!there && raise < 2.0) {
      trial = shape;
      there = descendAt(rod, model, 400, kSmallStep, trial, result.iterations);
      if (!there) return result;
    }
    if (there) {
      shape = std::move(trial);
      reached = next;
      raise = std::min(kRaise, raise * 2.0);
    } else {
      raise = std::sqrt(raise);
    }
  }
  result.stationary = true;
  rod.assemble(shape, {}, gradient, hessian);
  result.stable = factor.compute(hessian, rod.bendingMetric(), neutralShift(rod, hessian)) == 0;
  return result;
}

double smallestEigenvalue(const DiscreteRod& rod, const DiscreteShape& shape, double relative) {
  VectorXd gradient;
  Matrix hessian;
  rod.assemble(shape, {}, gradient, hessian);
  Factor factor;
  const auto below = [&](double value) { return factor.compute(hessian, rod.surfaceMetric(), -value) != 0; };
  // one motion's quotient is an upper bound; from there outwards until the count changes
  double unit = 0.0;
  for (Eigen::Index i = 0; i < hessian.rows(); ++i) {
    const double quotient = std::abs(hessian.coeff(i, i)) / rod.surfaceMetric()[i];
    unit = i == 0 ? quotient : std::min(unit, quotient);
  }
  double low, high;
  const double least = 1e-12 * unit;
  if (below(0.0)) {
    high = 0.0;
    low = -least;
    while (below(low) && low > -1e3 * unit) low *= 4.0;
    if (low < -least) high = low / 4.0;
  } else {
    low = 0.0;
    high = least;
    while (!below(high) && high < 1e3 * unit) high *= 4.0;
    if (high > least) low = high / 4.0;
  }
  while (high - low > relative * std::max(std::abs(low), std::abs(high))) {
    const double middle = 0.5 * (low + high);
    (below(middle) ? high : low) = middle;
    if (std::max(std::abs(low), std::abs(high)) <= least) break;
  }
  return 0.5 * (low + high);
}

}  // namespace cable_variation::hunt
