#include <cable_variation/envelope/clearance/clearance_limit.h>

#include <algorithm>

#include <cable_variation/scene/measure_traits.h>
#include <cable_variation/scene/moving_components.h>

namespace cable_variation {

namespace {

bool contains(const std::vector<std::size_t>& all, std::size_t each) {
  return std::find(all.begin(), all.end(), each) != all.end();
}

}  // namespace

bool isOf(const Measure& measure, const EnvelopeClearance& clearance, const Scene& scene) {
  if (!traitsOf(measure.type).clearance) return false;
  if (!clearance.other) {
    if (!measure.component || !contains(measure.cables, clearance.cable)) return false;
    const std::vector<std::size_t> bodies = bodiesOf(scene, *measure.component);
    return std::any_of(bodies.begin(), bodies.end(),
                       [&](std::size_t body) { return scene.components[body].name == clearance.component; });
  }
  return (contains(measure.cables, clearance.cable) && contains(measure.other_cables, *clearance.other)) ||
         (contains(measure.cables, *clearance.other) && contains(measure.other_cables, clearance.cable));
}

std::optional<double> lowerLimit(const Scene& scene, const EnvelopeClearance& clearance) {
  std::optional<double> limit;
  for (const Measure& measure : scene.measures) {
    if (!measure.lower || !isOf(measure, clearance, scene)) continue;
    limit = std::max(limit.value_or(*measure.lower), *measure.lower);
  }
  return limit;
}

}  // namespace cable_variation
