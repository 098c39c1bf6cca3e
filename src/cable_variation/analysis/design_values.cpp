#include <cable_variation/analysis/design_values.h>

#include <cmath>
#include <stdexcept>

#include <cable_variation/analysis/name_lookup.h>

namespace cable_variation {

DesignValues toDesignValues(const Scene& scene, const std::vector<std::string>& variables,
                            const std::vector<double>& values) {
  if (variables.size() != values.size()) {
    throw std::invalid_argument(std::to_string(variables.size()) + " variables but " +
                                std::to_string(values.size()) + " values, expected one value each");
  }
  DesignValues result;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const std::string& name = variables[i];
    indexOf(name, scene.design_variables, "design variable");
    if (!std::isfinite(values[i])) {
      throw std::invalid_argument("design variable '" + name + "': value is not finite");
    }
    if (!result.emplace(name, values[i]).second) {
      throw std::invalid_argument("design variable '" + name + "' is given twice");
    }
  }
  return result;
}

}  // namespace cable_variation
