#pragma once

#include <Eigen/Core>

#include <cable_variation/math/pose.h>
#include <cable_variation/rod/section.h>

namespace cable_variation::bench {

/// One cable clamped at both ends, solved by plain shooting: the section force
/// and moment at the start are the unknowns, the rod equations are integrated by
/// Runge and Kutta's method of order four in equal steps, and Levenberg and
/// Marquardt's method with a difference Jacobian closes the gap at the far clamp.
/// The yardstick for ratios in one run: the kind of solver that others use.
class ShootingSolver {
 public:
  struct Problem {
    Section section;
    double length = 0.0;  ///< [m]
    Eigen::Vector3d gravity;
    Pose start, end;
  };
  static constexpr int kSteps = 40;

  struct Solution {
    bool converged = false;
    int iterations = 0;
    Eigen::Matrix<double, 6, 1> start_wrench;         ///< force [N] and moment [N m], world
    Eigen::Matrix<double, 3, kSteps + 1> centreline;  ///< [m]
  };

  /// From `guess` for the wrench at the start; zero is the straight rod.
  Solution solve(const Problem& problem, const Eigen::Matrix<double, 6, 1>& guess) const;
};

}  // namespace cable_variation::bench
