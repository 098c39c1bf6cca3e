#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>

#include <cable_variation/scene/correlation_matrix.h>
#include <cable_variation/scene_file/read_context.h>

namespace cable_variation {
namespace {

const ToleranceRegion* regionOf(const Scene& scene, std::size_t variable) {
  for (const ToleranceRegion& region : scene.tolerance_regions) {
    const auto& all = region.variables;
    if (std::find(all.begin(), all.end(), variable) != all.end()) return &region;
  }
  return nullptr;
}

// Nothing unless there are two.
std::optional<Correlation> readVariables(const YamlCursor& list, const ReadContext& context) {
  std::vector<std::size_t> pair;
  for (const YamlCursor& item : list.items(2)) {
    const std::size_t variable = context.design_variables.find(item);
    if (variable == NameTable::npos) continue;
    if (const ToleranceRegion* region = regionOf(context.scene, variable)) {
      item.fail("it belongs to the region '" + region->name + "'; expected a variable of its own");
    }
    pair.push_back(variable);
  }
  if (pair.size() != 2) return {};
  if (pair[0] == pair[1]) {
    list.fail("found one variable twice; expected two");
    return {};
  }
  for (const Correlation& other : context.scene.correlations) {
    if ((other.first == pair[0] && other.second == pair[1]) ||
        (other.first == pair[1] && other.second == pair[0])) {
      list.fail("their correlation is there already");
    }
  }
  return Correlation{pair[0], pair[1], 0.0};
}

}  // namespace

void readCorrelations(const YamlCursor& list, ReadContext& context) {
  const std::size_t before = context.faults.count();
  for (const YamlCursor& item : list.items()) {
    if (!item.checkKeys({"variables", "coefficient"})) continue;
    const auto variables = item.require("variables");
    auto correlation = variables ? readVariables(*variables, context) : std::nullopt;
    const double coefficient = item.number("coefficient", quantity::number);
    if (std::abs(coefficient) >= 1.0) {
      item.find("coefficient")
          ->fail("found " + shortNumber(coefficient) + "; expected more than -1 and less than 1");
    }
    if (!correlation) continue;
    correlation->coefficient = coefficient;
    context.scene.correlations.push_back(*correlation);
  }
  if (context.faults.count() > before) return;
  std::vector<std::size_t> all(context.scene.design_variables.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  try {
    correlationMatrix(context.scene, all);
  } catch (const std::invalid_argument& error) {
    list.fail(error.what());
  }
}

}  // namespace cable_variation
