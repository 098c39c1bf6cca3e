#pragma once

// The shipped harness case, with as many variables as a benchmark asks for.

#include <cmath>
#include <string>

#include <cable_variation/scene_file/scene_reader.h>

namespace cable_variation::bench {

constexpr double kDegree = M_PI / 180.0;

inline Scene shippedCase(const std::string& name) {
  const std::string root = CABLE_VARIATION_SOURCE_DIR;
  return readScene(root + "/config/" + name + ".yaml", [&](const std::string&) { return root; });
}

inline DesignVariable variableOf(const DesignTarget& target, const std::string& name, double nominal,
                                 double tolerance) {
  DesignVariable variable;
  variable.name = name;
  variable.target = target;
  variable.nominal = nominal;
  variable.lower = -tolerance;
  variable.upper = tolerance;
  variable.distribution_parameters["sigma"] = 3.0;
  return variable;
}

/// The harness with 30 variables: its own ten, and clips, stiffnesses, weights and components.
inline Scene harnessOfThirtyVariables() {
  Scene scene = shippedCase("harness");
  auto& variables = scene.design_variables;
  const auto add = [&](const DesignTarget& target, double nominal, double tolerance) {
    if (variables.size() < 30) {
      variables.push_back(
          variableOf(target, "variable_" + std::to_string(variables.size()), nominal, tolerance));
    }
  };
  for (std::size_t clip = 0; clip < scene.harness.clips.size(); ++clip) {
    for (Axis axis : {Axis::x, Axis::y, Axis::z}) add(ClipTranslation{clip, axis}, 0.0, 1e-3);
  }
  using Property = CableProperty::Property;
  for (std::size_t cable = 0; cable < scene.harness.cables.size(); ++cable) {
    const Section& section = scene.harness.cables[cable].sections.front().section;
    add(CableProperty{cable, Property::EI}, section.EI_y, 0.1 * section.EI_y);
    add(CableProperty{cable, Property::GJ}, section.GJ, 0.1 * section.GJ);
    add(CableProperty{cable, Property::density}, section.mass_per_length, 0.1 * section.mass_per_length);
  }
  for (Axis axis : {Axis::x, Axis::y, Axis::z}) {
    add(ComponentRotation{1, axis}, 0.0, 1.0 * kDegree);
    add(ComponentTranslation{0, axis}, 0.0, 1e-3);
  }
  return scene;
}

}  // namespace cable_variation::bench
