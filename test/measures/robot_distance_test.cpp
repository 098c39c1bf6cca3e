// Distances to a robot are those to the closest of its links, wherever each of them is.

#include <cmath>

#include <gtest/gtest.h>

#include <cable_variation/scene/design_rate.h>
#include <measures/solved_scene.h>

namespace cable_variation::test {
namespace {

constexpr double kLength = 0.3, kRadius = 0.005;

/// A straight cable along x, its start held by a robot's hand; the robot's foot above its middle and its hand
/// below its end, both turned a little.
struct Robot : testing::Test {
  Robot()
      : scene(sceneOf(
            cantilever(uniformCable(kLength, solidSection(kRadius, {2e8, 0.25, 1500.0})), {0, 0, 0}))) {
    const Eigen::Quaterniond turned(Eigen::AngleAxisd(0.3, Eigen::Vector3d(1.0, 2.0, 3.0).normalized()));
    Component foot = boxPart("arm", {0.02, 0.02, 0.02}, {{0.15, 0.0, 0.06}, turned});
    Component wrist;  // a frame alone
    wrist.name = "arm/wrist";
    wrist.parent = "arm";
    Component hand = boxPart("arm/hand", {0.02, 0.03, 0.02}, {{0.1, 0.0, -0.1}, turned.conjugate()});
    hand.parent = "arm/wrist";
    for (Component* each : {&foot, &wrist, &hand}) each->robot = "arm";
    scene.components = {foot, wrist, hand};
    for (const char* name : {"whole", "foot", "hand"})
      scene.measures.push_back(measure(Measure::Type::distance, name));
    scene.measures[0].component = scene.measures[1].component = 0;
    scene.measures[2].component = 2;
    // the foot alone, as another robot's
    Component lone = foot;
    lone.name = "lone";
    lone.robot.clear();
    scene.components.push_back(lone);
    scene.measures[1].component = 3;
  }

  std::vector<MeasureValue> valuesAt(const ComponentPoses& moved = {}, const DesignValues& design = {}) {
    solved = {harnessAt(scene, design, moved), {}, componentPosesAt(scene, design, moved)};
    solved.equilibrium = solver.update(solved.harness);
    if (!evaluator) evaluator.emplace(scene, solved.view());
    return evaluator->evaluate(solved.view(), {0, 1, 2});
  }

  Scene scene;
  EquilibriumSolver solver;
  Solved solved;
  std::optional<MeasureEvaluator> evaluator;
};

TEST_F(Robot, TheDistanceIsThatOfTheClosestLinkWhereverTheLinksAre) {
  const auto as_designed = valuesAt();
  EXPECT_LT(as_designed[2].value, as_designed[1].value);
  EXPECT_DOUBLE_EQ(as_designed[0].value, as_designed[2].value);
  EXPECT_EQ(as_designed[0].trace.component, 2u);
  EXPECT_TRUE(as_designed[0].other.isApprox(as_designed[2].other, 1e-12));
  // the hand moves away, as by its joint: the foot is closest
  ComponentPoses moved{{"arm/hand", {{0.3, 0.0, -0.3}, Eigen::Quaterniond::Identity()}}};
  const auto away = valuesAt(moved);
  EXPECT_NEAR(away[0].value, away[1].value, 1e-12);
  EXPECT_EQ(away[0].trace.component, 0u);
  EXPECT_GT(away[2].value, away[1].value);
  // and comes close again, to where nothing was before
  moved["arm/hand"].position = {0.05, 0.0, 0.02};
  const auto close = valuesAt(moved);
  EXPECT_DOUBLE_EQ(close[0].value, close[2].value);
  EXPECT_NEAR(close[0].value, 0.02 - 0.01 - kRadius, 1e-9);
}

TEST_F(Robot, SearchesNearAKnownShapeGiveTheSame) {
  const auto values = valuesAt();
  evaluator->expectNear(solved.view(), {0, 1, 2}, values, 0.01);
  for (const double z : {-0.004, 0.004}) {
    const ComponentPoses moved{{"arm/hand",
                                {scene.components[2].pose.position + Eigen::Vector3d(0.15, 0.0, 0.06 + z),
                                 scene.components[2].pose.orientation}}};
    const auto plain = valuesAt(moved);
    const auto near = evaluator->evaluate(solved.view(), {0, 1, 2}, &values);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(near[i].value, plain[i].value, 1e-12) << i;
  }
}

TEST_F(Robot, SectionsNearAClipOnAnyLinkDoNotCount) {
  const double all = valuesAt({{"arm/hand", {{0.0, 0.0, 0.02}, Eigen::Quaterniond::Identity()}}})[0].value;
  evaluator.reset();
  scene.clip_mounts[0].component = "arm/wrist";
  scene.clip_mounts[0].pose = componentPose(scene, "arm/wrist").inverse() * scene.harness.clips[0].pose;
  scene.measures[0].skip_near_clips = 0.05;
  const MeasureValue skipped =
      valuesAt({{"arm/hand", {{0.0, 0.0, 0.02}, Eigen::Quaterniond::Identity()}}})[0];
  EXPECT_LT(all, 0.006);
  EXPECT_GT(skipped.value, 0.03);
  EXPECT_GE(skipped.arc_length, 0.05 - 1e-9);
}

TEST_F(Robot, TheDerivativeIsByTheLinkThatIsClosest) {
  scene.design_variables = {variable("hand_z", ComponentTranslation{2, Axis::z}),
                            variable("foot_x", ComponentTranslation{0, Axis::x})};
  const auto values = valuesAt();
  const auto design = designRates(scene, {}, {}, {0, 1});
  std::vector<HarnessRate> rates;
  for (const DesignRate& rate : design) rates.push_back(rate.harness);
  const auto jacobian =
      evaluator->jacobian(solved.view(), {0, 1, 2}, values, design, solver.differentiate(rates));
  constexpr double kStep = 1e-6;
  for (const std::size_t j : {0u, 1u}) {
    const std::string& name = scene.design_variables[j].name;
    const double difference =
        (valuesAt({}, {{name, kStep}})[0].value - valuesAt({}, {{name, -kStep}})[0].value) / (2.0 * kStep);
    EXPECT_NEAR(jacobian(0, static_cast<Eigen::Index>(j)), difference, 1e-6) << name;
    EXPECT_GT(std::abs(difference), 0.01) << name;
  }
}

}  // namespace
}  // namespace cable_variation::test
