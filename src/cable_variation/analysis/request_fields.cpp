#include <cable_variation/analysis/request_fields.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <sstream>

#include <cable_variation/analysis/name_lookup.h>

namespace cable_variation {

void refuse(const std::string& field, double value, const std::string& expected) {
  std::ostringstream text;
  text << field << ": is " << value << ", expected " << expected;
  throw std::invalid_argument(text.str());
}

std::vector<std::size_t> variedVariables(const std::vector<std::string>& names, const Scene& scene,
                                         const std::string& or_else) {
  if (names.empty()) {
    throw std::invalid_argument(
        "variables: is empty, expected names of design variables, or ['*'] for all of the scene" + or_else);
  }
  if (names != std::vector<std::string>{"*"}) {
    return indicesOf(names, scene.design_variables, "design variable");
  }
  if (scene.design_variables.empty()) {
    throw std::invalid_argument("variables: ['*'], but the scene has no design variables");
  }
  std::vector<std::size_t> all(scene.design_variables.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

std::vector<std::size_t> playedMotions(const std::vector<std::string>& names, const Scene& scene) {
  std::vector<std::size_t> motions = indicesOf(names, scene.motions, "motion");
  std::set<std::string> moved;
  for (const std::size_t index : motions) {
    const Motion& motion = scene.motions[index];
    if (motion.samples.empty()) throw std::invalid_argument("motion '" + motion.name + "': has no poses");
    if (!moved.insert(motion.component).second) {
      throw std::invalid_argument("motions: two of them move component '" + motion.component +
                                  "', expected one");
    }
  }
  return motions;
}

TimeSpan timesOf(const std::vector<std::size_t>& motions, double from, double to, const Scene& scene) {
  if (motions.empty()) {
    if (from != 0.0) refuse("from_time", from, "0 without motions");
    if (to != 0.0) refuse("to_time", to, "0 without motions");
    return {};
  }
  double end = 0.0;
  for (const std::size_t index : motions) end = std::max(end, scene.motions[index].duration());
  std::ostringstream bounds;
  bounds << " to " << end << " s, the end of the motions";
  if (!(from >= 0.0 && from <= end)) refuse("from_time", from, "0" + bounds.str());
  TimeSpan span{from, to};
  if (to == 0.0) span.to = end;
  if (to < 0.0) span.to = from;
  if (!(span.to >= from && span.to <= end)) refuse("to_time", to, "from_time" + bounds.str());
  return span;
}

}  // namespace cable_variation
