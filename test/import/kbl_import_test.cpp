// A harness as a scene: it loads without faults, its cables lie where the centre curves do, and it solves.
#include <cable_variation/import/kbl_import.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/import/bundle_section.h>
#include <cable_variation/import/segment_curve.h>

#include "kbl_texts.h"

namespace cable_variation {
namespace {

using Eigen::Vector3d;
using Kind = ImportFinding::Kind;

ImportResult importOf(const std::string& text, const std::string& mapping = "") {
  return importKbl(readKblText(text, "small.kbl"), readImportMappingText(mapping, "map.yaml"));
}

template <class Named>
const Named& named(const std::vector<Named>& things, const std::string& name) {
  for (const Named& thing : things) {
    if (thing.name == name) return thing;
  }
  throw std::out_of_range(name);
}

// The one finding of a kind; none of that kind: a failure.
ImportFinding findingOf(const ImportResult& result, Kind kind) {
  for (const ImportFinding& finding : result.findings) {
    if (finding.kind == kind) return finding;
  }
  ADD_FAILURE() << "there is no finding '" << toString(kind) << "'";
  return {};
}

TEST(KblImport, segmentsBecomeCablesAndJoints) {
  const ImportResult result = importOf(smallKbl());
  EXPECT_TRUE(result.findings.empty());
  const Scene scene = sceneOf(sceneText(result.draft));
  EXPECT_TRUE(scene.warnings.empty());
  ASSERT_EQ(scene.harness.cables.size(), 3U);
  const Cable& trunk = named(scene.harness.cables, "Segment_1");
  EXPECT_NEAR(trunk.length, 0.2 + 0.301988168, 1e-9);
  ASSERT_EQ(scene.harness.joints.size(), 2U);
  for (const Joint& joint : scene.harness.joints) EXPECT_NEAR(joint.parent_arc_length, 0.2, 1e-9);
  ASSERT_EQ(scene.harness.clips.size(), 4U);  // the splice has none
  EXPECT_LT((named(scene.harness.clips, "CLIP.1").pose.position - Vector3d(0.35, 0.0, -0.015)).norm(), 1e-8);
  EXPECT_LT((named(scene.harness.clips, "XC.1").pose.position - Vector3d(0.2, 0.15, 0.0)).norm(), 1e-8);
  // components are where the parts are placed
  EXPECT_LT((named(scene.components, "XB.1").pose.position - Vector3d(0.508, 0.0, 0.0)).norm(), 1e-8);
}

// The frames that clips hold and joints turn by fit each other without torsion: at each joint the child's
// frame is the one that its own clip has, transported along its (straight) way.
TEST(KblImport, framesFitEachOther) {
  const Scene scene = sceneOf(sceneText(importOf(smallKbl()).draft));
  const Clip& ground = named(scene.harness.clips, "XC.1");
  for (const Joint& joint : scene.harness.joints) {
    if (scene.harness.cables[joint.child].name != "Segment_3") continue;
    const Vector3d x(1.0, 0.0, 0.0);
    const Clip& start = named(scene.harness.clips, "XA.1");
    // along the straight segment 1 the frame is that of its clip; the kink of half its angle is next
    const Vector3d kink =
        start.pose.orientation * x + Vector3d(std::cos(std::atan(0.2)), 0.0, -std::sin(std::atan(0.2)));
    const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(start.pose.orientation * x, kink);
    const Eigen::Quaterniond child = turn * start.pose.orientation * joint.rotation;
    EXPECT_LT(child.angularDistance(ground.pose.orientation), 1e-6);
    return;
  }
  FAIL() << "Segment_3 hangs on nothing";
}

TEST(KblImport, wiresAndTapeAreTheCablesMass) {
  const Scene scene = sceneOf(sceneText(importOf(smallKbl()).draft));
  // segment 1: two thin wires and the multicore one; segment 2: thin, thick, multicore and tape on one half
  const Cable& trunk = named(scene.harness.cables, "Segment_1");
  EXPECT_NEAR(sectionAt(trunk, 0.1).mass_per_length, 0.007 + 0.007 + 0.030, 1e-9);
  EXPECT_NEAR(sectionAt(trunk, 0.3).mass_per_length, 0.007 + 0.028 + 0.030 + 0.5 * 0.004, 1e-9);
  EXPECT_NEAR(sectionAt(trunk, 0.1).EA, 1.1e11 * (0.5 + 0.5 + 2.0) * 1e-6, 1.0);
  EXPECT_NEAR(sectionAt(trunk, 0.1).radius, 0.004, 1e-8);
}

TEST(KblImport, theSmallHarnessSolvesAlongItsCurves) {
  for (const char* shape : {"straight", "curve"}) {
    const ImportResult result = importOf(smallKbl(), std::string("rest_shape: ") + shape);
    const Scene scene = sceneOf(sceneText(result.draft));
    EquilibriumOptions options;
    options.accuracy = scene.accuracy;
    const Equilibrium found = EquilibriumSolver(options).solve(scene.harness);
    ASSERT_TRUE(found.converged()) << shape << ": " << found.message;
    const CableShape& trunk = found.shapes.front();
    // clips hold it, its own weight of 0.6 N/m bends it a little in between
    EXPECT_LT((trunk.position(0.1) - Vector3d(0.1, 0.0, 0.0)).norm(), 0.02) << shape;
    EXPECT_LT(
        (trunk.position(0.5 * (0.2 + trunk.points.back().arc_length)) - Vector3d(0.35, 0, -0.015)).norm(),
        1e-4);
  }
}

// Made in the form of its curves and without weight it stays there.
TEST(KblImport, aFormedHarnessWithoutWeightIsItsCurves) {
  Scene scene = sceneOf(sceneText(importOf(smallKbl(), "rest_shape: curve\nvia_spacing: 5 mm").draft));
  scene.harness.gravity.setZero();
  EquilibriumOptions options;
  options.accuracy = 1e-5;
  const Equilibrium found = EquilibriumSolver(options).solve(scene.harness);
  ASSERT_TRUE(found.converged()) << found.message;
  const Cable& trunk = scene.harness.cables.front();
  for (const Vector3d& point : trunk.via) {
    double nearest = INFINITY;
    for (int i = 0; i <= 2000; ++i)
      nearest = std::min(nearest, (found.shapes.front().position(trunk.length * i / 2000) - point).norm());
    EXPECT_LT(nearest, 1e-3);  // the kink at the branch is rounded
  }
}

TEST(KblImport, staleSegmentsHaveNoPointsAndAreToldInTheScene) {
  const ImportResult result = importOf(with(smallKbl(), ">301.988168<", ">352<"));
  const ImportFinding stale = findingOf(result, Kind::stale_curve);
  EXPECT_EQ(stale.id, "Segment_2");
  EXPECT_EQ(findingOf(result, Kind::unused_fixing).id, "Fixing_occurrence_1");
  const std::string text = sceneText(result.draft);
  EXPECT_NE(text.find("# stale curve: Segment 'Segment_2'"), std::string::npos);
  EXPECT_EQ(sceneOf(text).harness.clips.size(), 3U);
}

TEST(KblImport, tightBendsAreToldAndTheRestShapeIsNoTighter) {
  // segment 2 has its sharpest bend in its middle: the parabola's radius there is L²/(2 q)
  const double sharpest = 0.3 * 0.3 / (2 * 0.06);
  ImportMapping mapping;
  mapping.rest_shape = ImportedRestShape::curve;
  const auto at = [&](double factor) {  // so many times the sharpest bend is allowed
    mapping.least_bend = factor * sharpest / 0.007;
    return importKbl(readKblText(smallKbl(), "small.kbl"), mapping);
  };
  for (const ImportFinding& finding : at(0.98).findings)
    EXPECT_NE(finding.id, "Segment_2") << finding.message;
  const ImportResult result = at(1.5);
  const ImportFinding tight = findingOf(result, Kind::tight_bend);
  EXPECT_EQ(tight.id, "Segment_2");
  for (const RestCurvatureAt& knot : result.draft.cables.front().rest_curvature) {
    EXPECT_TRUE(knot.arc_length < 0.25 || knot.curvature.norm() <= 1.0001 / (1.5 * sharpest))
        << knot.arc_length;
  }
}

TEST(KblImport, missingPlacementsAreTold) {
  std::string text = smallKbl();
  const std::size_t begin = text.find("<Placement id=\"Placement_t1\">");
  text.erase(begin, text.find("</Placement>", begin) + 12 - begin);
  const ImportResult result = importOf(text);
  const ImportFinding missing = findingOf(result, Kind::missing_placement);
  EXPECT_EQ(missing.id, "Terminal_1");
  EXPECT_NE(missing.message.find("Node_4"), std::string::npos);
  EXPECT_EQ(sceneOf(sceneText(result.draft)).harness.clips.size(), 3U);
}

TEST(KblImport, partsFarFromTheHarnessAreTold) {
  const ImportResult result =
      importOf(with(smallKbl(), "<Coordinates>508</Coordinates>", "<Coordinates>708</Coordinates>"));
  const ImportFinding far = findingOf(result, Kind::far_placement);
  EXPECT_EQ(far.id, "Connector_2");
  EXPECT_NE(far.message.find("208 mm"), std::string::npos) << far.message;
}

// A ring, closed by a segment of its own from node 4 to node 5.
std::string ringKbl() {
  const std::string segment =
      "  <Segment id=\"Segment_9\"><Id>ring</Id><Virtual_length "
      "id=\"V9\"><Unit_component>Unit_mm</Unit_component>"
      "<Value_component>250</Value_component></Virtual_length><End_node>Node_5</End_node>"
      "<Start_node>Node_4</Start_node></Segment>\n";
  return with(smallKbl(), "  <Unit id=\"Unit_mm\">", segment + "  <Unit id=\"Unit_mm\">");
}

TEST(KblImport, ringsAreToldAndClosed) {
  const ImportResult result = importOf(ringKbl());
  const ImportFinding ring = findingOf(result, Kind::cycle);
  EXPECT_EQ(ring.id, "Segment_9");
  for (const char* id : {"Segment_3", "Segment_4", "Segment_9"})
    EXPECT_NE(ring.message.find(id), std::string::npos) << ring.message;
  EXPECT_EQ(findingOf(result, Kind::no_curve).id, "Segment_9");
  EXPECT_EQ(findingOf(result, Kind::no_cross_section).id, "Segment_9");
  const Scene scene = sceneOf(sceneText(result.draft));
  EXPECT_GE(scene.harness.joints.size(), scene.harness.cables.size());
}

std::string apartKbl(const std::string& components) {
  const std::string more =
      "  <Cartesian_point "
      "id=\"P91\"><Coordinates>0</Coordinates><Coordinates>900</Coordinates><Coordinates>0</Coordinates></"
      "Cartesian_point>\n"
      "  <Cartesian_point "
      "id=\"P92\"><Coordinates>0</Coordinates><Coordinates>990</Coordinates><Coordinates>0</Coordinates></"
      "Cartesian_point>\n"
      "  <Node id=\"Node_91\"><Id>a</Id><Cartesian_point>P91</Cartesian_point>" +
      components +
      "</Node>\n"
      "  <Node id=\"Node_92\"><Id>b</Id><Cartesian_point>P92</Cartesian_point></Node>\n"
      "  <Segment id=\"Segment_91\"><Id>apart</Id><Virtual_length "
      "id=\"V91\"><Unit_component>Unit_mm</Unit_component>"
      "<Value_component>100</Value_component></Virtual_length><End_node>Node_91</End_node>"
      "<Start_node>Node_92</Start_node></Segment>\n";
  return with(smallKbl(), "  <Unit id=\"Unit_mm\">", more + "  <Unit id=\"Unit_mm\">");
}

TEST(KblImport, disconnectedSegmentsAreToldAndLeftOutWhereNothingHoldsThem) {
  const ImportResult result = importOf(apartKbl(""));
  EXPECT_EQ(findingOf(result, Kind::disconnected).id, "Segment_91");
  EXPECT_EQ(findingOf(result, Kind::not_held).id, "Segment_91");
  EXPECT_EQ(sceneOf(sceneText(result.draft)).harness.cables.size(), 3U);

  const ImportResult held = importOf(apartKbl("<Referenced_components>Connector_2</Referenced_components>"));
  EXPECT_EQ(findingOf(held, Kind::disconnected).id, "Segment_91");
  EXPECT_EQ(sceneOf(sceneText(held.draft)).harness.cables.size(), 4U);
}

TEST(KblImport, aHarnessThatNothingHoldsIsRefused) {
  const std::string none =
      "types:\n  Connector_occurrence: {clip: none}\n  Special_terminal_occurrence: {clip: none}\n  SPT: "
      "{clip: none}\n";
  try {
    importOf(smallKbl(), none);
    FAIL();
  } catch (const SceneError& error) {
    EXPECT_NE(std::string(error.what()).find("nothing holds the harness"), std::string::npos) << error.what();
  }
}

TEST(KblImport, mappedPartsGetTheirClipsAndTolerances) {
  const ImportResult result = importOf(smallKbl(),
                                       "parts:\n  F-100: {clip: sliding_rolling, tolerance: hole}\n"
                                       "types:\n  Connector_occurrence: {clip: fixed, tolerance: plug}\n"
                                       "tolerances:\n  hole: {translate: 0.5 mm, rotate: 2 deg}\n"
                                       "  plug: {rotate: 1 deg, sigma: 4}\n  cut: {length: 4 mm}\n"
                                       "cable_tolerance: cut\n");
  const Scene scene = sceneOf(sceneText(result.draft));
  EXPECT_TRUE(named(scene.harness.clips, "CLIP.1").constraint.slides);
  std::map<std::string, double> limits;
  for (const DesignVariable& variable : scene.design_variables) limits[variable.name] = variable.upper;
  EXPECT_EQ(limits.count("CLIP.1_x"), 0U);  // it slides along x
  EXPECT_NEAR(limits.at("CLIP.1_y"), 5e-4, 1e-12);
  EXPECT_EQ(limits.count("CLIP.1_rx"), 0U);
  EXPECT_NEAR(limits.at("CLIP.1_rz"), 2 * M_PI / 180, 1e-9);
  EXPECT_NEAR(limits.at("XA.1_rx"), M_PI / 180, 1e-9);
  EXPECT_NEAR(limits.at("Segment_1_length"), 4e-3, 1e-12);
  for (const std::string& value : result.defaults) EXPECT_EQ(value.find("F-100"), std::string::npos) << value;
}

TEST(KblImport, whatIsNotMappedIsListed) {
  const ImportResult result = importOf(smallKbl(), "bundle: {sticking: 0.2}");
  std::string all;
  for (const std::string& value : result.defaults) all += value + "\n";
  EXPECT_NE(all.find("Fixing_occurrence of type SPT, part F-100: clip fixed (1 times)"), std::string::npos)
      << all;
  EXPECT_NE(all.find("bundle.density: 2500 kg/m^3"), std::string::npos) << all;
  EXPECT_EQ(all.find("bundle.sticking"), std::string::npos) << all;
  const std::string text = sceneText(result.draft);
  EXPECT_NE(text.find("# default: bundle.density: 2500 kg/m^3"), std::string::npos);
}

// Wires of one kind: a bundle's bounds, in closed form.
TEST(BundleSection, ofOneWireIsTheWire) {
  BundleRule rule;
  const BundleWire wire{0.5e-6, 0.006, 0.0016, {}, {}, {}};
  const BundleBounds bounds = bundleBounds(0.0008, {wire}, {}, rule);
  const double own = 0.5e-6 * 0.5e-6 / (4 * M_PI);
  EXPECT_NEAR(bounds.slipping.EI_y, 1e10 * own, 1e-12);
  EXPECT_NEAR(bounds.sticking.EI_y, 1.1e11 * own, 1e-12);  // its strands stick: a solid conductor
  EXPECT_NEAR(bounds.slipping.EA, 1.1e11 * 0.5e-6, 1e-6);
  EXPECT_NEAR(bounds.slipping.GJ * 1.3, bounds.slipping.EI_y, 1e-15);
  EXPECT_NEAR(bounds.slipping.mass_per_length, 0.006, 1e-15);
}

// Wires at the places of a grid that lie in a circle, by the parallel axis theorem one by one: the more there
// are, the nearer is the bound, which knows no places.
TEST(BundleSection, stickingWiresAreTheParallelAxisSum) {
  BundleRule rule;
  const double pitch = 0.0016, A = 0.4e-6, E = rule.conductor_modulus;
  for (const auto& [rings, tolerance] : std::map<double, double>{{3.0, 0.15}, {10.0, 0.03}, {30.0, 0.01}}) {
    std::vector<BundleWire> wires;
    double sum = 0.0;
    const int most = static_cast<int>(rings) + 1;
    for (int i = -most; i <= most; ++i) {
      for (int k = -most; k <= most; ++k) {
        const double y = pitch * i, z = pitch * k;
        if (std::hypot(y, z) > rings * pitch) continue;
        wires.push_back({A, 0.006, pitch, {}, {}, {}});
        sum += E * (A * A / (4 * M_PI) + A * z * z);
      }
    }
    // the circle in which there is one wire to each square of the grid; the squares' own share is the wires'
    const double radius = pitch * std::sqrt(static_cast<double>(wires.size()) / M_PI);
    EXPECT_NEAR(bundleBounds(radius, wires, {}, rule).sticking.EI_y / sum, 1.0, tolerance) << rings;
  }
}

// Seven strands around each other touch: the centres of six are a diameter away, and the sum is 55 I.
TEST(BundleSection, sevenTouchingWiresAreWithinAFewPercentOfTheirSum) {
  BundleRule rule;
  rule.conductor_share = 1.0;
  const double d = 0.002, A = M_PI * d * d / 4, I = M_PI * std::pow(d, 4) / 64;
  const std::vector<BundleWire> wires(7, {A, 0.02, d, {}, {}, {}});
  // the mean radius of what seven touching circles cover, and the circle around them
  const double sum = rule.conductor_modulus * 55 * I;
  EXPECT_GT(bundleBounds(1.5 * d, wires, {}, rule).sticking.EI_y, sum);
  EXPECT_LT(bundleBounds(1.5 * d, wires, {}, rule).sticking.EI_y, 1.16 * sum);
  EXPECT_GT(bundleBounds(std::sqrt(7.0) / 2 * d, wires, {}, rule).sticking.EI_y, 0.8 * sum);
}

TEST(BundleSection, coversAndMeasuredWiresCount) {
  BundleRule rule;
  const BundleCover tube{0.02, 5.0, 0.3, 0.2};
  const BundleWire measured{1e-6, 0.01, 0.002, 2e11, 4e-4, 3e-4};
  const std::vector<BundleWire> wires{measured, {1e-6, 0.01, 0.002, {}, {}, {}}};
  const double own = 1e-12 / (4 * M_PI);
  const BundleBounds bounds = bundleBounds(0.003, wires, tube, rule);
  EXPECT_NEAR(bounds.slipping.EI_y, 4e-4 + 1e10 * own + 0.3, 1e-12);
  EXPECT_NEAR(bounds.slipping.GJ, 3e-4 + 1e10 * own / 1.3 + 0.2, 1e-12);
  EXPECT_NEAR(bounds.slipping.EA, 2e5 + 1.1e5 + 5.0, 1e-6);
  EXPECT_NEAR(bounds.slipping.mass_per_length, 0.04, 1e-12);
  const double aside = 1e-6 * (9e-6 / 4 - 4e-6 / 16);
  EXPECT_NEAR(bounds.sticking.EI_y, 2e11 * (own + aside) + 1.1e11 * (own + aside) + 0.3, 1e-9);
  for (const double sticking : {0.0, 0.25, 1.0}) {
    const Section between = sectionBetween(bounds, sticking);
    EXPECT_NEAR(between.EI_y, (1 - sticking) * bounds.slipping.EI_y + sticking * bounds.sticking.EI_y, 1e-12);
    EXPECT_NEAR(between.GJ, (1 - sticking) * bounds.slipping.GJ + sticking * bounds.sticking.GJ, 1e-12);
  }
  // without wires the conductors fill a share of the circle
  EXPECT_NEAR(bundleBounds(0.003, {}, {}, rule).slipping.EA, 1.1e11 * 0.25 * M_PI * 9e-6, 1e-3);
}

// What is stiffer is so at both bounds, and sticking wires are never softer than slipping ones.
TEST(BundleSection, boundsAreInOrder) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  BundleRule rule;
  for (int i = 0; i < 200; ++i) {
    std::vector<BundleWire> wires;
    double area = 0.0;
    for (int k = 0; k < 1 + i % 40; ++k) {
      const double d = 0.001 + 0.004 * share(random);
      BundleWire wire{(0.1 + 0.6 * share(random)) * M_PI * d * d / 4, 0.01, d, {}, {}, {}};
      if (k % 3 == 0) wire.EI = 1e-3 * share(random);
      area += M_PI * d * d / 4;
      wires.push_back(wire);
    }
    const BundleBounds bounds = bundleBounds(std::sqrt(area / M_PI) * (1.0 + share(random)), wires, {}, rule);
    EXPECT_LE(bounds.slipping.EI_y, bounds.sticking.EI_y);
    EXPECT_LE(bounds.slipping.GJ, bounds.sticking.GJ);
    EXPECT_GT(bounds.slipping.EI_y, 0.0);
  }
}

// The range of sticking as tolerances of EI and GJ, and what a table and a tube change.
TEST(KblImport, bundlesVaryBetweenTheirBounds) {
  const std::string mapping = "bundle: {sticking: 0.02, sticking_range: [0.005, 0.08]}\n";
  const ImportResult result = importOf(smallKbl(), mapping);
  const Scene scene = sceneOf(sceneText(result.draft));
  const auto variableOf = [](const Scene& of, const std::string& name) {
    return named(of.design_variables, name);
  };
  const auto at = [&](double sticking) {
    return importOf(smallKbl(), "bundle: {sticking: " + std::to_string(sticking) + "}")
        .draft.cables[0]
        .parts[0]
        .section;
  };
  const DesignVariable EI = variableOf(scene, "Segment_1_EI"), GJ = variableOf(scene, "Segment_1_GJ");
  EXPECT_EQ(EI.distribution, "triangular");
  EXPECT_NEAR(EI.nominal, at(0.02).EI_y, 1e-9);
  EXPECT_NEAR(EI.nominal + EI.lower, at(0.005).EI_y, 1e-9);
  EXPECT_NEAR(EI.nominal + EI.upper, at(0.08).EI_y, 1e-9);
  EXPECT_NEAR(GJ.nominal + GJ.upper, at(0.08).GJ, 1e-9);
}

TEST(KblImport, tablesOfWiresAndTubesCount) {
  const Scene plain = sceneOf(sceneText(importOf(smallKbl()).draft));
  const Scene tabled =
      sceneOf(sceneText(importOf(smallKbl(),
                                 "wires:\n  W-050: {conductor_area: 0.35 mm^2, mass_per_length: 5 g/m}\n"
                                 "protections:\n  TAPE: {thickness: 0.5 mm, modulus: 100 MPa}\n")
                            .draft));
  const auto at = [](const Scene& scene, double s) {
    return sectionAt(named(scene.harness.cables, "Segment_1"), s);
  };
  EXPECT_NEAR(at(tabled, 0.1).mass_per_length, 0.005 + 0.005 + 0.030, 1e-9);
  EXPECT_NEAR(at(tabled, 0.1).EA, 1.1e11 * (0.35 + 0.35 + 2.0) * 1e-6, 1.0);
  EXPECT_LT(at(tabled, 0.1).EI_y, at(plain, 0.1).EI_y);
  // segment 2: a tube around half of it, 0.5 mm thick
  const double r = at(plain, 0.3).radius, tube = 1e8 * M_PI / 4 * (std::pow(r + 5e-4, 4) - std::pow(r, 4));
  const Scene bare = sceneOf(sceneText(
      importOf(smallKbl(), "wires:\n  W-050: {conductor_area: 0.35 mm^2, mass_per_length: 5 g/m}\n").draft));
  EXPECT_NEAR(at(tabled, 0.3).EI_y - at(bare, 0.3).EI_y, 0.5 * tube, 1e-6 * tube);
  EXPECT_NEAR(at(tabled, 0.3).GJ - at(bare, 0.3).GJ, 0.5 * tube / 1.3, 1e-6 * tube);
}

// A cross-section that its wires do not fit into is told, and is theirs.
TEST(KblImport, wiresThatDoNotFitMakeTheBundleThicker) {
  ImportMapping mapping;
  mapping.wires["W-050"].diameter = 0.02;
  const ImportResult result = importKbl(readKblText(smallKbl(), "small.kbl"), mapping);
  EXPECT_EQ(findingOf(result, Kind::thin_cross_section).id, "Segment_1");
  const double area = 2 * M_PI * 1e-4 + 2e-6 / mapping.bundle.conductor_share;
  EXPECT_NEAR(result.draft.cables[0].parts[0].section.radius, std::sqrt(area / M_PI), 1e-9);
}

// Each segment with a sound curve is compared with it.
TEST(KblImport, segmentsAreComparedWithTheirRoutes) {
  const ImportResult result = importOf(smallKbl(), "route_limit: 40 mm\nrest_shape: curve\n");
  const Scene scene = sceneOf(sceneText(result.draft));
  const KblDocument document = readKblText(smallKbl(), "small.kbl");
  ImportFindings findings;
  const auto curves = soundCurves(document, findings);
  ASSERT_EQ(scene.measures.size(), document.segments.size());
  for (std::size_t i = 0; i < document.segments.size(); ++i) {
    const Measure& measure = named(scene.measures, document.segments[i].id);
    EXPECT_EQ(measure.type, Measure::Type::route_deviation);
    EXPECT_EQ(measure.segment, document.segments[i].id);
    EXPECT_EQ(measure.upper, 0.04);
    EXPECT_NEAR(measure.to - measure.from, curves[i]->length(), 1e-5);
    // places of the curve are within a tenth of a millimetre of the route, which runs along the cable
    for (int k = 0; k <= 50; ++k) {
      const Vector3d place = curves[i]->at(curves[i]->length() * k / 50).position;
      double nearest = INFINITY;
      for (std::size_t j = 0; j + 1 < measure.route.size(); ++j) {
        const Vector3d way = measure.route[j + 1] - measure.route[j];
        const double share = std::clamp((place - measure.route[j]).dot(way) / way.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (measure.route[j] + share * way - place).norm());
      }
      EXPECT_LT(nearest, 1.2e-4);
    }
  }
}

TEST(SceneName, holdsWhatAFrameMay) {
  EXPECT_EQ(sceneName("XA.1_b-2"), "XA.1_b-2");
  EXPECT_EQ(sceneName("a b/c\xc3\xa4"), "a_b_c__");
  EXPECT_EQ(sceneName(""), "_");
  EXPECT_EQ(sceneName(std::string(500, 'x')).size(), 150U);
}

}  // namespace
}  // namespace cable_variation
