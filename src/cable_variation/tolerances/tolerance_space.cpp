#include <cable_variation/tolerances/tolerance_space.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

namespace cable_variation {
namespace {

// A direction of any number of dimensions, by rejection from the cube around the ball.
Eigen::VectorXd randomDirection(RandomRow& numbers, Eigen::Index dimensions) {
  for (;;) {
    Eigen::VectorXd point(dimensions);
    for (Eigen::Index i = 0; i < dimensions; ++i) point[i] = 2.0 * numbers.uniform() - 1.0;
    const double norm = point.norm();
    if (norm <= 1.0 && norm > 1e-3) return point / norm;
  }
}

}  // namespace

ToleranceSpace::ToleranceSpace(const Scene& scene, const std::vector<std::size_t>& variables)
    : lower_(variables.size()), upper_(variables.size()), region_of_(variables.size(), -1) {
  std::set<std::size_t> seen;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    if (variables[i] >= scene.design_variables.size()) {
      throw std::invalid_argument("design variable number " + std::to_string(variables[i]) +
                                  "; expected less than " + std::to_string(scene.design_variables.size()));
    }
    const DesignVariable& variable = scene.design_variables[variables[i]];
    if (!seen.insert(variables[i]).second)
      throw std::invalid_argument("design variable '" + variable.name + "' is given twice");
    lower_[static_cast<Eigen::Index>(i)] = variable.lower;
    upper_[static_cast<Eigen::Index>(i)] = variable.upper;
  }
  for (const ToleranceRegion& region : scene.tolerance_regions) {
    Region own{{}, region.radius};
    for (std::size_t i = 0; i < variables.size(); ++i) {
      for (const std::size_t member : region.variables) {
        if (member != variables[i]) continue;
        own.coordinates.push_back(static_cast<Eigen::Index>(i));
        region_of_[i] = static_cast<int>(regions_.size());
      }
    }
    for (const Eigen::Index i : own.coordinates) {
      lower_[i] = -region.radius;
      upper_[i] = region.radius;
    }
    if (!own.coordinates.empty()) regions_.push_back(own);
  }
}

Eigen::VectorXd ToleranceSpace::farthest(const Eigen::VectorXd& gradient,
                                         const Eigen::VectorXd& otherwise) const {
  Eigen::VectorXd point = otherwise;
  for (Eigen::Index i = 0; i < size(); ++i) {
    if (!isInterval(i) || gradient[i] == 0.0) continue;
    point[i] = gradient[i] > 0.0 ? upper_[i] : lower_[i];
  }
  for (const Region& region : regions_) {
    double squared = 0.0;
    for (const Eigen::Index i : region.coordinates) squared += gradient[i] * gradient[i];
    if (squared == 0.0) continue;
    for (const Eigen::Index i : region.coordinates)
      point[i] = region.radius * gradient[i] / std::sqrt(squared);
  }
  return point;
}

Eigen::VectorXd ToleranceSpace::drawn(RandomRow& numbers, double share_at_limits) const {
  Eigen::VectorXd point(size());
  for (Eigen::Index i = 0; i < size(); ++i) {
    const bool at_limit = numbers.uniform() < share_at_limits;
    const double share = numbers.uniform();
    point[i] = at_limit ? (share < 0.5 ? lower_[i] : upper_[i]) : lower_[i] + share * (upper_[i] - lower_[i]);
  }
  for (const Region& region : regions_) {
    const auto dimensions = static_cast<Eigen::Index>(region.coordinates.size());
    const Eigen::VectorXd direction = randomDirection(numbers, dimensions);
    const bool at_limit = numbers.uniform() < share_at_limits;
    const double share = std::pow(numbers.uniform(), 1.0 / static_cast<double>(dimensions));
    for (Eigen::Index k = 0; k < dimensions; ++k) {
      point[region.coordinates[static_cast<std::size_t>(k)]] =
          region.radius * (at_limit ? 1.0 : share) * direction[k];
    }
  }
  return point;
}

Eigen::VectorXd ToleranceSpace::random(RandomRow& numbers) const { return drawn(numbers, 0.0); }

Eigen::VectorXd ToleranceSpace::randomNearLimits(RandomRow& numbers) const { return drawn(numbers, 0.5); }

Eigen::VectorXd ToleranceSpace::offspring(const Eigen::VectorXd& first, const Eigen::VectorXd& second,
                                          RandomRow& numbers) const {
  constexpr double kFresh = 0.2, kOfFirst = 0.6, kMoved = 0.5, kStep = 0.1;
  const Eigen::VectorXd fresh = drawn(numbers, 0.5);
  // a region is taken as one: its first variable decides
  std::vector<double> choices(regions_.size()), steps(regions_.size());
  for (std::size_t i = 0; i < regions_.size(); ++i) {
    choices[i] = numbers.uniform();
    steps[i] = numbers.uniform();
  }
  Eigen::VectorXd point(size());
  for (Eigen::Index i = 0; i < size(); ++i) {
    const int region = region_of_[static_cast<std::size_t>(i)];
    const double choice = isInterval(i) ? numbers.uniform() : choices[static_cast<std::size_t>(region)];
    const double step = isInterval(i) ? numbers.uniform() : steps[static_cast<std::size_t>(region)];
    point[i] = choice < kFresh ? fresh[i] : choice < kOfFirst ? first[i] : second[i];
    if (choice >= kFresh && step < kMoved) {
      point[i] += kStep * (2.0 * numbers.uniform() - 1.0) * (upper_[i] - lower_[i]);
    }
    point[i] = std::clamp(point[i], lower_[i], upper_[i]);
  }
  for (const Region& region : regions_) {
    const double out = radiusIn(region, point) / region.radius;
    if (out <= 1.0) continue;
    for (const Eigen::Index i : region.coordinates) point[i] /= out;
  }
  return point;
}

double ToleranceSpace::radiusIn(const Region& region, const Eigen::VectorXd& deviations) {
  double squared = 0.0;
  for (const Eigen::Index i : region.coordinates) squared += deviations[i] * deviations[i];
  return std::sqrt(squared);
}

double ToleranceSpace::share(const Eigen::VectorXd& deviations) const {
  double largest = 0.0;
  for (Eigen::Index i = 0; i < size(); ++i) {
    if (!isInterval(i) || deviations[i] == 0.0) continue;
    const double limit = deviations[i] > 0.0 ? upper_[i] : lower_[i];
    const bool beyond = limit == 0.0 || (limit > 0.0) != (deviations[i] > 0.0);
    largest = std::max(largest, beyond ? std::numeric_limits<double>::infinity() : deviations[i] / limit);
  }
  for (const Region& region : regions_)
    largest = std::max(largest, radiusIn(region, deviations) / region.radius);
  return largest;
}

bool ToleranceSpace::contains(const Eigen::VectorXd& deviations, double relative_slack) const {
  for (Eigen::Index i = 0; i < size(); ++i) {
    const double slack = relative_slack * (upper_[i] - lower_[i]);
    if (!(deviations[i] >= lower_[i] - slack && deviations[i] <= upper_[i] + slack)) return false;
  }
  for (const Region& region : regions_) {
    if (!(radiusIn(region, deviations) <= region.radius * (1.0 + relative_slack))) return false;
  }
  return true;
}

}  // namespace cable_variation
