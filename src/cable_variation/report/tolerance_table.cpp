#include <cable_variation/report/tolerance_table.h>

#include <algorithm>
#include <cmath>

#include <cable_variation/report/markup.h>
#include <cable_variation/report/stability_tables.h>
#include <cable_variation/tolerances/tolerances.h>
#include <cable_variation/util/display_unit.h>

namespace cable_variation {

namespace {

template <typename... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <typename... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

std::string axisName(Axis axis) { return std::string(1, "xyz"[static_cast<int>(axis)]); }

std::string propertyText(CableProperty::Property property) {
  using Property = CableProperty::Property;
  switch (property) {
    case Property::length:
      return "length";
    case Property::radius:
      return "radius";
    case Property::EI:
      return "bending stiffness EI";
    case Property::GJ:
      return "torsional stiffness GJ";
    case Property::EA:
      return "stretching stiffness EA";
    case Property::density:
      return "weight";
    case Property::rest_curvature:
      return "rest curvature";
  }
  return "";
}

std::string signedFigure(double value) { return (value > 0.0 ? "+" : "") + figure(value); }

std::string toleranceText(const DesignVariable& variable, double factor) {
  if (variable.lower == -variable.upper) return "±" + figure(factor * variable.upper);
  return signedFigure(factor * variable.lower) + " … " + signedFigure(factor * variable.upper);
}

}  // namespace

std::string targetText(const Scene& scene, const DesignTarget& target) {
  const auto clip = [&](std::size_t i) { return "clip " + scene.harness.clips[i].name; };
  const auto part = [&](std::size_t i) { return "part " + scene.components[i].name; };
  return std::visit(
      Overloaded{
          [&](const ClipTranslation& t) { return clip(t.clip) + " along its " + axisName(t.axis); },
          [&](const ClipRotation& t) { return clip(t.clip) + " about its " + axisName(t.axis); },
          [&](const ClipArcLength& t) { return clip(t.clip) + ", place along the cable"; },
          [&](const CableProperty& t) {
            return "cable " + scene.harness.cables[t.cable].name + ", " + propertyText(t.property);
          },
          [&](const BreakoutArcLength& t) {
            return "joint " + scene.harness.joints[t.joint].name + ", place along the cable";
          },
          [&](const ComponentTranslation& t) { return part(t.component) + " along its " + axisName(t.axis); },
          [&](const ComponentRotation& t) { return part(t.component) + " about its " + axisName(t.axis); },
          [&](const LocatorDeviation& t) {
            return part(t.component) + ", locator " + std::to_string(t.locator);
          }},
      target);
}

std::string distributionText(const DesignVariable& variable) {
  std::string text = variable.distribution;
  for (const auto& [key, value] : variable.distribution_parameters) {
    const bool is_quantity = key == "mode" || key == "scale";
    const DisplayUnit unit = is_quantity ? displayUnit(variable.unit) : DisplayUnit();
    text += key == "sigma" ? ", limits at " + figure(value) + " σ"
                           : ", " + key + " " + figure(unit.factor * value) +
                                 (unit.symbol.empty() ? "" : " " + unit.symbol);
  }
  if (!variable.distribution_values.empty()) {
    text += ", " + std::to_string(variable.distribution_values.size()) + " values";
  }
  return text;
}

ReportTable toleranceTable(const Scene& scene, const std::vector<std::size_t>& variables,
                           const DesignValues& values) {
  ReportTable table{"", {"variable", "nominal", "tolerance", "σ", "unit", "distribution", "of"}, {}};
  const Spread spread = spreadOf(scene, variables);
  for (std::size_t j = 0; j < variables.size(); ++j) {
    const DesignVariable& variable = scene.design_variables[variables[j]];
    const DisplayUnit unit = displayUnit(variable.unit);
    const auto k = static_cast<Eigen::Index>(j);
    ReportCell nominal = plain(figure(unit.factor * nominalValue(variable, values), 5));
    if (nominalValue(variable, values) != variable.nominal)
      nominal.text += " (scene: " + figure(unit.factor * variable.nominal, 5) + ")";
    table.rows.push_back({plain(variable.name), nominal, plain(toleranceText(variable, unit.factor)),
                          plain(figure(unit.factor * std::sqrt(spread.covariance(k, k)))), plain(unit.symbol),
                          plain(distributionText(variable)), plain(targetText(scene, variable.target))});
  }
  return table;
}

std::vector<std::string> toleranceNotes(const Scene& scene, const std::vector<std::size_t>& variables) {
  const auto has = [&](std::size_t each) {
    return std::find(variables.begin(), variables.end(), each) != variables.end();
  };
  std::vector<std::string> notes;
  for (const ToleranceRegion& region : scene.tolerance_regions) {
    if (!std::any_of(region.variables.begin(), region.variables.end(), has)) continue;
    std::string names;
    for (const std::size_t each : region.variables) {
      names += (names.empty() ? "" : ", ") + scene.design_variables[each].name;
    }
    const char* const shape = region.shape == ToleranceRegion::Shape::ball   ? "ball"
                              : region.shape == ToleranceRegion::Shape::disc ? "disc"
                                                                             : "cone";
    const DisplayUnit unit = displayUnit(region.shape == ToleranceRegion::Shape::cone ? "rad" : "m");
    notes.push_back(region.name + ": " + names + " stay together within a " + shape + " of " +
                    figure(unit.factor * region.radius) + " " + unit.symbol + ".");
  }
  for (const Correlation& each : scene.correlations) {
    if (!has(each.first) || !has(each.second)) continue;
    notes.push_back(scene.design_variables[each.first].name + " and " +
                    scene.design_variables[each.second].name + " are correlated by " +
                    figure(each.coefficient) + ".");
  }
  return notes;
}

}  // namespace cable_variation
