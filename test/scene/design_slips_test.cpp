// Implausible edits of a design are warned of, plausible ones are not.
#include <cable_variation/scene/design_slips.h>

#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <cable_variation/scene_file/scene_reader.h>

#include "test_packages.h"

namespace cable_variation {
namespace {

Design hoseAndBracket() {
  const TemporaryFile file(
      "design_slips.yaml",
      {"components:", "  - {name: engine, pose: {position: [0.25, 0, 0]}}",
       "cables:", "  - {name: hose, length: 300 mm, section: {type: solid, radius: 5 mm,",
       "     material: {young_modulus: 10 MPa, poisson_ratio: 0.4, density: 1200}}}",
       "clips:", "  - {name: A, type: fixed, cable: hose, at: start, pose: {position: [0, 0, 0]}}",
       "  - {name: B, type: fixed, cable: hose, at: end, component: engine, pose: {position: [0, 0, 0]}}",
       "design_variables:", "  - {name: b_y, clip: B, translate: y, tolerance: 5 mm}",
       "  - {name: b_rz, clip: B, rotate: z, tolerance: 5 deg}",
       "  - {name: engine_z, component: engine, translate: z, tolerance: 5 mm}",
       "  - {name: engine_rx, component: engine, rotate: x, tolerance: 2 deg}",
       "  - {name: hose_length, cable: hose, property: length, tolerance: 5 mm}",
       "  - {name: hose_radius, cable: hose, property: radius, tolerance: 10 %}",
       "  - {name: hose_EI, cable: hose, property: EI, tolerance: 10 %}",
       "  - {name: hose_GJ, cable: hose, property: GJ, tolerance: 10 %}",
       "  - {name: hose_EA, cable: hose, property: EA, tolerance: 10 %}"});
  return {readScene(file.path(), findTestPackage), {}};
}

using Texts = std::vector<std::string>;

Texts slipsAfter(const std::string& variable, double value) {
  const Design before = hoseAndBracket();
  Design edited = before;
  setNominal(edited, variable, value);
  return newSlips(before, edited);
}

struct Case {
  const char* variable;
  double value;
  const char* text;  // part of the only warning
};

TEST(DesignSlips, AreTold) {
  for (const Case& each :
       {Case{"b_y", 5.0, "design variable 'b_y': it is 5 m, where the longest cable has 0.3 m; in mm?"},
        Case{"engine_z", -12.0, "design variable 'engine_z': it is -12 m, where"},
        Case{"b_rz", 5.0, "design variable 'b_rz': it is 5 rad, which is 286.479 deg; in deg?"},
        Case{"engine_rx", -45.0, "design variable 'engine_rx': it is -45 rad"},
        Case{"hose_length", 310.0, "cable 'hose': 310 m of it are between clips that are 0.25 m apart"},
        Case{"hose_radius", 0.2, "cable 'hose': it is 0.4 m thick and 0.3 m long; in mm"},
        Case{"hose_EI", 4900.0, "cable 'hose': EI is 4900 N m^2; expected between"},
        Case{"hose_GJ", 3500.0, "cable 'hose': GJ is 3500 N m^2; expected between"},
        Case{"hose_EA", 0.01, "cable 'hose': EA is 0.01 N; expected between"}}) {
    const Texts slips = slipsAfter(each.variable, each.value);
    bool told = false;
    for (const std::string& slip : slips) told = told || slip.find(each.text) != std::string::npos;
    EXPECT_TRUE(told) << each.variable << ": " << testing::PrintToString(slips);
  }
}

// Designs that somebody tries: anywhere near what is there, far beyond the tolerances too.
TEST(DesignSlips, NothingIsSaidOfWhatMayBeMeant) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  const Design before = hoseAndBracket();
  for (int i = 0; i < 200; ++i) {
    Design edited = before;
    setNominal(edited, "b_y", 0.1 * share(random));
    setNominal(edited, "engine_z", 0.1 * share(random));
    setNominal(edited, "b_rz", M_PI * share(random));
    setNominal(edited, "engine_rx", 1.5 * share(random));
    setCableLength(edited, "hose", 0.6 + 0.3 * share(random));
    const DesignVariable& EI = edited.scene.design_variables[6];
    setNominal(edited, "hose_EI", EI.nominal * std::exp(2.0 * share(random)));
    EXPECT_EQ(newSlips(before, edited), Texts());
  }
  EXPECT_EQ(turnSlip(M_PI), "");
  EXPECT_EQ(turnSlip(-4.0 * M_PI), "");  // counted turns
  EXPECT_EQ(turnSlip(1.0), "");
}

TEST(DesignSlips, OfAClipThatIsMovedAndOfOneThatWasFarBefore) {
  Design design = hoseAndBracket();
  moveClip(design, "B", {0.0, 20.0, 0.0}, Eigen::Vector3d::Zero());
  const Texts slips = newSlips(hoseAndBracket(), design);
  ASSERT_EQ(slips.size(), 1u);
  EXPECT_NE(slips[0].find("clip 'B': it is 20.0016 m from clip 'A'"), std::string::npos) << slips[0];
  EXPECT_EQ(newSlips(design, design), Texts());
  EXPECT_NE(shiftSlip(design.scene, 20.0), "");
  EXPECT_EQ(shiftSlip(design.scene, 0.02), "");
}

}  // namespace
}  // namespace cable_variation
