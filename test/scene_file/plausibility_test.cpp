// Implausible values in a scene are warned of, plausible ones are not.
#include <cable_variation/scene_file/scene_reader.h>

#include <filesystem>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "test_packages.h"

namespace cable_variation {
namespace {

using Lines = std::vector<std::string>;

Lines warningsOf(const Lines& lines) {
  const TemporaryFile file("slips.yaml", lines);
  const Scene scene = readScene(file.path(), findTestPackage);
  Lines texts;
  for (const SceneFault& warning : scene.warnings) {
    EXPECT_EQ(warning.file, file.path());
    texts.push_back(std::to_string(warning.line) + ": " + warning.message);
  }
  return texts;
}

const std::string kRubber = "{young_modulus: 10 MPa, poisson_ratio: 0.3, density: 1200}";

// A scene of one cable between two clips, with lines in between.
Lines sceneWith(const std::string& cable, const Lines& more = {},
                const std::string& second = "[0.25, 0, 0]") {
  Lines lines{"cables:", "  - {name: main, " + cable + "}",
              "clips:", "  - {name: first, type: fixed, cable: main, at: start, pose: {position: [0, 0, 0]}}",
              "  - {name: second, type: fixed, cable: main, at: end, pose: {position: " + second + "}}"};
  lines.insert(lines.end(), more.begin(), more.end());
  return lines;
}

std::string cable(const std::string& length, const std::string& radius,
                  const std::string& material = kRubber) {
  return "length: " + length + ", section: {type: solid, radius: " + radius + ", material: " + material + "}";
}

const std::string kCable = cable("300 mm", "4 mm");

struct Case {
  Lines scene;
  Lines expected;
};

TEST(Plausibility, slipsAreTold) {
  const std::string meshes = "package://test_data/meshes/";
  const Case cases[] = {
      {sceneWith(kCable, {"gravity: [0, 0, -9810]"}),
       {"6: gravity: it is 9810 m/s^2; expected 9.81 m/s^2 or so, or 0; in mm/s^2?"}},
      {sceneWith(kCable, {"gravity: [0, 0, -1]"}),
       {"6: gravity: it is 1 m/s^2; expected 9.81 m/s^2 or so, or 0; in g?"}},
      {sceneWith(kCable, {"accuracy: 5 mm"}),
       {"6: accuracy: it is 0.005 m, more than the radius of cable 'main', 0.004 m; is that meant?"}},
      {sceneWith(cable("200", "4 mm")),
       {"2: cable 'main', length: 200 m of it are between clips that are 0.25 m apart; expected less than 10 "
        "times "
        "as much; in mm?"}},
      {sceneWith(cable("300 mm", "0.2")),
       {"2: cable 'main': it is 0.4 m thick and 0.3 m long; in mm, one of them?"}},
      {sceneWith(cable("300 mm", "4 mm", "{young_modulus: 210, poisson_ratio: 0.3, density: 7850}")),
       {"2: cable 'main', section, material, young_modulus: found '210', which is 210 Pa; cables have "
        "between 500000 "
        "and 1.2e+12 Pa; in MPa or GPa?"}},
      {sceneWith(cable("300 mm", "4 mm", "{young_modulus: 10 MPa, poisson_ratio: 0.3, density: 1.2}")),
       {"2: cable 'main', section, material, density: found '1.2', which is 1.2 kg/m^3; cables have between "
        "20 and "
        "23000 kg/m^3; in g/cm^3?"}},
      {sceneWith("length: 300 mm, stiffness: {EA: 1200, GA: 400, EI: 67000, GJ: 0.04, mass_per_length: 240, "
                 "radius: "
                 "12 mm}"),
       {"2: cable 'main', stiffness, EI: found '67000', which at this radius is a modulus of 4.11396e+12 Pa; "
        "cables "
        "have between 100 and 1.2e+12 Pa; in N mm^2?",
        "2: cable 'main', stiffness, EI: found '67000', which is 67000 N m^2; with EA and radius as they are "
        "expected "
        "at most 17.28 N m^2; in N mm^2?",
        "2: cable 'main', stiffness, mass_per_length: found '240', which at this radius is a density of "
        "530516 kg/m^3; "
        "cables have between 5 and 23000 kg/m^3; in g/m?"}},
      {sceneWith(kCable,
                 {"components:", "  - {name: floor, mesh: " + meshes + "tetrahedron.stl, scale: 1000}"}),
       {"7: component 'floor', mesh: it measures 1000 x 1000 x 1000 m, more than 10 m; is its scale right?"}},
      {sceneWith(kCable,
                 {"components:", "  - {name: grain, mesh: " + meshes + "tetrahedron.stl, scale: 0.0005}"}),
       {"7: component 'grain', mesh: it measures 0.0005 x 0.0005 x 0.0005 m, less than 1 mm; is its scale "
        "right?"}},
      {sceneWith(kCable, {"components:", "  - {name: tray, mesh: " + meshes +
                                             "tetrahedron.stl, pose: {position: [440, 425, 395]}}"}),
       {"7: component 'tray', pose: it is 728.032 m away from all clips; in mm?"}},
      {sceneWith(kCable, {"components:", "  - {name: bracket, pose: {rpy: [0, 0, 90]}}"}),
       {"7: component 'bracket', pose, rpy[2]: found '90' without a unit, which is 90 rad; in deg?"}},
      {sceneWith(kCable + ", twist: 360"),
       {"2: cable 'main', twist: found '360' without a unit, which is 360 rad; in deg?"}},
      {sceneWith(kCable + ", twist: 18.85"), {}},  // three turns
      {sceneWith(kCable + ", via: [[100, 0, 50]]"),
       {"2: cable 'main', via[0]: the point is 111.803 m from clip 'first', and the cable is 0.3 m long; in "
        "mm?"}},
      {sceneWith(kCable, {}, "[250, 0, 0]"),
       {"5: clip 'second': it is 250 m from clip 'first', which is on the same cable 'main' of 0.3 m; in "
        "mm?"}},
      {sceneWith(kCable, {"loads:", "  - {name: pull, cable: main, at: 100 mm, force: [0, 0, 5000]}"}),
       {"7: load 'pull', force: it is 5000 N, which would stretch cable 'main' to more than twice its length "
        "(EA is "
        "502.655 N); is that meant?"}},
      {sceneWith(kCable, {"loads:", "  - {name: turn, cable: main, at: 100 mm, moment: [0, 20, 0]}"}),
       {"7: load 'turn', moment: it is 20 N m, which would bend cable 'main' to less than its own radius, as "
        "from "
        "0.502655 N m on; in N mm?"}},
      {sceneWith(kCable, {"design_variables:", "  - {name: x, clip: first, translate: x, tolerance: 2}"}),
       {"7: design variable 'x', tolerance: found '2', which is 2 m, on cable 'main' of 0.3 m; in mm?"}},
      {sceneWith(kCable, {"design_variables:", "  - {name: x, clip: first, translate: x, tolerance: 2 m}"}),
       {"7: design variable 'x', tolerance: found '2 m', on cable 'main' of 0.3 m; is that "
        "meant?"}},
      {sceneWith(kCable, {"design_variables:", "  - {name: a, clip: first, rotate: x, tolerance: [0, 5]}"}),
       {"7: design variable 'a', tolerance[1]: found '5', which is 5 rad or 286.479 deg either way; in "
        "deg?"}},
      {sceneWith(kCable, {"design_variables:", "  - {name: a, clip: first, rotate: x, tolerance: 15}"}),
       {"7: design variable 'a', tolerance: found '15' without a unit, which is 15 rad; in deg?"}},
      {sceneWith(kCable, {"design_variables:", "  - {name: tip, clip: first, region: ball, tolerance: 0.5}",
                          "  - {name: aim, clip: first, region: cone, axis: x, tolerance: 2}",
                          "  - {name: last, clip: second, translate: x, tolerance: 3}"}),
       {"7: tolerance region 'tip', tolerance: found '0.5', which is 0.5 m, on cable 'main' of 0.3 m; in mm?",
        "8: tolerance region 'aim', tolerance: found '2', which is 2 rad or 114.592 deg either way; in deg?",
        "9: design variable 'last', tolerance: found '3', which is 3 m, on cable 'main' of 0.3 m; in mm?"}},
      {sceneWith(kCable,
                 {"measures:", "  - {name: bend, type: bend_radius, lower: 40}",
                  "  - {name: strain, type: strain, upper: 15}", "  - {name: stress, type: stress, upper: 2}",
                  "  - {name: twist, type: twist, cable: main, upper: 90}"}),
       {"7: measure 'bend', lower: found '40' without a unit, which is 40 m, where the longest cable has 0.3 "
        "m; in mm?",
        "8: measure 'strain', upper: found '15', which is 1500 %; in %?",
        "9: measure 'stress', upper: found '2' without a unit, which is 2 Pa; in MPa?",
        "10: measure 'twist', upper: found '90' without a unit, which is 90 rad; in deg?"}},
      {sceneWith("length: 300 mm, rest_shape: {curvature: [{at: start, value: [0, 0, 400]}]}, section: "
                 "{type: solid, "
                 "radius: 4 mm, material: " +
                 kRubber + "}"),
       {"2: cable 'main', rest_shape: it bends to a radius of 0.0025 m at 0 m, less than the cable's own of "
        "0.004 m; "
        "in 1/m?"}},
  };
  for (const Case& c : cases)
    EXPECT_EQ(warningsOf(c.scene), c.expected) << c.scene.back() << "\n" << c.scene[1];
}

TEST(Plausibility, whatMayBeMeantIsNot) {
  EXPECT_EQ(warningsOf(sceneWith(kCable)), Lines());
  EXPECT_EQ(warningsOf(sceneWith(kCable, {"gravity: [0, 0, 0]"})), Lines());
  EXPECT_EQ(warningsOf(sceneWith(kCable, {"gravity: [0, 0, -1.62]"})), Lines());   // on the moon
  EXPECT_EQ(warningsOf(sceneWith(kCable, {"gravity: [0, 17, -9.81]"})), Lines());  // in a car's turn
  EXPECT_EQ(
      warningsOf(sceneWith(cable("1", "0.0005", "{young_modulus: 1.2e11, poisson_ratio: 0.3, density: 8900}"),
                           {}, "[0.8, 0, 0]")),
      Lines());
  // map coordinates
  Lines far = sceneWith(kCable, {}, "[1000000.25, 2000000, 0]");
  far[3] = "  - {name: first, type: fixed, cable: main, at: start, pose: {position: [1000000, 2000000, 0]}}";
  EXPECT_EQ(warningsOf(far), Lines());
  // a loop whose ends are in one place, and a long end beyond the clips
  EXPECT_EQ(warningsOf(sceneWith(cable("1 m", "2 mm"), {}, "[0, 0, 0]")), Lines());
  Lines tail = sceneWith(cable("2 m", "2 mm"));
  tail[4] = "  - {name: second, type: fixed, cable: main, at: 110 mm, pose: {position: [0.1, 0, 0]}}";
  EXPECT_EQ(warningsOf(tail), Lines());
}

TEST(Plausibility, shippedScenesGiveNoWarnings) {
  const std::string root = CABLE_VARIATION_SOURCE_DIR;
  for (const std::string folder : {"/config", "/test/data/scenes"}) {
    for (const auto& entry : std::filesystem::directory_iterator(root + folder)) {
      if (entry.path().extension() != ".yaml") continue;
      const Scene scene = readScene(entry.path().string(), findTestPackage);
      for (const SceneFault& warning : scene.warnings) ADD_FAILURE() << toString(warning);
    }
  }
}

TEST(Plausibility, aRecordingInMillimetresOrNanoseconds) {
  const auto sceneOf = [](const TemporaryFile& file, const std::string& mount) {
    return sceneWith(kCable,
                     {"components:", "  - {name: sled}",
                      "motions:", "  - {name: ride, component: sled, file: \"file://" + file.path() + "\"}"},
                     "[0.25, 0, 0]}, component: " + mount);
  };
  const TemporaryFile millimetres("mm.tum", {"0 0 0 0 0 0 0 1", "1 20 0 0 0 0 0 1"});
  Lines scene = sceneOf(millimetres, "sled");
  scene[4].pop_back();
  EXPECT_EQ(warningsOf(scene), Lines{"9: motion 'ride': component 'sled' moves by 20 m, which cable 'main' "
                                     "of 0.3 m cannot follow; in mm?"});
  scene = sceneOf(millimetres, "world");
  scene[4].pop_back();
  EXPECT_EQ(warningsOf(scene), Lines());  // nothing hangs on it
  const TemporaryFile nanoseconds("ns.tum",
                                  {"1500000000000000000 0 0 0 0 0 0 1", "1500000001000000000 0 0 0 0 0 0 1"});
  scene = sceneOf(nanoseconds, "sled");
  scene[4].pop_back();
  EXPECT_EQ(warningsOf(scene),
            Lines{"9: motion 'ride': its poses span 1e+09 s, which is 11574.1 days; expected "
                  "seconds; in ns?"});
}

// A value with its unit in a scene of many.
struct Value {
  std::string key;  // %KEY% in the scene
  double number;
  std::string unit;
};

// Random sound scenes say nothing; with any one unit left out they warn, or are refused.
TEST(Plausibility, aUnitLeftOutIsNoticed) {
  const Lines scene{
      "gravity: [0, 0, %GRAVITY%]",
      "materials:",
      "  stuff: {young_modulus: %MODULUS%, poisson_ratio: 0.3, density: %DENSITY%}",
      "components:",
      "  - {name: part, mesh: package://test_data/meshes/tetrahedron.stl, scale: 0.1, pose: {rpy: [0, "
      "%ANGLE%, 0]}}",
      "cables:",
      "  - {name: main, length: %LENGTH%, section: {type: solid, radius: %RADIUS%, material: stuff}}",
      "  - name: hose",
      "    length: 330 mm",
      "    stiffness: {EA: 1.2e3, GA: 410 N, EI: %EI%, GJ: 4.6e-2, mass_per_length: %MASS%, radius: 12 mm}",
      "clips:",
      "  - {name: a, type: fixed, cable: main, at: start, pose: {position: [0, 0, 0]}}",
      "  - {name: b, type: fixed, cable: main, at: end, pose: {position: [%SPAN%, 0, 0], x_axis: [1, 0, 0], "
      "roll: %ROLL%}}",
      "  - {name: c, type: fixed, cable: hose, at: start, pose: {position: [0, 0, 0]}}",
      "design_variables:",
      "  - {name: shift, clip: a, translate: x, tolerance: %SHIFT%}",
      "  - {name: turn, clip: a, rotate: x, tolerance: %TURN%}",
      "  - {name: drawn, cable: main, property: length, tolerance: [0, %LONGER%]}",
      "  - {name: part_z, component: part, translate: z, tolerance: %PART%}",
      "  - {name: tip, clip: b, region: ball, tolerance: %BALL%}",
      "measures:",
      "  - {name: clear, type: distance, component: part, lower: %CLEAR%}",
      "  - {name: bend, type: bend_radius, lower: %BEND%}",
      "  - {name: stress, type: stress, cable: main, upper: %STRESS%}",
  };
  std::mt19937 random(20);
  const auto between = [&](double low, double high) {
    return std::round(100.0 * std::uniform_real_distribution<double>(low, high)(random)) / 100.0;
  };
  const auto write = [&](const std::vector<Value>& values, std::size_t bare) {
    Lines lines = scene;
    for (std::string& line : lines) {
      for (std::size_t i = 0; i < values.size(); ++i) {
        const std::size_t at = line.find(values[i].key);
        if (at == std::string::npos) continue;
        line.replace(at, values[i].key.size(),
                     std::to_string(values[i].number) + (i == bare ? "" : " " + values[i].unit));
      }
    }
    return lines;
  };
  for (int trial = 0; trial < 40; ++trial) {
    const double length = between(100, 900);
    const std::vector<Value> values{
        {"%GRAVITY%", -9810.0, "mm/s^2"},
        {"%MODULUS%", between(2, 900), "MPa"},
        {"%DENSITY%", between(0.5, 8.9), "g/cm^3"},
        {"%ANGLE%", between(10, 180), "deg"},
        {"%LENGTH%", length, "mm"},
        {"%RADIUS%", between(1, 12), "mm"},
        {"%EI%", between(2e4, 9e4), "N mm^2"},
        {"%MASS%", between(150, 400), "g/m"},
        {"%SPAN%", between(0.5, 0.9) * length, "mm"},
        {"%ROLL%", between(10, 180), "deg"},
        {"%SHIFT%", between(0.2, 10), "mm"},
        {"%TURN%", between(1, 10), "deg"},
        {"%LONGER%", between(0.2, 10), "mm"},
        {"%PART%", between(0.2, 10), "mm"},
        {"%BALL%", between(0.2, 10), "mm"},
        {"%CLEAR%", between(1.5, 30), "mm"},
        {"%BEND%", between(10, 90), "mm"},
        {"%STRESS%", between(0.5, 90), "MPa"},
    };
    EXPECT_EQ(warningsOf(write(values, values.size())), Lines()) << "trial " << trial;
    for (std::size_t i = 0; i < values.size(); ++i) {
      try {
        EXPECT_FALSE(warningsOf(write(values, i)).empty()) << values[i].key << " " << values[i].number;
      } catch (const SceneError&) {
        // refused, which is as good
      }
    }
  }
}

}  // namespace
}  // namespace cable_variation
