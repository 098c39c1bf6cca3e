// Scene files that mislead or were misread, each with what is right; the solver's and the analyses' answers
// to them.

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include <cable_variation/geometry/body/outer_surface.h>
#include <cable_variation/scene/resource_address.h>
#include <cable_variation/sensitivity/stability_analysis.h>
#include <cable_variation/simulation/simulation.h>

#include "elastica.h"
#include "fault_scene.h"

namespace cable_variation::test {
namespace {

using Eigen::Vector3d;
using Lines = std::vector<std::string>;

const std::string kCable =
    "  - {name: c, length: 200 mm, stiffness: {EA: 1 kN, GA: 1 kN, EI: 0.02 Nm^2, GJ: 0.02 Nm^2, "
    "mass_per_length: 0.1, radius: 2 mm}}";
const std::string kClip = "  - {name: a, type: fixed, cable: c, at: start, pose: {position: [0, 0, 0]}}";

// One cable on one clip, and what else the lines say.
Lines sceneWith(Lines more, const std::string& cable = kCable) {
  more.insert(more.begin(), {"cables:", cable, "clips:", kClip});
  return more;
}

// One corner is 4e-18 m beside its neighbours': the box is closed all the same, and 25 mm of it are about the
// cable.
TEST(InputFault, WeldedBoxIsASolid) {
  const SolvedFile file(sceneOfFile("inputs", "welded_box"));
  const MeasureValue value = file.value(0);
  EXPECT_NEAR(value.value, -0.027, 1e-7);
  EXPECT_TRUE(contains(value.note, "the centreline enters 'block'")) << value.note;
  EXPECT_FALSE(contains(value.note, "open")) << value.note;
  EXPECT_FALSE(value.undecided);
}

// The first byte of its data is that of a line's end. From x = 0.1 m on, where the cable ends 20 mm before.
TEST(InputFault, PlyWithANewlineForItsFirstByte) {
  const SolvedFile file(sceneOfFile("inputs", "ply_newline"));
  EXPECT_NEAR(file.value(0).value, 0.018, 1e-6);
}

TEST(InputFault, LongSoftCablesKeepNoTurn) {
  for (const std::string name : {"long_soft", "long_soft_hinted", "long_soft_hint_lost"}) {
    const SolvedFile file(sceneOfFile("inputs", name));
    ASSERT_TRUE(file.answer().converged()) << name << ": " << file.answer().message;
    EXPECT_NEAR(file.value(0).value, 0.0, 1e-9) << name;
    if (name != "long_soft_hint_lost") {
      EXPECT_NEAR(file.answer().energy.total(), -0.693170, 2e-5) << name;
    }
    EXPECT_GT(file.answer().smallest_eigenvalue, 0.0) << name;
    EXPECT_LT(file.middle().z(), -0.2) << name;
  }
}

TEST(InputFault, ColumnAboveItsLoadIsBentOver) {
  const SolvedFile file(sceneOfFile("inputs", "column_above_load"));
  ASSERT_TRUE(file.answer().converged()) << file.answer().message;
  const BentColumn expected = bentColumn(0.1994 / (0.25 * M_PI * M_PI * 0.02 / 0.25));
  EXPECT_NEAR(file.tip().x(), 0.5 * expected.along, 1e-4);
  EXPECT_NEAR(file.tip().tail<2>().norm(), 0.5 * expected.aside, 2e-4);
  EXPECT_GT(file.answer().smallest_eigenvalue, -1e-6);
}

Simulation simulated(const SolvedFile& file) {
  SimulationOptions options;
  options.samples = 2000;
  for (std::size_t i = 0; i < file.scene.design_variables.size(); ++i) options.variables.push_back(i);
  options.sampler = SamplerType::latin_hypercube;
  const MeasureEvaluator evaluator(file.scene, file.solved.view());
  return simulateVariation(file.scene, evaluator, options, file.solver);
}

// σ of a beta distribution on an interval of 6 mm: its width times √(αβ/(α+β+1))/(α+β).
double betaSigma(double alpha, double beta) {
  return 6e-3 * std::sqrt(alpha * beta / (alpha + beta + 1.0)) / (alpha + beta);
}

TEST(InputFault, BetaDistributionsAreSimulated) {
  const Simulation found = simulated(SolvedFile(sceneOfFile("inputs", "beta_5_5")));
  EXPECT_EQ(found.statistics.count(SampleOutcome::solved), 2000U);
  EXPECT_NEAR(found.statistics.statistics[0].mean, 0.0, 1e-5);
  EXPECT_NEAR(found.statistics.statistics[0].sigma, betaSigma(5.0, 5.0), 0.01 * betaSigma(5.0, 5.0));
}

TEST(InputFault, CorrelatedBetaDistributionsAreSimulated) {
  for (const auto& [alpha, beta] :
       std::vector<std::pair<double, double>>{{0.5, 2.0}, {0.5, 3.0}, {2.0, 0.5}, {3.0, 0.5}}) {
    const std::string distribution =
        ", tolerance: 3 mm, distribution: {type: beta, alpha: " + std::to_string(alpha) +
        ", beta: " + std::to_string(beta) + "}}";
    const Simulation found = simulated(SolvedFile(sceneOfLines(
        sceneWith({"design_variables:", "  - {name: y, clip: a, translate: y" + distribution,
                   "  - {name: z, clip: a, translate: z" + distribution,
                   "correlations:", "  - {variables: [y, z], coefficient: 0.6}",
                   "measures:", "  - {name: y, type: position, cable: c, at: start, direction: y}",
                   "  - {name: z, type: position, cable: c, at: start, direction: z}"}))));
    for (const MeasureStatistics& measure : found.statistics.statistics) {
      EXPECT_EQ(measure.count, 2000U);
      EXPECT_NEAR(measure.mean, 6e-3 * (alpha / (alpha + beta) - 0.5), 5e-5);
      EXPECT_NEAR(measure.sigma, betaSigma(alpha, beta), 0.03 * betaSigma(alpha, beta));
    }
  }
}

// The strip flips over within 30°, to the other side of its clips, as it does within 25°.
TEST(InputFault, HiddenSnapIsTold) {
  for (const double tolerance : {25.0, 30.0}) {
    Scene scene = sceneOfFile("inputs", "snap_hidden");
    scene.design_variables[0].lower = -tolerance * M_PI / 180.0;
    scene.design_variables[0].upper = tolerance * M_PI / 180.0;
    const SolvedFile file(std::move(scene));
    ASSERT_TRUE(file.answer().converged()) << file.answer().message;
    const MeasureEvaluator evaluator(file.scene, file.solved.view());
    const StabilityAnalysis analysis = analyseStability(file.scene, evaluator, {}, file.solver);
    ASSERT_EQ(analysis.snaps.size(), 1U) << tolerance;
    EXPECT_LT(std::abs(analysis.snaps[0].deviation), 25.0 * M_PI / 180.0);
    EXPECT_NEAR(analysis.low_high[0][0].low * analysis.low_high[0][0].high, -0.033 * 0.033, 1.5e-4);
    bool told = false;
    for (const std::string& warning : analysis.warnings)
      told = told || (contains(warning, "r at its") && contains(warning, "snap to another equilibrium"));
    EXPECT_TRUE(told) << tolerance;
  }
}

// The rest shape is a helix of 19.9/m and 1.27/m, and the answer.
TEST(InputFault, CoilKeepsItsRestShape) {
  const SolvedFile file(sceneOfFile("inputs", "coil"));
  ASSERT_TRUE(file.answer().converged()) << file.answer().message;
  EXPECT_LT(file.answer().energy.total(), 1e-12);
  const Vector3d darboux(1.27, 0.0, 19.9);
  const double turn = darboux.norm();
  const Vector3d axis = darboux / turn, along = axis.x() * axis, out = Vector3d::UnitX() - along;
  for (double s = 0.1; s <= 1.6; s += 0.1) {
    const Vector3d helix = s * along + std::sin(turn * s) / turn * out +
                           (1.0 - std::cos(turn * s)) / turn * axis.cross(Vector3d::UnitX());
    EXPECT_LT((file.answer().shapes[0].position(s) - helix).norm(), 1e-4) << s;
  }
}

TEST(InputFault, ASecondDocumentIsRefusedWithItsLine) {
  const Lines lines = sceneWith({"---", "clips:", kClip});
  EXPECT_TRUE(contains(refusalOf(lines), "a second document starts here")) << refusalOf(lines);
  EXPECT_EQ(refusalOf(sceneWith({})), "");
}

std::string bytesOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class TemporaryFolder {
 public:
  TemporaryFolder()
      : path_(std::filesystem::temp_directory_path() / (std::to_string(getpid()) + " faults #1, 50%")) {
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path_ / name, std::ios::binary) << bytes;
    return (path_ / name).string();
  }

 private:
  std::filesystem::path path_;
};

// RViz reads the escaped form; both name the file, and RViz is given the one that it reads.
TEST(InputFault, MeshNamesMayHoldBlanksAndMarks) {
  const TemporaryFolder folder;
  const std::string block = bytesOf(findTestPackage("test_data") + "/faults/inputs/block.stl");
  for (const std::string name : {"a part.stl", "part#2.stl", "50% off.stl", "50%20off.stl"}) {
    const std::string path = folder.write(name, block);
    for (const std::string& address : {"file://" + path, fileUrl(path)}) {
      const Scene scene =
          sceneOfLines(sceneWith({"components:", "  - {name: block, mesh: \"" + address + "\"}"}));
      const Visual& visual = scene.components.at(0).visuals.at(0);
      EXPECT_EQ(visual.mesh_resource, fileUrl(path));
      EXPECT_EQ(visual.mesh->triangles.size(), 12U);
    }
  }
}

TEST(InputFault, BytesAfterTheLastTriangleDoNoHarm) {
  const TemporaryFolder folder;
  std::string stl(80, 'x');
  const auto add = [&stl](const auto& value) {
    stl.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  add(std::uint32_t{1});
  for (const float coordinate : {0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) add(coordinate);
  add(std::uint16_t{0});
  const auto triangles = [&folder](const std::string& bytes) {
    const std::string path = folder.write("part.stl", bytes);
    return sceneOfLines(sceneWith({"components:", "  - {name: part, mesh: \"" + fileUrl(path) + "\"}"}))
        .components.at(0)
        .visuals.at(0)
        .mesh->triangles.size();
  };
  EXPECT_EQ(triangles(stl), 1U);
  EXPECT_EQ(triangles(stl + "made by a tool, with a note at its end"), 1U);
}

TEST(InputFault, RecordingsRepeatTimesAndShout) {
  const TemporaryFolder folder;
  const std::string path =
      folder.write("RIDE.TUM",
                   "\xef\xbb\xbf# time x y z qx qy qz qw\n10 0 0 0 0 0 0 1\n"
                   "10.01 1 0 0 0 0 0 1\n10.01 0.002 0 0 0 0 0 1\n10.02 0.003 0 0 0 0 0 1\n");
  const Scene scene = sceneOfLines(
      sceneWith({"components:", "  - {name: sled}",
                 "motions:", "  - {name: ride, component: sled, file: \"" + fileUrl(path) + "\"}"}));
  const Motion& motion = scene.motions.at(0);
  ASSERT_EQ(motion.samples.size(), 3U);
  EXPECT_EQ(motion.replaced_poses, 1U);
  EXPECT_NEAR(motion.samples[1].pose.position.x(), 0.002, 1e-15);  // the last one counts
  ASSERT_EQ(scene.warnings.size(), 1U);
  EXPECT_TRUE(contains(scene.warnings[0].message, "motion 'ride'")) << scene.warnings[0].message;
}

// Finer than any memory holds: it keeps to the limit and says so.
TEST(InputFault, AnExcessTooFineIsNotTried) {
  const RoundedHull body{ConvexHull({{0.0, 0.0, 0.0}, {0.3, 0.0, 0.0}, {0.0, 0.2, 0.0}, {0.0, 0.0, 0.1}}),
                         0.01};
  OuterSurfaceOptions options;
  options.excess = 1e-7;
  options.memory_limit = 2e7;
  const OuterSurface surface = outerSurface({&body}, options);
  EXPECT_TRUE(surface.coarsened);
  EXPECT_GT(surface.excess, 1e-7);
}

struct Trap {
  Lines scene;
  const char* told;  // in a warning
};

TEST(InputFault, UnitTrapsAreTold) {
  const TemporaryFolder folder;
  const std::string floor = folder.write("floor.stl",
                                         "solid floor\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
                                         "vertex 1350 0 0\nvertex 0 950 20\nendloop\nendfacet\nendsolid\n");
  Lines long_cable =
      sceneWith({"  - {name: b, type: fixed, cable: c, at: end, pose: {position: [0.15, 0, 0]}}"},
                "  - {name: c, length: 200, stiffness: {EA: 1 kN, GA: 1 kN, EI: 0.02, GJ: 0.02, "
                "mass_per_length: 0.1, radius: 2 mm}}");
  const std::vector<Trap> traps{
      {sceneWith({"components:", "  - {name: floor, mesh: \"" + fileUrl(floor) + "\"}"}),
       "component 'floor', mesh: it measures 1350 x 950 x 20 m, more than 10 m; in mm?"},
      {sceneWith({"gravity: [0, 0, -9810]"}), "gravity: it is 9810 m/s^2"},
      {long_cable, "cable 'c', length: 200 m"},
      {sceneWith({"components:", "  - {name: part, pose: {rpy: [0, 0, 90]}}"}),
       "component 'part', pose, rpy[2]: found '90' without a unit, which is 90 rad; in deg?"},
      {sceneWith({"design_variables:", "  - {name: v, clip: a, translate: z, tolerance: 2}"}),
       "design variable 'v', tolerance: found '2', which is 2 m"},
      {sceneWith({"design_variables:", "  - {name: v, clip: a, rotate: z, tolerance: 5}"}),
       "design variable 'v', tolerance: found '5', which is 5 rad"},
  };
  EXPECT_EQ(warningsOf(sceneOfLines(sceneWith({}))), Lines());
  for (const Trap& trap : traps) {
    const Lines warnings = warningsOf(sceneOfLines(trap.scene));
    ASSERT_EQ(warnings.size(), 1U) << trap.told;
    EXPECT_TRUE(contains(warnings[0], trap.told)) << warnings[0];
  }
}

TEST(InputFault, EngineersMayWriteNmAndNmm) {
  for (const std::string moment : {"0.005 Nm", "5 Nmm", "0.005 N m"}) {
    const Scene scene = sceneOfLines(
        sceneWith({"loads:", "  - {name: l, cable: c, at: 100 mm, moment: [0, " + moment + ", 0]}"}));
    EXPECT_NEAR(scene.harness.loads.at(0).moment.y(), 0.005, 1e-15) << moment;
  }
}

}  // namespace
}  // namespace cable_variation::test
