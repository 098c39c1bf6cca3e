#include <command/scene_json.h>

#include <cable_variation/scene/target_name.h>

namespace cable_variation_command {

using cable_variation::DesignVariable;
using cable_variation::Measure;
using cable_variation::MeasureValue;
using cable_variation::Scene;

namespace {

Json variableJson(const DesignVariable& variable, double nominal, const Scene& scene) {
  const cable_variation::TargetName target = nameOf(variable.target, scene);
  Json json = Json::object();
  json.set("name", variable.name).set("kind", target.kind).set("target", target.target);
  json.set("member", target.member).set("unit", variable.unit).set("nominal", nominal);
  json.set("lower", variable.lower).set("upper", variable.upper).set("distribution", variable.distribution);
  return json;
}

}  // namespace

Json measureJson(const Measure& measure) {
  Json json = Json::object();
  json.set("name", measure.name).set("type", toString(measure.type)).set("unit", measure.unit);
  if (!measure.segment.empty()) json.set("segment", measure.segment);
  json.set("has_lower", measure.lower.has_value()).set("lower", measure.lower.value_or(0.0));
  json.set("has_upper", measure.upper.has_value()).set("upper", measure.upper.value_or(0.0));
  return json;
}

Json measureJson(const Measure& measure, const MeasureValue& value, const Scene& scene) {
  Json json = measureJson(measure);
  json.set("value", value.value).set("within", withinLimits(measure, value.value)).set("note", value.note);
  json.set("unique", value.unique).set("has_place", value.has_place);
  const Eigen::Vector3d nowhere = Eigen::Vector3d::Zero();
  json.set("cable", value.has_place ? scene.harness.cables[value.cable].name : "");
  json.set("arc_length", value.has_place ? value.arc_length : 0.0);
  json.set("point", value.has_place ? value.point : nowhere).set("has_other", value.has_other);
  return json.set("other", value.has_other ? value.other : nowhere);
}

Json variablesJson(const Scene& scene, const std::vector<std::size_t>& variables,
                   const cable_variation::DesignValues& values) {
  Json list = Json::array();
  for (const std::size_t index : variables) {
    const DesignVariable& variable = scene.design_variables[index];
    const auto given = values.find(variable.name);
    list.add(variableJson(variable, given != values.end() ? given->second : variable.nominal, scene));
  }
  return list;
}

Json boxJson(const cable_variation::Box& box) {
  const Eigen::Vector3d low = box.low.matrix(), high = box.high.matrix();
  return Json::object().set("low", low).set("high", high);
}

Json faultsJson(const std::vector<cable_variation::SceneFault>& faults) {
  Json list = Json::array();
  for (const cable_variation::SceneFault& fault : faults)
    list.add(Json::object().set("file", fault.file).set("line", fault.line).set("message", fault.message));
  return list;
}

}  // namespace cable_variation_command
