#include <cable_variation/scene/locating_scheme.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include <Eigen/LU>
#include <Eigen/SVD>

#include <cable_variation/util/quantity.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Vector6d = Eigen::Matrix<double, 6, 1>;

constexpr double kLargestCondition = 1e4;  // beyond it a deviation of 0.1 mm moves the part by a metre

constexpr double kBoundless = 1e12;  // beyond it the figure is rounding error

Vector3d centroid(const Locators& locators) {
  Vector3d sum = Vector3d::Zero();
  for (const auto& locator : locators) sum += locator.first;
  return sum / static_cast<double>(locators.size());
}

double spread(const Locators& locators, const Vector3d& centre) {
  double sum = 0.0;
  for (const auto& locator : locators) sum += (locator.first - centre).squaredNorm();
  return std::sqrt(sum / static_cast<double>(locators.size()));
}

// Row i: derivative of nᵢ·pᵢ for a shift of the part and a turn about its
// centre, with its points at `arms` from it.
Matrix6d jacobian(const Locators& locators, const std::array<Vector3d, 6>& arms) {
  Matrix6d rows;
  for (std::size_t i = 0; i < 6; ++i) {
    const Vector3d& n = locators[i].second;
    rows.row(static_cast<int>(i)) << n.transpose(), arms[i].cross(n).transpose();
  }
  return rows;
}

}  // namespace

void checkLocatingScheme(const Locators& locators) {
  if (locators.size() != 6) {
    throw std::invalid_argument("a locating scheme of " + std::to_string(locators.size()) +
                                "; expected 6 locators");
  }
  const Vector3d centre = centroid(locators);
  const double size = spread(locators, centre);
  double condition = std::numeric_limits<double>::infinity();
  if (size > 0.0) {
    std::array<Vector3d, 6> arms;
    for (std::size_t i = 0; i < 6; ++i) arms[i] = (locators[i].first - centre) / size;
    const Vector6d values = Eigen::JacobiSVD<Matrix6d>(jacobian(locators, arms)).singularValues();
    condition = values[0] / values[5];
  }
  if (!(condition <= kLargestCondition)) {
    throw std::invalid_argument("the locating scheme is singular, condition number " +
                                (condition < kBoundless ? shortNumber(condition) : "beyond 1e+12") +
                                "; expected at most " + shortNumber(kLargestCondition) +
                                " (six locators that together hold the part)");
  }
}

Pose locatedPose(const Locators& locators, const std::array<double, 6>& deviations) {
  checkLocatingScheme(locators);
  constexpr int kSteps = 30;
  constexpr double kConverged = 1e-13;  // [m]
  const Vector3d centre = centroid(locators);
  Vector3d shift = Vector3d::Zero();
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  for (int step = 0; step < kSteps; ++step) {
    std::array<Vector3d, 6> arms;
    Vector6d residual;
    for (std::size_t i = 0; i < 6; ++i) {
      arms[i] = turn * (locators[i].first - centre);
      const Vector3d moved = centre + arms[i] + shift;
      residual[static_cast<int>(i)] = locators[i].second.dot(moved - locators[i].first) - deviations[i];
    }
    if (residual.cwiseAbs().maxCoeff() < kConverged) {
      return {centre + shift - turn * centre, turn};
    }
    const Vector6d correction = jacobian(locators, arms).fullPivLu().solve(-residual);
    if (!correction.allFinite()) break;
    shift += correction.head<3>();
    const Vector3d rotation = correction.tail<3>();
    if (rotation.norm() > 0.0) {
      turn =
          (Eigen::Quaterniond(Eigen::AngleAxisd(rotation.norm(), rotation.normalized())) * turn).normalized();
    }
  }
  std::string given;
  for (const double deviation : deviations) given += (given.empty() ? "" : ", ") + shortNumber(deviation);
  throw std::invalid_argument("no rigid motion near the nominal pose satisfies the locators' deviations of " +
                              given + " m; expected them small beside the distances between the locators");
}

std::array<FrameRate, 6> locatedRates(const Locators& locators, const Pose& located) {
  const Vector3d centre = centroid(locators);
  std::array<Vector3d, 6> arms;
  for (std::size_t i = 0; i < 6; ++i) arms[i] = located.orientation * (locators[i].first - centre);
  const Matrix6d motions = jacobian(locators, arms).partialPivLu().inverse();
  if (!motions.allFinite()) throw std::invalid_argument("the locating scheme is singular where the part is");
  const Vector3d from_centre = located.position - located * centre;
  std::array<FrameRate, 6> rates;
  for (std::size_t i = 0; i < 6; ++i) {
    const int column = static_cast<int>(i);
    rates[i].rotation = motions.col(column).tail<3>();
    rates[i].translation = motions.col(column).head<3>() + rates[i].rotation.cross(from_centre);
  }
  return rates;
}

}  // namespace cable_variation
