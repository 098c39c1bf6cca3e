// A branch that hangs from a cable which is free to roll: upright it is a saddle, however light.

#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/scene/scene.h>
#include <cable_variation/scene_file/scene_reader.h>

#include "test_packages.h"

namespace cable_variation {
namespace {

Harness rollingWithBranch(double mass_per_length, const std::string& pitch) {
  std::ostringstream text;
  text << R"(cables:
  - {name: a, length: 0.25, stiffness: {EA: 1000, GA: 500, EI: 0.02, GJ: 0.016, mass_per_length: 0.05, radius: 0.004}}
  - {name: b, length: 0.05, stiffness: {EA: 1000, GA: 500, EI: 0.02, GJ: 0.015, radius: 0.004, mass_per_length: )"
       << mass_per_length << R"(}}
clips:
  - {name: c1, type: rolling, cable: a, at: start, pose: {position: [0, 0, 0]}}
  - {name: c2, type: rolling, cable: a, at: end, pose: {position: [0.25, 0, 0]}}
  - {name: f, type: free, cable: b, at: end}
joints:
  - {name: j, type: fixed, parent: a, at: 0.1, child: b, rotation: {rpy: [0, )"
       << pitch << R"(, 0]}}
)";
  return readSceneText(text.str(), "scene.yaml", findTestPackage).harness;
}

class UprightBranch : public testing::TestWithParam<double> {};

TEST_P(UprightBranch, IsNeverToldToBeStable) {
  for (const char* pitch : {"-90 deg", "90 deg", "-60 deg"}) {
    const Equilibrium found = EquilibriumSolver().solve(rollingWithBranch(GetParam(), pitch));
    if (!found.converged()) {
      EXPECT_FALSE(found.message.empty());
      continue;
    }
    const bool neutral = !found.notes.empty();
    EXPECT_TRUE(neutral || found.smallest_eigenvalue > 0.0) << pitch;
    if (neutral) continue;
    const CableShape& branch = found.shapes[1];
    EXPECT_LT(branch.position(0.05).z(), branch.position(0.0).z()) << pitch << " " << GetParam();
  }
}

INSTANTIATE_TEST_SUITE_P(Masses, UprightBranch, testing::Values(2e-5, 5e-5, 1e-4, 3e-4, 1e-3, 1e-2, 0.1));

}  // namespace
}  // namespace cable_variation
