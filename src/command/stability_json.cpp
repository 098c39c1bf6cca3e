#include <command/stability_json.h>

#include <utility>

#include <command/scene_json.h>

namespace cable_variation_command {

using cable_variation::ComponentVariation;
using cable_variation::LowHigh;
using cable_variation::Scene;
using cable_variation::StabilityAnalysis;
using cable_variation::StabilityOptions;

namespace {

Json componentsJson(const Scene& scene, const StabilityOptions& options,
                    const std::vector<ComponentVariation>& components) {
  const cable_variation::ComponentPoses poses = componentPosesAt(scene, options.values, options.moved);
  Json list = Json::array();
  for (const ComponentVariation& variation : components) {
    const std::string& name = scene.components[variation.component].name;
    const cable_variation::PointVariation most = largestVariation(scene, variation, poses.at(name));
    Json json = Json::object();
    json.set("component", name).set("largest_six_sigma", most.six_sigma).set("at", most.point);
    list.add(json.set("direction", most.direction).set("mean_shift", most.mean_shift));
  }
  return list;
}

Json snapsJson(const Scene& scene, const StabilityAnalysis& analysis) {
  Json list = Json::array();
  for (const cable_variation::SnapWithin& snap : analysis.snaps) {
    Json json = Json::object();
    json.set("variable", scene.design_variables[snap.variable].name).set("deviation", snap.deviation);
    json.set("jump", snap.jump).set("cable", scene.harness.cables[snap.cable].name);
    list.add(json.set("arc_length", snap.arc_length));
  }
  return list;
}

}  // namespace

Json stabilityJson(const Scene& scene, const StabilityOptions& options, const StabilityAnalysis& analysis,
                   const std::vector<ComponentVariation>& components) {
  Json measures = Json::array(), low = Json::array(), high = Json::array();
  for (std::size_t i = 0; i < analysis.measures.size(); ++i)
    measures.add(measureJson(scene.measures[analysis.measures[i]], analysis.values[i], scene));
  for (const std::vector<LowHigh>& row : analysis.low_high) {
    for (const LowHigh& each : row) {
      low.add(each.low);
      high.add(each.high);
    }
  }
  Json json = Json::object();
  json.set("variables", variablesJson(scene, analysis.variables, options.values));
  json.set("variable_sigma", analysis.variable_sigma).set("measures", std::move(measures));
  json.set("undefined", analysis.undefined).set("jacobian", rowByRow(analysis.jacobian));
  json.set("contribution", rowByRow(analysis.contribution)).set("low", std::move(low));
  json.set("high", std::move(high)).set("one_sided", analysis.one_sided);
  json.set("mean_shift", analysis.mean_shift).set("sigma", analysis.sigma);
  json.set("worst_low", analysis.worst_low).set("worst_high", analysis.worst_high);
  json.set("smallest_eigenvalue", analysis.nominal.smallest_eigenvalue);
  json.set("eigenvalue_low", analysis.eigenvalue_low).set("eigenvalue_high", analysis.eigenvalue_high);
  json.set("snaps", snapsJson(scene, analysis)).set("coupling", toString(analysis.coupling));
  json.set("warnings", analysis.warnings).set("components", componentsJson(scene, options, components));
  return json.set("linear_time", analysis.linear_time).set("resolve_time", analysis.resolve_time);
}

}  // namespace cable_variation_command
