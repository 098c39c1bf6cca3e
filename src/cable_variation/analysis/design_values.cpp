#include <cable_variation/analysis/design_values.h>

#include <cmath>
#include <stdexcept>

#include <cable_variation/analysis/name_lookup.h>
#include <cable_variation/util/number_text.h>

namespace cable_variation {
namespace {

// Nothing of a harness is set further off than this: 10 km, or a hundred turns, of which rounding leaves the
// direction unknown in the end.
constexpr double kFarthest = 1e4, kMostTurns = 100.0;

void requireWithinReason(const DesignVariable& variable, double value) {
  const double most = variable.unit == "m"     ? kFarthest
                      : variable.unit == "rad" ? kMostTurns * 2.0 * M_PI
                                               : INFINITY;
  if (std::abs(value) <= most) return;
  throw std::invalid_argument("design variable '" + variable.name + "': is " + numberText(value, 6) + " " +
                              variable.unit + ", expected at most " + numberText(most, 4) + " " +
                              variable.unit + " to either side");
}

}  // namespace

DesignValues toDesignValues(const Scene& scene, const std::vector<std::string>& variables,
                            const std::vector<double>& values) {
  if (variables.size() != values.size()) {
    throw std::invalid_argument(std::to_string(variables.size()) + " variables but " +
                                std::to_string(values.size()) + " values, expected one value each");
  }
  DesignValues result;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const std::string& name = variables[i];
    const std::size_t index = indexOf(name, scene.design_variables, "design variable");
    if (!std::isfinite(values[i])) {
      throw std::invalid_argument("design variable '" + name + "': value is not finite");
    }
    requireWithinReason(scene.design_variables[index], values[i]);
    if (!result.emplace(name, values[i]).second) {
      throw std::invalid_argument("design variable '" + name + "' is given twice");
    }
  }
  return result;
}

}  // namespace cable_variation
