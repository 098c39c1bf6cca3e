// Harnesses that were not solved, or whose answers were wrong, each with what is right: from closed forms,
// from an adaptive Runge-Kutta integration and a rod of another discretisation, which every answer is held
// against.

#include <functional>
#include <optional>

#include <hunt/balance_check.h>
#include <hunt/settled_check.h>

#include "elastica.h"
#include "fault_scene.h"

namespace cable_variation::test {
namespace {

using Eigen::Vector3d;

struct PhysicsCase {
  const char* file;
  std::optional<double> energy;  // total [J]; else the independent rod says it
  double within = 0.0;           // of it [J]
  std::function<void(const SolvedFile&)> check = [](const SolvedFile&) {};
};

void PrintTo(const PhysicsCase& of, std::ostream* stream) { *stream << of.file; }

void expectHeld(const hunt::Violation& violation) { EXPECT_LE(violation.times, 1.0) << violation.what; }

// By code that shares nothing with the solver.
void expectTrue(const SolvedFile& file) {
  const Harness& harness = file.solved.harness;
  const Equilibrium& answer = file.answer();
  expectHeld(hunt::checkEquations(harness, answer, file.scene.accuracy));
  expectHeld(hunt::checkBalance(harness, answer));
  expectHeld(hunt::checkHolds(harness, answer));
  hunt::Settled own = hunt::settleFrom(harness, answer, 40);
  if (!own.decided || own.centrelineIsOff(file.scene.accuracy) ||
      own.eigenvalueIsOff(answer.smallest_eigenvalue))
    own = hunt::settleFrom(harness, answer, 160);
  EXPECT_TRUE(own.decided) << own.text;
  EXPECT_FALSE(own.centrelineIsOff(file.scene.accuracy)) << 1e3 * own.off << " mm off";
  EXPECT_FALSE(own.isSaddle()) << own.eigenvalue << " N/m";
  EXPECT_FALSE(own.eigenvalueIsOff(answer.smallest_eigenvalue))
      << own.eigenvalue << " N/m, reported " << answer.smallest_eigenvalue;
}

class PhysicsFault : public testing::TestWithParam<PhysicsCase> {};

TEST_P(PhysicsFault, HasTheRightAnswer) {
  const SolvedFile file(sceneOfFile("physics", GetParam().file));
  const Equilibrium& answer = file.answer();
  ASSERT_TRUE(answer.converged()) << answer.message;
  EXPECT_LE(answer.discretisation_error, file.scene.accuracy);
  if (GetParam().energy) {
    EXPECT_NEAR(answer.energy.total(), *GetParam().energy, GetParam().within);
  }
  const double total = answer.energy.total();
  for (const Alternative& alternative : answer.alternatives)
    EXPECT_GE(alternative.energy, total - 1e-6 * std::abs(total));
  expectTrue(file);
  GetParam().check(file);
}

// A steel wire of 0.5 mm, one metre, pressed by 1.01 times what it bears.
void isBentOver(const SolvedFile& file) {
  constexpr double kEI = 210e9 * 0.25 * M_PI * 0.5e-3 * 0.5e-3 * 0.5e-3 * 0.5e-3;
  const BentColumn expected = bentColumn(0.0257 / (0.25 * M_PI * M_PI * kEI));
  EXPECT_NEAR(file.tip().x(), expected.along, 1e-4);
  EXPECT_NEAR(file.tip().tail<2>().norm(), expected.aside, 5e-4);
}

// Pinned at both ends: each half is a column of its own, clamped in the middle.
void isBowedOver(const SolvedFile& file) {
  const BentColumn expected = bentColumn(13.0 / (M_PI * M_PI));
  EXPECT_NEAR(file.tip().x(), expected.along, 2e-4);
  EXPECT_NEAR(std::abs(file.middle().y()), 0.5 * expected.aside, 2e-4);
  EXPECT_NEAR(file.middle().z(), 0.0, 1e-6);  // about the softer axis
}

void endsAt(const SolvedFile& file, const Vector3d& tip) {
  EXPECT_LT((file.tip() - tip).norm(), 1e-3) << file.tip().transpose();
}

// Held aligned with a tenth of slack, it hangs in a bow to some side.
void bowsAside(const SolvedFile& file) { EXPECT_NEAR(file.middle().head<2>().norm(), 0.195, 5e-4); }

void ringIsBesideTheMiddle(const SolvedFile& file) {
  EXPECT_NEAR(std::abs(file.answer().clip_reactions[1].arc_length - 0.5), 0.088, 1e-3);
}

constexpr double kNineTurns = 18.0 * M_PI;  // [rad]

// GJ θ/L; elements of a quarter turn
void bearsNineTurns(const SolvedFile& file) {
  EXPECT_NEAR(file.answer().clip_reactions[1].moment.x(), 0.6 * kNineTurns, 1e-3);
}

const std::vector<PhysicsCase> kCases{
    {"branches_0095", {}},
    {"chain_0118", {}},
    {"d1_unstable_success", {}, 0.0, isBentOver},
    {"d2_wire_free_end", 0.02377, 2e-5,
     [](const SolvedFile& f) {
       endsAt(f, {1.079, 0.0, -0.358});
     }},
    {"d3_aligned_clamps", {}, 0.0, bowsAside},
    {"d4_eyelet_wire", 1.7e-4, 2e-6, ringIsBesideTheMiddle},
    {"d5_wound_spring", 537.5, 1.0},
    {"d6_nine_turns", 0.3 * kNineTurns* kNineTurns + 0.5, 1e-2, bearsNineTurns},
    {"d7_pressed_column", {}, 0.0, isBowedOver},
    {"long_slack_0122", {}},
    {"loops_0065", {}},
    {"lower_branches_0001",
     {},
     0.0,
     [](const SolvedFile& f) { EXPECT_LT(f.answer().energy.total(), 20.12); }},
    {"lower_multi_clip_0026", 0.530, 1e-3},
    {"spring_multi_clip_0108", {}},
    {"stiff_soft_0078", {}},
    {"thin_wire_0104", {}},
};

INSTANTIATE_TEST_SUITE_P(Files, PhysicsFault, testing::ValuesIn(kCases),
                         [](const auto& of) { return of.param.file; });

// A copper wire of 0.5 mm leaves a clip at 45° and hangs free; by the Runge-Kutta integration.
TEST(CopperWireFault, HangsAtAnyLength) {
  for (const std::string length : {"1.0", "1.1", "1.3"}) {
    const SolvedFile file(sceneOfLines(
        {"cables:",
         "  - {name: wire, length: " + length + " m, section: {type: solid, radius: 0.5 mm, material: " +
             "{young_modulus: 120 GPa, poisson_ratio: 0.34, density: 8900}}}",
         "clips:", "  - {name: foot, type: fixed, cable: wire, at: start, pose: {x_axis: [1, 0, 1]}}"}));
    ASSERT_TRUE(file.answer().converged()) << length << " m: " << file.answer().message;
    if (length == "1.1") endsAt(file, {0.7775, 0.0, -0.5862});
    expectTrue(file);
  }
}

// The stretch of a cable that hardly stretches does not move a ring on it.
TEST(StiffCableFault, CarriesItsRingAtTheSamePlace) {
  for (const std::string stiffness : {"7e5", "1e6", "1e7", "1e8"}) {
    const SolvedFile file(sceneOfLines(
        {"cables:",
         "  - {name: c, length: 0.36, stiffness: {EA: " + stiffness + ", GA: " + stiffness +
             ", EI: 0.02, GJ: 0.016, mass_per_length: 0.3, radius: 4 mm}}",
         "clips:", "  - {name: a, type: fixed, cable: c, at: start, pose: {}}",
         "  - {name: b, type: fixed, cable: c, at: end, pose: {position: [0.3, 0, 0.05], rpy: [0, 0, 30 "
         "deg]}}",
         "  - {name: ring, type: eyelet, cable: c, at: 0.18, pose: {position: [0.15, 0.02, 0.03]}}"}));
    ASSERT_TRUE(file.answer().converged()) << stiffness << " N: " << file.answer().message;
    EXPECT_NEAR(file.answer().clip_reactions[2].arc_length, 0.17181, 2e-4) << stiffness << " N";
  }
}

// A thousand kilometres from the origin a cable takes the shape that it has there.
TEST(MapCoordinatesFault, ChangeNoShape) {
  const auto solved = [](const std::string& start, const std::string& end) {
    return SolvedFile(sceneOfLines(
        {"cables:",
         "  - {name: c, length: 0.4, stiffness: {EA: 5000, GA: 2000, EI: 0.02, GJ: 0.016, mass_per_length: "
         "0.1, radius: 4 mm}}",
         "clips:", "  - {name: a, type: fixed, cable: c, at: start, pose: {position: " + start + "}}",
         "  - {name: b, type: fixed, cable: c, at: end, pose: {position: " + end + "}}"}));
  };
  const SolvedFile near = solved("[0, 0, 0]", "[0.3, 0.125, 0.0625]");
  const SolvedFile far = solved("[1000000, -2000000, 500]", "[1000000.3, -1999999.875, 500.0625]");
  ASSERT_TRUE(near.answer().converged() && far.answer().converged()) << far.answer().message;
  EXPECT_LT((far.middle() - Vector3d(1e6, -2e6, 500.0) - near.middle()).norm(), 2e-4);
  EXPECT_NEAR(far.answer().energy.elastic, near.answer().energy.elastic, 1e-4);
}

}  // namespace
}  // namespace cable_variation::test
