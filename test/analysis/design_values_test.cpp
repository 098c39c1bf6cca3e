// The values of a request, by the names of design variables.
#include <cable_variation/analysis/design_values.h>

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace cable_variation {
namespace {

Scene sceneOfVariables() {
  Scene scene;
  for (const auto& [name, unit] :
       {std::pair{"turn", "rad"}, std::pair{"shift", "m"}, std::pair{"EI", "N m^2"}}) {
    DesignVariable variable;
    variable.name = name;
    variable.unit = unit;
    scene.design_variables.push_back(variable);
  }
  return scene;
}

std::string refusal(const std::string& name, double value) {
  try {
    toDesignValues(sceneOfVariables(), {name}, {value});
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(DesignValues, FarOutOnesAreNamedWithWhatWasExpected) {
  EXPECT_EQ(refusal("turn", 1e6),
            "design variable 'turn': is 1e+06 rad, expected at most 628.3 rad to either side");
  EXPECT_EQ(refusal("turn", -1e308),
            "design variable 'turn': is -1e+308 rad, expected at most 628.3 rad to either side");
  EXPECT_EQ(refusal("shift", 2e4),
            "design variable 'shift': is 20000 m, expected at most 1e+04 m to either side");
  for (const double turn : {-600.0, 0.0, 6.3}) EXPECT_EQ(refusal("turn", turn), "") << turn;
  for (const double shift : {-9e3, 0.5}) EXPECT_EQ(refusal("shift", shift), "") << shift;
  EXPECT_EQ(refusal("EI", 1e9), "");
}

}  // namespace
}  // namespace cable_variation
