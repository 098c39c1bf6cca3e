#pragma once

// A planar chain of stiff links that touches a line or a point: its stationary shape by Newton's method on
// all angles and multipliers, and the smallest eigenvalue of its Hessian on what the constraints leave free,
// dense. Nothing of it is shared with the solver.

#include <cmath>
#include <functional>
#include <vector>

#include <Eigen/Dense>

namespace cable_variation::test {

struct LinkChain {
  double length = 0.0, EI = 0.0, radius = 0.0;
  double start_angle = 0.0;
  bool held_end = false;  ///< at `end`, with angle end_angle
  Eigen::Vector2d end = Eigen::Vector2d::Zero();
  double end_angle = 0.0;
  /// What is smallest where it touches, by a node's position, and the gap by that smallest value.
  std::function<double(const Eigen::Vector2d&)> near;
  std::function<double(double)> gap;

  Eigen::VectorXd angles, multipliers;  ///< of the gap: the force

  double link() const { return length / static_cast<double>(angles.size()); }

  std::vector<Eigen::Vector2d> nodes(const Eigen::VectorXd& theta) const {
    std::vector<Eigen::Vector2d> x{Eigen::Vector2d::Zero()};
    for (Eigen::Index j = 0; j < theta.size(); ++j)
      x.push_back(x.back() + link() * Eigen::Vector2d(std::cos(theta[j]), std::sin(theta[j])));
    return x;
  }

  double energy(const Eigen::VectorXd& theta) const {
    const double spring = EI / link();
    double sum = spring * std::pow(theta[0] - start_angle, 2);  // half a link to the clamp
    for (Eigen::Index j = 1; j < theta.size(); ++j)
      sum += 0.5 * spring * std::pow(theta[j] - theta[j - 1], 2);
    if (held_end) sum += spring * std::pow(end_angle - theta[theta.size() - 1], 2);
    return sum;
  }

  // The minimum of the parabola through the three nodes about the smallest one.
  Eigen::VectorXd constraints(const Eigen::VectorXd& theta) const {
    const std::vector<Eigen::Vector2d> x = nodes(theta);
    std::size_t at = 1;
    for (std::size_t j = 1; j + 1 < x.size(); ++j)
      if (near(x[j]) < near(x[at])) at = j;
    const double a = near(x[at - 1]), b = near(x[at]), c = near(x[at + 1]);
    const double least = b - (c - a) * (c - a) / (8.0 * (a - 2.0 * b + c));
    Eigen::VectorXd values(held_end ? 3 : 1);
    values[0] = gap(least);
    if (held_end) values.tail<2>() = x.back() - end;
    return values;
  }

  double lagrangian(const Eigen::VectorXd& theta) const {
    return energy(theta) - multipliers.dot(constraints(theta));
  }

  // Differences of fourth order: nothing is derived by hand.
  Eigen::MatrixXd constraintSlopes() const {
    constexpr double kStep = 1e-4;
    Eigen::MatrixXd slopes(held_end ? 3 : 1, angles.size());
    for (Eigen::Index j = 0; j < angles.size(); ++j) {
      const auto at = [&](double by) {
        Eigen::VectorXd theta = angles;
        theta[j] += by * kStep;
        return constraints(theta);
      };
      slopes.col(j) = (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * kStep);
    }
    return slopes;
  }

  Eigen::VectorXd energySlopes() const {
    Eigen::VectorXd slopes(angles.size());
    const double spring = EI / link();
    for (Eigen::Index j = 0; j < angles.size(); ++j) {
      slopes[j] = j == 0 ? 2.0 * spring * (angles[0] - start_angle) : spring * (angles[j] - angles[j - 1]);
      if (j + 1 < angles.size())
        slopes[j] -= spring * (angles[j + 1] - angles[j]);
      else if (held_end)
        slopes[j] -= 2.0 * spring * (end_angle - angles[j]);
    }
    return slopes;
  }

  Eigen::MatrixXd hessian() const {
    constexpr double kStep = 3e-4;
    const Eigen::Index count = angles.size();
    Eigen::MatrixXd result(count, count);
    const auto at = [&](Eigen::Index i, double di, Eigen::Index j, double dj) {
      Eigen::VectorXd theta = angles;
      theta[i] += di * kStep;
      theta[j] += dj * kStep;
      return -multipliers.dot(constraints(theta));
    };
    for (Eigen::Index i = 0; i < count; ++i) {
      for (Eigen::Index j = 0; j <= i; ++j) {
        result(i, j) =
            (at(i, 1, j, 1) - at(i, 1, j, -1) - at(i, -1, j, 1) + at(i, -1, j, -1)) / (4.0 * kStep * kStep);
        result(j, i) = result(i, j);
      }
    }
    const double spring = EI / link();
    for (Eigen::Index j = 0; j < count; ++j) {
      const bool first = j == 0, last = j + 1 == count;
      result(j, j) += spring * ((first ? 2.0 : 1.0) + (last ? (held_end ? 2.0 : 0.0) : 1.0));
      if (!last) {
        result(j, j + 1) -= spring;
        result(j + 1, j) -= spring;
      }
    }
    return result;
  }

  /// From angles near by; returns the largest change of an angle in the last step.
  double settle() {
    multipliers = Eigen::VectorXd::Zero(held_end ? 3 : 1);
    double last = INFINITY;
    for (int step = 0; step < 12 && last > 1e-9; ++step) {
      const Eigen::MatrixXd slopes = constraintSlopes();
      const Eigen::Index count = angles.size(), held = slopes.rows();
      Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count + held, count + held);
      matrix.topLeftCorner(count, count) = hessian();
      matrix.topRightCorner(count, held) = -slopes.transpose();
      matrix.bottomLeftCorner(held, count) = slopes;
      Eigen::VectorXd rhs(count + held);
      rhs << -energySlopes(), -constraints(angles);
      const Eigen::VectorXd solution = matrix.partialPivLu().solve(rhs);
      last = solution.head(count).cwiseAbs().maxCoeff();
      angles += solution.head(count);
      multipliers = solution.tail(held);
    }
    return last;
  }

  /// Of motions that keep all constraints, over the mean square motion of a round cable's surface [N/m].
  double smallestEigenvalue() const {
    const Eigen::Index count = angles.size();
    Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(count, count);
    const double h = link();
    Eigen::MatrixXd motion = Eigen::MatrixXd::Zero(2, count);  // of a node, by all angles
    for (Eigen::Index node = 1; node <= count; ++node) {
      motion.col(node - 1) = h * Eigen::Vector2d(-std::sin(angles[node - 1]), std::cos(angles[node - 1]));
      const double share = node == count ? 0.5 * h : h;
      mass += share / length * motion.transpose() * motion;
      mass(node - 1, node - 1) += 0.5 * radius * radius * h / length;
    }
    const Eigen::MatrixXd free = constraintSlopes().fullPivLu().kernel();
    const Eigen::MatrixXd stiffness = free.transpose() * hessian() * free,
                          weight = free.transpose() * mass * free;
    return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(stiffness, weight).eigenvalues()[0];
  }
};

}  // namespace cable_variation::test
