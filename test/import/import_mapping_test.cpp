// The mapping's values, and what is said of faults in it.
#include <cable_variation/import/import_mapping.h>

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "kbl_texts.h"

namespace cable_variation {
namespace {

ImportMapping mappingOf(const std::string& text) { return readImportMappingText(text, "map.yaml"); }

TEST(ImportMapping, allOfIt) {
  const ImportMapping mapping = mappingOf(
      "parts:\n"
      "  F-100: {clip: hinge, axis: z, tolerance: hole}\n"
      "types:\n"
      "  SPT: {clip: sliding_rolling}\n"
      "  splice: {clip: none}\n"
      "tolerances:\n"
      "  hole: {translate: 0.5 mm, rotate: 2 deg, arc_length: 3 mm, sigma: 4}\n"
      "  cut: {length: 5 mm}\n"
      "cable_tolerance: cut\n"
      "bundle: {sticking: 0.1, conductor_modulus: 70 GPa, wire_area: 0.35 mm^2}\n"
      "length: physical\nrest_shape: curve\nvia_spacing: 40 mm\naccuracy: 0.5 mm\n");
  KblOccurrence part;
  part.part_number = "F-100";
  part.type = "SPT";
  ASSERT_NE(mapping.ruleOf(part), nullptr);
  EXPECT_EQ(mapping.ruleOf(part)->clip, "hinge");
  EXPECT_EQ(mapping.ruleOf(part)->more, "axis: z");
  EXPECT_EQ(mapping.ruleOf(part)->constraint.rotation[2].kind, ClipFreedom::Kind::free);
  EXPECT_EQ(mapping.ruleOf(part)->tolerance, "hole");
  part.part_number = "F-200";
  EXPECT_EQ(mapping.ruleOf(part)->clip, "sliding_rolling");
  EXPECT_TRUE(mapping.ruleOf(part)->constraint.slides);
  part.type = "splice";
  EXPECT_EQ(mapping.ruleOf(part)->clip, "");
  part.type = "ring terminal";
  EXPECT_EQ(mapping.ruleOf(part), nullptr);
  const ToleranceClass& hole = mapping.tolerances.at("hole");
  EXPECT_DOUBLE_EQ(hole.translate.value(), 5e-4);
  EXPECT_DOUBLE_EQ(hole.sigma, 4.0);
  EXPECT_FALSE(hole.length);
  EXPECT_DOUBLE_EQ(mapping.tolerances.at("cut").length.value(), 5e-3);
  EXPECT_DOUBLE_EQ(mapping.bundle.sticking, 0.1);
  EXPECT_DOUBLE_EQ(mapping.bundle.conductor_modulus, 7e10);
  EXPECT_DOUBLE_EQ(mapping.bundle.wire_area, 3.5e-7);
  EXPECT_EQ(mapping.length, LengthSource::physical_length);
  EXPECT_EQ(mapping.rest_shape, ImportedRestShape::curve);
  EXPECT_EQ(mapping.given.count("bundle.sticking"), 1U);
  EXPECT_EQ(mapping.given.count("bundle.density"), 0U);
}

TEST(ImportMapping, anEmptyOneHasDefaultsAlone) {
  EXPECT_TRUE(mappingOf("").given.empty());
  EXPECT_TRUE(mappingOf("# nothing\n").parts.empty());
}

TEST(ImportMapping, grommetsHaveTheirSprings) {
  const ImportMapping mapping = mappingOf(
      "types:\n  Fixing_occurrence:\n    clip: grommet\n"
      "    stiffness: {axial: 5 N/mm, radial: 20 N/mm, torsional: 0.1 Nm/rad, conical: 0.2 Nm/rad}\n");
  KblOccurrence part;
  part.element = "Fixing_occurrence";
  ASSERT_NE(mapping.ruleOf(part), nullptr);
  EXPECT_DOUBLE_EQ(mapping.ruleOf(part)->constraint.translation[0].stiffness, 5e3);
  EXPECT_NE(mapping.ruleOf(part)->more.find("axial: 5 N/mm"), std::string::npos);
}

// The example of the documentation.
TEST(ImportMapping, theDocumentedOne) {
  const std::string page = contentsOf(findTestPackage("cable_variation") + "/doc/import.md");
  const std::size_t begin = page.find("```yaml\n") + 8;
  const ImportMapping mapping = mappingOf(page.substr(begin, page.find("```", begin) - begin));
  EXPECT_EQ(mapping.parts.size(), 2U);
  EXPECT_EQ(mapping.types.at("CABLE_DUCT").clip, "sliding_rolling");
  EXPECT_EQ(mapping.cable_tolerance, "cut");
}

// Each key and default that the page's table tells of.
TEST(ImportMapping, theDefaultsAreThoseOfTheDocumentation) {
  const ImportMapping mapping;
  EXPECT_DOUBLE_EQ(mapping.bundle.conductor_modulus, 110e9);
  EXPECT_DOUBLE_EQ(mapping.bundle.bending_modulus, 10e9);
  EXPECT_DOUBLE_EQ(mapping.bundle.sticking, 0.01);
  EXPECT_DOUBLE_EQ(mapping.bundle.density, 2500.0);
  EXPECT_DOUBLE_EQ(mapping.least_bend, 2.0);
  EXPECT_DOUBLE_EQ(mapping.via_spacing, 0.025);
  EXPECT_DOUBLE_EQ(mapping.accuracy, 1e-3);
}

TEST(ImportMapping, tablesAndRangesAreRead) {
  const ImportMapping mapping = mappingOf(
      "wires:\n  W-1: {conductor_area: 0.35 mm^2, diameter: 1.4 mm, mass_per_length: 5 g/m, EI: 1e-4}\n"
      "protections:\n  P-1: {EI: 2e-3, GJ: 1e-3}\n  TAPE: {thickness: 0.3 mm, modulus: 50 MPa}\n"
      "bundle: {sticking: 0.1, sticking_range: [0, 0.3], sticking_distribution: uniform}\nroute_limit: 20 "
      "mm\n");
  EXPECT_DOUBLE_EQ(mapping.wires.at("W-1").conductor_area.value(), 3.5e-7);
  EXPECT_DOUBLE_EQ(mapping.wires.at("W-1").EI.value(), 1e-4);
  EXPECT_FALSE(mapping.wires.at("W-1").modulus);
  KblProtection tape;
  tape.part_number = "P-1";
  tape.type = "TAPE";
  ASSERT_NE(mapping.ruleOf(tape), nullptr);
  EXPECT_DOUBLE_EQ(mapping.ruleOf(tape)->EI.value(), 2e-3);  // its number comes first
  tape.part_number = "P-2";
  ASSERT_NE(mapping.ruleOf(tape), nullptr);
  EXPECT_DOUBLE_EQ(mapping.ruleOf(tape)->thickness.value(), 3e-4);
  tape.type = "TUBE";
  EXPECT_EQ(mapping.ruleOf(tape), nullptr);
  EXPECT_DOUBLE_EQ(mapping.sticking_range.value()[1], 0.3);
  EXPECT_EQ(mapping.sticking_distribution, "uniform");
  EXPECT_DOUBLE_EQ(mapping.route_limit.value(), 0.02);
}

struct Fault {
  std::string text;
  std::vector<std::string> said;
};

TEST(ImportMapping, faultsAreToldWithLineAndExpectation) {
  const std::vector<Fault> faults{
      {"wires:\n  W-1: {area: 1 mm^2}\n", {"map.yaml:2", "wire 'W-1'", "unknown key 'area'"}},
      {"wires: [W-1]\n", {"map.yaml:1", "expected a map from part numbers"}},
      {"protections:\n  P: {thickness: 1 mm}\n", {"map.yaml:2", "expected both of thickness and modulus"}},
      {"protections:\n  P: {thickness: 1 mm, modulus: 1 MPa, EI: 1}\n", {"the ones or the others"}},
      {"bundle: {sticking: 0.5, sticking_range: [0, 0.1]}\n", {"map.yaml:1", "a range around sticking, 0.5"}},
      {"bundle: {sticking_distribution: uniform}\n", {"it goes with sticking_range"}},
      {"part:\n  F-100: {clip: fixed}\n", {"map.yaml:1", "part", "did you mean 'parts'"}},
      {"parts:\n  F-100: {clip: fixt}\n", {"map.yaml:2", "part 'F-100'", "fixt", "fixed"}},
      {"parts:\n  F-100: {tolerance: a}\n", {"map.yaml:2", "part 'F-100'", "'clip' is missing"}},
      {"parts:\n  F-100: {clip: fixed, tolerance: hole}\ntolerances:\n  hale: {translate: 1 mm}\n",
       {"map.yaml:2", "F-100", "no tolerance 'hole'", "did you mean 'hale'"}},
      {"parts:\n  F-100: {clip: hinge}\n", {"map.yaml:2", "part 'F-100'", "'axis' is missing"}},
      {"parts:\n  F-100: {clip: fixed, axis: z}\n", {"map.yaml:2", "part 'F-100'", "axis"}},
      {"parts: [F-100]\n", {"map.yaml:1", "a map from part"}},
      {"tolerances:\n  hole: {translate: 2 deg}\n", {"map.yaml:2", "tolerance 'hole'", "a length"}},
      {"tolerances:\n  hole: {translate: 0}\n", {"map.yaml:2", "more than 0"}},
      {"bundle:\n  sticking: 2\n", {"map.yaml:2", "sticking", "between 0 and 1"}},
      {"bundle: {stiffness: 2}\n", {"map.yaml:1", "stiffness"}},
      {"rest_shape: bent\n", {"map.yaml:1", "bent", "straight"}},
      {"cable_tolerance: cut\n", {"map.yaml:1", "no tolerance 'cut'"}},
      {"- a\n", {"map.yaml:1", "no mapping"}},
      {"parts: {a\n", {"map.yaml:"}},
  };
  for (const Fault& fault : faults) {
    std::string said;
    try {
      mappingOf(fault.text);
    } catch (const SceneError& error) {
      said = error.what();
    }
    for (const std::string& part : fault.said)
      EXPECT_NE(said.find(part), std::string::npos) << "no '" << part << "' in: " << said << "\nof:\n"
                                                    << fault.text;
  }
}

}  // namespace
}  // namespace cable_variation
