#pragma once

#include <memory>

#include <cable_variation/scene/scene.h>

namespace cable_variation {

/// How production spreads one design variable: deviations from its nominal
/// value, in its SI unit.
class Distribution {
 public:
  virtual ~Distribution() = default;
  virtual double mean() const = 0;
  virtual double standardDeviation() const = 0;
  virtual double cdf(double deviation) const = 0;
  /// The deviation below which a share `probability` in (0, 1) lies.
  virtual double quantile(double probability) const = 0;
};

/// Throws std::invalid_argument naming the variable, the parameter, its value and what was expected.
std::unique_ptr<const Distribution> makeDistribution(const DesignVariable& variable);

}  // namespace cable_variation
