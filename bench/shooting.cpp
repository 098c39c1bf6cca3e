#include "shooting.h"

#include <Eigen/Dense>

#include <cable_variation/math/so3.h>

namespace cable_variation::bench {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using State = Eigen::Matrix<double, 13, 1>;  // position, quaternion x y z w, force, moment

State slope(const ShootingSolver::Problem& problem, const State& y) {
  const Eigen::Quaterniond q = Eigen::Quaterniond(y.segment<4>(3)).normalized();
  const Eigen::Vector3d n = q.conjugate() * y.segment<3>(7);
  const Eigen::Vector3d m = q.conjugate() * y.segment<3>(10);
  const Section& k = problem.section;
  const Eigen::Vector3d gamma(1.0 + n.x() / k.EA, n.y() / k.GA_y, n.z() / k.GA_z);
  const Eigen::Vector3d omega(m.x() / k.GJ, m.y() / k.EI_y, m.z() / k.EI_z);
  State dy;
  const Eigen::Vector3d tangent = q * gamma;
  dy.head<3>() = tangent;
  dy.segment<4>(3) = 0.5 * (q * Eigen::Quaterniond(0.0, omega.x(), omega.y(), omega.z())).coeffs();
  dy.segment<3>(7) = -k.mass_per_length * problem.gravity;
  dy.segment<3>(10) = -tangent.cross(y.segment<3>(7));
  return dy;
}

Vector6 gap(const ShootingSolver::Problem& problem, const Vector6& wrench,
            ShootingSolver::Solution* solution) {
  State y;
  y.head<3>() = problem.start.position;
  y.segment<4>(3) = problem.start.orientation.coeffs();
  y.tail<6>() = wrench;
  const double h = problem.length / ShootingSolver::kSteps;
  if (solution != nullptr) solution->centreline.col(0) = y.head<3>();
  for (int i = 0; i < ShootingSolver::kSteps; ++i) {
    const State k1 = slope(problem, y);
    const State k2 = slope(problem, y + 0.5 * h * k1);
    const State k3 = slope(problem, y + 0.5 * h * k2);
    const State k4 = slope(problem, y + h * k3);
    y += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    if (solution != nullptr) solution->centreline.col(i + 1) = y.head<3>();
  }
  Vector6 miss;
  miss << (y.head<3>() - problem.end.position),
      so3::log(problem.end.orientation.conjugate() * Eigen::Quaterniond(y.segment<4>(3)).normalized());
  return miss;
}

}  // namespace

ShootingSolver::Solution ShootingSolver::solve(const Problem& problem, const Vector6& guess) const {
  constexpr int kIterations = 200;
  // unknowns in units of EI/L² and EI/L
  const double force = problem.section.EI_y / (problem.length * problem.length);
  Vector6 unit;
  unit << Eigen::Vector3d::Constant(force), Eigen::Vector3d::Constant(force * problem.length);

  Solution solution;
  Vector6 x = guess.cwiseQuotient(unit);
  Vector6 miss = gap(problem, x.cwiseProduct(unit), nullptr);
  double damping = 1e-2;
  for (; solution.iterations < kIterations && miss.norm() > 1e-8; ++solution.iterations) {
    Eigen::Matrix<double, 6, 6> jacobian;
    for (int k = 0; k < 6; ++k) {
      const double step = 1e-7;
      jacobian.col(k) =
          (gap(problem, (x + step * Vector6::Unit(k)).cwiseProduct(unit), nullptr) - miss) / step;
    }
    const Eigen::Matrix<double, 6, 6> normal = jacobian.transpose() * jacobian;
    while (damping < 1e12) {
      Eigen::Matrix<double, 6, 6> damped = normal;
      damped.diagonal().array() += damping;
      const Vector6 trial = x - damped.ldlt().solve(jacobian.transpose() * miss);
      const Vector6 there = gap(problem, trial.cwiseProduct(unit), nullptr);
      if (there.norm() < miss.norm()) {
        x = trial;
        miss = there;
        damping = std::max(1e-12, 0.1 * damping);
        break;
      }
      damping *= 10.0;
    }
  }
  solution.start_wrench = x.cwiseProduct(unit);
  solution.converged = gap(problem, solution.start_wrench, &solution).norm() <= 1e-8;
  return solution;
}

}  // namespace cable_variation::bench
