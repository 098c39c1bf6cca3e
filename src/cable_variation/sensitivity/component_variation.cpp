#include <cable_variation/sensitivity/component_variation.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <variant>

#include <Eigen/Eigenvalues>

#include <cable_variation/scene/design_rate.h>
#include <cable_variation/tolerances/tolerances.h>

namespace cable_variation {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

/// Rates of a point of a rigid body by its motion (translation of the origin, rotation vector).
Eigen::Matrix<double, 3, 6> pointRates(const Vector3d& arm) {
  Eigen::Matrix<double, 3, 6> rates;
  rates.leftCols<3>().setIdentity();
  rates.rightCols<3>() << 0.0, arm.z(), -arm.y(), -arm.z(), 0.0, arm.x(), arm.y(), -arm.x(), 0.0;
  return rates;
}

/// The component a design variable moves by itself, or none.
const std::size_t* movedComponent(const DesignTarget& target) {
  if (const auto* translation = std::get_if<ComponentTranslation>(&target)) return &translation->component;
  if (const auto* rotation = std::get_if<ComponentRotation>(&target)) return &rotation->component;
  if (const auto* locator = std::get_if<LocatorDeviation>(&target)) return &locator->component;
  return nullptr;
}

}  // namespace

std::vector<std::size_t> ownVariables(const Scene& scene, std::size_t component) {
  std::vector<std::size_t> own;
  for (std::size_t i = 0; i < scene.design_variables.size(); ++i) {
    const std::size_t* moved = movedComponent(scene.design_variables[i].target);
    if (moved != nullptr && *moved == component) own.push_back(i);
  }
  return own;
}

ComponentVariation componentVariation(const Scene& scene, std::size_t component,
                                      const std::vector<std::size_t>& variables, const DesignValues& values,
                                      const ComponentPoses& moved) {
  if (component >= scene.components.size()) {
    throw std::invalid_argument("component " + std::to_string(component) + "; there are " +
                                std::to_string(scene.components.size()));
  }
  ComponentVariation result;
  result.component = component;
  const std::string& name = scene.components[component].name;
  result.origin = componentPosesAt(scene, values, moved).at(name).position;

  const std::vector<DesignRate> rates = designRates(scene, values, moved, variables);
  Eigen::MatrixXd motion = Eigen::MatrixXd::Zero(6, static_cast<Eigen::Index>(variables.size()));
  for (std::size_t i = 0; i < rates.size(); ++i) {
    for (const auto& [index, rate] : rates[i].components) {
      if (index != component) continue;
      motion.col(static_cast<Eigen::Index>(i)) << rate.translation, rate.rotation;
    }
  }
  const Spread spread = spreadOf(scene, variables);
  result.mean = motion * spread.mean;
  result.covariance = motion * spread.covariance * motion.transpose();
  return result;
}

PointVariation variationAt(const ComponentVariation& variation, const Vector3d& point) {
  const Eigen::Matrix<double, 3, 6> rates = pointRates(point - variation.origin);
  PointVariation result;
  result.point = point;
  result.mean_shift = rates * variation.mean;
  const Matrix3d covariance = rates * variation.covariance * rates.transpose();
  const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(covariance);  // in increasing order
  const double variance = eigen.eigenvalues()[2];
  if (variance > 0.0) {
    result.six_sigma = 6.0 * std::sqrt(variance);
    result.direction = eigen.eigenvectors().col(2);
  }
  return result;
}

PointVariation largestVariation(const Scene& scene, const ComponentVariation& variation, const Pose& pose) {
  PointVariation largest = variationAt(variation, variation.origin);
  bool any = false;
  double least = 0.0;  // the largest variance of all vertices is at least this [m^2]
  for (const Visual& visual : scene.components.at(variation.component).visuals) {
    if (!visual.mesh) continue;
    const Pose placed = pose * visual.pose;
    for (const Vector3d& vertex : visual.mesh->vertices) {
      const Vector3d point = placed * vertex;
      const Eigen::Matrix<double, 3, 6> rates = pointRates(point - variation.origin);
      // The trace bounds the largest eigenvalue: most vertices need no eigenvalues.
      const double trace = (rates * variation.covariance).cwiseProduct(rates).sum();
      if (any && trace <= least) continue;
      const PointVariation found = variationAt(variation, point);
      if (any && found.six_sigma <= largest.six_sigma) continue;
      largest = found;
      least = largest.six_sigma * largest.six_sigma / 36.0;
      any = true;
    }
  }
  return largest;
}

}  // namespace cable_variation
