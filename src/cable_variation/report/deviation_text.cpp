#include <cable_variation/report/deviation_text.h>

#include <algorithm>
#include <cmath>

#include <cable_variation/report/markup.h>
#include <cable_variation/util/display_unit.h>

namespace cable_variation {

std::string deviationText(const Scene& scene, const std::vector<std::size_t>& variables,
                          const Eigen::VectorXd& deviations) {
  constexpr double kLeast = 0.02;  // of the tolerance
  std::vector<std::pair<double, std::string>> shares;
  for (std::size_t j = 0; j < variables.size() && static_cast<Eigen::Index>(j) < deviations.size(); ++j) {
    const DesignVariable& variable = scene.design_variables[variables[j]];
    const double deviation = deviations[static_cast<Eigen::Index>(j)];
    const double limit = deviation > 0.0 ? variable.upper : -variable.lower;
    if (!(limit > 0.0 && std::abs(deviation) > kLeast * limit)) continue;
    const DisplayUnit unit = displayUnit(variable.unit);
    shares.emplace_back(std::abs(deviation) / limit, variable.name + " " + (deviation > 0.0 ? "+" : "") +
                                                         figure(unit.factor * deviation, 3) +
                                                         (unit.symbol.empty() ? "" : " " + unit.symbol));
  }
  std::stable_sort(shares.begin(), shares.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::string text;
  for (const auto& share : shares) text += (text.empty() ? "" : ", ") + share.second;
  return text.empty() ? "nothing off the design" : text;
}

}  // namespace cable_variation
