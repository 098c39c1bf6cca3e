// Rotations against Eigen's own and against differences, near zero, near π and across the switch to series.

#include <cable_variation/math/so3.h>

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace cable_variation::so3 {
namespace {

// Angles from zero to beyond half a turn, on both sides of where series take over (0.002 and 0.05).
const std::vector<double> kAngles{0.0,    1e-9, 1e-5, 0.00199, 0.00201, 0.0499,
                                  0.0501, 0.3,  1.0,  2.0,     3.0,     3.1415};

std::vector<Eigen::Vector3d> rotations() {
  std::mt19937 generator(3);
  std::normal_distribution<double> normal;
  std::vector<Eigen::Vector3d> all;
  for (double angle : kAngles) {
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d axis(normal(generator), normal(generator), normal(generator));
      all.push_back(angle * axis.normalized());
    }
  }
  return all;
}

const Eigen::Vector3d kCovector(0.7, -1.1, 0.4);

TEST(Skew, IsTheCrossProduct) {
  const Eigen::Vector3d v(1.0, -2.0, 3.0), w(0.5, 4.0, -1.0);
  EXPECT_EQ(skew(v) * w, v.cross(w));
}

TEST(Exp, IsTheTurnAboutTheAxis) {
  for (const Eigen::Vector3d& rotation : rotations()) {
    const double angle = rotation.norm();
    const Eigen::Quaterniond expected(
        Eigen::AngleAxisd(angle, angle > 0.0 ? Eigen::Vector3d(rotation / angle) : Eigen::Vector3d::UnitX()));
    EXPECT_LT((exp(rotation).coeffs() - expected.coeffs()).norm(), 1e-15);
    EXPECT_NEAR(exp(rotation).norm(), 1.0, 1e-15);
  }
}

TEST(Log, UndoesExp) {
  for (const Eigen::Vector3d& rotation : rotations()) {
    EXPECT_LT((log(exp(rotation)) - rotation).norm(), 1e-14);
    const Eigen::Quaterniond q = exp(rotation);
    EXPECT_LT((log(Eigen::Quaterniond(-q.coeffs())) - rotation).norm(), 1e-14);  // the same rotation
  }
}

TEST(Log, TakesTheShorterWay) {
  const Eigen::Vector3d turn = log(exp({0.0, 0.0, 4.0}));
  EXPECT_NEAR(turn.z(), 4.0 - 2.0 * M_PI, 1e-14);
}

TEST(RightJacobian, IsTheSlopeOfExp) {
  for (const Eigen::Vector3d& rotation : rotations()) {
    const Eigen::Matrix3d jacobian = rightJacobian(rotation);
    for (int k = 0; k < 3; ++k) {
      const double h = 1e-5;  // central differences leave h² = 1e-10
      const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(k);
      const Eigen::Vector3d ahead = log(exp(rotation).conjugate() * exp(rotation + step));
      const Eigen::Vector3d behind = log(exp(rotation).conjugate() * exp(rotation - step));
      EXPECT_LT(((ahead - behind) / (2.0 * h) - jacobian.col(k)).norm(), 1e-9) << rotation.transpose();
    }
  }
}

TEST(RightJacobianSlope, IsTheSecondOrderOfExp) {
  for (const Eigen::Vector3d& rotation : rotations()) {
    const Eigen::Matrix3d slope = rightJacobianSlope(rotation, kCovector);
    EXPECT_LT((slope - slope.transpose()).norm(), 1e-15);
    std::mt19937 generator(5);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 4; ++i) {
      const Eigen::Vector3d d =
          Eigen::Vector3d(normal(generator), normal(generator), normal(generator)).normalized();
      const auto along = [&](double h) {
        return kCovector.dot(log(exp(rotation).conjugate() * exp(rotation + h * d)));
      };
      const double h = 1e-3;  // the even part of the expansion: h² of it is left, and rounding of 1e-16/h²
      const double second = (along(h) - 2.0 * along(0.0) + along(-h)) / (h * h);
      EXPECT_NEAR(second, d.dot(slope * d), 1e-6) << rotation.transpose();
    }
  }
}

TEST(SmallestRotation, TakesOneDirectionToTheOtherByTheLeastAngle) {
  std::mt19937 generator(11);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d from =
        Eigen::Vector3d(normal(generator), normal(generator), normal(generator)).normalized();
    const Eigen::Vector3d to =
        Eigen::Vector3d(normal(generator), normal(generator), normal(generator)).normalized();
    const Eigen::Quaterniond turn = smallestRotation(from, to);
    EXPECT_LT((turn * from - to).norm(), 1e-14);
    EXPECT_NEAR(log(turn).norm(), std::acos(from.dot(to)), 1e-12);
  }
}

TEST(SmallestRotation, TurnsOppositeDirectionsByHalfATurn) {
  for (const Eigen::Vector3d& from : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 0.6, -0.8)}) {
    const Eigen::Quaterniond turn = smallestRotation(from, -from);
    EXPECT_LT((turn * from + from).norm(), 1e-14);
    EXPECT_NEAR(turn.norm(), 1.0, 1e-15);
  }
  // just short of opposite
  const Eigen::Vector3d from(1, 0, 0), to = Eigen::Vector3d(-1.0, 1e-5, 0.0).normalized();
  EXPECT_LT((smallestRotation(from, to) * from - to).norm(), 1e-9);
}

}  // namespace
}  // namespace cable_variation::so3
