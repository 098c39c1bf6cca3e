// Requests for an envelope: their defaults, and what is refused by name.
#include <cable_variation/analysis/envelope_task.h>

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <cable_variation/GenerateEnvelopeGoal.h>
#include <cable_variation/GenerateEnvelopeResult.h>

#include <ros_interface/node/same_fields.h>
#include <ros_interface/request/request_status.h>
#include <ros_interface/runs/requests.h>

namespace cable_variation_ros {
namespace {

using namespace cable_variation;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Component part(const std::string& name, const std::string& parent) {
  Component component;
  component.name = name;
  component.parent = parent;
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  component.visuals.resize(1);
  component.visuals[0].mesh = std::make_shared<TriangleMesh>(mesh);
  return component;
}

class EnvelopeTaskTest : public testing::Test {
 protected:
  EnvelopeTaskTest() {
    Scene& scene = design_.scene;
    scene.components = {part("car", "world"), part("engine", "car"), part("pump", "engine"),
                        part("lid", "world")};
    scene.harness.cables.resize(2);
    scene.harness.cables[0].name = "main";
    scene.harness.cables[1].name = "branch";
    scene.design_variables.resize(2);
    scene.design_variables[0].name = "turn";
    scene.design_variables[0].target = ClipRotation{0, Axis::y};
    scene.design_variables[1].name = "lid_z";
    scene.design_variables[1].target = ComponentTranslation{3, Axis::z};
    scene.motions.resize(2);
    scene.motions[0].name = "run";
    scene.motions[0].component = "engine";
    scene.motions[0].samples = {{0.0, {}}, {2.0, {}}};
    scene.motions[1].name = "shake";
    scene.motions[1].component = "engine";
    scene.motions[1].samples = {{0.0, {}}, {5.0, {}}};
    request_.variables = {"*"};
  }

  EnvelopeTask task() const { return toEnvelopeTask(fromMessage(request_), design_, moved_, 3, 1e9); }
  /// The message of a request that is refused.
  std::string refusal() const {
    try {
      task();
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  }

  Design design_;
  ComponentPoses moved_;
  GenerateEnvelopeRequest request_;
};

TEST_F(EnvelopeTaskTest, EmptyFieldsAreDefaults) {
  const EnvelopeTask made = task();
  EXPECT_TRUE(made.options.cables.empty());
  EXPECT_EQ(made.options.variables, (std::vector<std::size_t>{0, 1}));
  EXPECT_TRUE(made.options.motions.empty());
  EXPECT_EQ(made.options.margin, 1e-4);  // as the message says
  EXPECT_TRUE(made.options.conservative);
  EXPECT_EQ(made.options.verification, 2000u);
  EXPECT_EQ(made.options.tightness, 0u);
  EXPECT_EQ(made.options.seed, 1u);
  EXPECT_EQ(made.options.threads, 3u);
  // shares of the memory limit, with some left for what is made of them
  EXPECT_EQ(made.options.memory_limit, 5e8);
  EXPECT_EQ(made.mesh_memory, 2e8);
  EXPECT_FALSE(made.skip_near_clips);
  EXPECT_EQ(made.name, "");
  EXPECT_FALSE(made.other_design);
}

TEST_F(EnvelopeTaskTest, FieldsArriveWhereTheyBelong) {
  request_.cables = {"branch"};
  request_.variables = {"lid_z"};
  request_.motions = {"shake"};
  request_.from_time = 1.0;
  request_.to_time = 1.5;
  request_.nominal_variables = {"turn"};
  request_.nominal_values = {0.1};
  request_.margin = 2e-4;
  request_.non_conservative = true;
  request_.verification_shapes = 7;
  request_.tightness_shapes = 8;
  request_.tightness_voxel = 1e-3;
  request_.seed = 9;
  request_.mesh_excess = 3e-3;
  request_.skip_near_clips = -1.0;
  request_.name = "env";
  design_.shifted = {{"turn", 0.3}, {"lid_z", 0.01}};
  const EnvelopeTask made = task();
  EXPECT_EQ(made.options.cables, std::vector<std::size_t>{1});
  EXPECT_EQ(made.options.variables, std::vector<std::size_t>{1});
  EXPECT_EQ(made.options.motions, std::vector<std::size_t>{1});
  EXPECT_EQ(made.options.from, 1.0);
  EXPECT_EQ(made.options.to, 1.5);
  EXPECT_EQ(made.options.values, (DesignValues{{"turn", 0.1}, {"lid_z", 0.01}}));
  EXPECT_TRUE(made.other_design);
  EXPECT_EQ(made.options.margin, 2e-4);
  EXPECT_FALSE(made.options.conservative);
  EXPECT_EQ(made.options.verification, 7u);
  EXPECT_EQ(made.options.tightness, 8u);
  EXPECT_EQ(made.options.voxel, 1e-3);
  EXPECT_EQ(made.options.seed, 9u);
  EXPECT_EQ(made.mesh_excess, 3e-3);
  EXPECT_EQ(made.skip_near_clips, 0.0);
  EXPECT_EQ(made.name, "env");
}

TEST_F(EnvelopeTaskTest, AMotionEndsWhereItEnds) {
  request_.motions = {"run"};
  EXPECT_EQ(task().options.from, 0.0);
  EXPECT_EQ(task().options.to, 2.0);
}

TEST_F(EnvelopeTaskTest, ItIsSeenFromPartsThatMoveOrVary) {
  request_.variables = {"turn"};
  EXPECT_TRUE(task().options.frames.empty());
  request_.motions = {"run"};
  EXPECT_EQ(task().options.frames, (std::vector<std::string>{"engine"}));  // the pump moves with it
  request_.variables = {"lid_z"};
  EXPECT_EQ(task().options.frames, (std::vector<std::string>{"engine", "lid"}));
}

TEST_F(EnvelopeTaskTest, PartsAreWhereTheyAreNowUnlessAMotionSaysWhere) {
  moved_["lid"].position.x() = 0.5;
  EXPECT_EQ(task().options.moved.size(), 1u);
  request_.motions = {"run"};
  EXPECT_TRUE(task().options.moved.empty());
}

TEST_F(EnvelopeTaskTest, NothingThatVariesIsSaidSo) {
  request_.variables.clear();
  EXPECT_NE(refusal().find("variables: is empty"), std::string::npos) << refusal();
  request_.motion_only = true;
  EXPECT_NE(refusal().find("motions: is empty"), std::string::npos) << refusal();
  request_.motions = {"run"};
  EXPECT_TRUE(task().options.variables.empty());
  request_.variables = {"turn"};
  EXPECT_NE(refusal().find("motion_only"), std::string::npos) << refusal();
  request_.motion_only = false;
  request_.variables = {"*"};
  design_.scene.design_variables.clear();
  EXPECT_NE(refusal().find("no design variables"), std::string::npos) << refusal();
}

TEST_F(EnvelopeTaskTest, BadFieldsAreNamedWithTheirValue) {
  using Change = std::function<void(GenerateEnvelopeRequest&)>;
  const std::vector<std::pair<Change, std::string>> cases = {
      {[](auto& r) { r.cables = {"trunk"}; }, "no cable named 'trunk'"},
      {[](auto& r) {
         r.cables = {"main", "main"};
       },
       "cable 'main' is given twice"},
      {[](auto& r) { r.variables = {"turns"}; }, "no design variable named 'turns'"},
      {[](auto& r) { r.motions = {"walk"}; }, "no motion named 'walk'"},
      {[](auto& r) {
         r.motions = {"run", "shake"};
       },
       "'engine'"},
      {[](auto& r) { r.margin = -1e-3; }, "margin: is -0.001"},
      {[](auto& r) { r.margin = kNan; }, "margin: is nan"},
      {[](auto& r) { r.mesh_excess = -1.0; }, "mesh_excess: is -1"},
      {[](auto& r) { r.tightness_voxel = INFINITY; }, "tightness_voxel: is inf"},
      {[](auto& r) { r.skip_near_clips = kNan; }, "skip_near_clips: is nan"},
      {[](auto& r) { r.verification_shapes = 4000000000u; }, "verification_shapes: is 4e+09"},
      {[](auto& r) { r.from_time = 1.0; }, "from_time: is 1"},
      {[](auto& r) { r.motions = {"run"}, r.from_time = 2.5; }, "from_time: is 2.5, expected 0 to 2 s"},
      {[](auto& r) { r.motions = {"run"}, r.from_time = 1.5, r.to_time = 1.0; }, "to_time: is 1"},
      {[](auto& r) { r.motions = {"run"}, r.to_time = kNan; }, "to_time: is nan"},
      {[](auto& r) { r.nominal_variables = {"turn"}, r.nominal_values = {kNan}; }, "'turn'"},
      {[](auto& r) { r.name = "../x"; }, "'../x'"},
  };
  for (const auto& [change, part] : cases) {
    request_ = {};
    request_.variables = {"*"};
    change(request_);
    EXPECT_NE(refusal().find(part), std::string::npos) << "expected " << part << " in: " << refusal();
  }
}

TEST_F(EnvelopeTaskTest, AMotionThatIsNotLoadedIsNamed) {
  request_.motions = {"run"};
  design_.scene.motions[0].samples.clear();
  EXPECT_NE(refusal().find("motion 'run': has no poses"), std::string::npos) << refusal();
}

TEST(SameFields, GoalAndRequestSayTheSame) {
  GenerateEnvelopeGoal goal;
  goal.cables = {"main"};
  goal.margin = 0.25;
  goal.seed = 123456789012345;
  goal.show_pieces = true;
  const auto request = sameFields<GenerateEnvelopeRequest>(goal);
  EXPECT_EQ(request.cables, goal.cables);
  EXPECT_EQ(request.margin, goal.margin);
  EXPECT_EQ(request.seed, goal.seed);
  EXPECT_TRUE(request.show_pieces);
  EXPECT_EQ(sameFields<GenerateEnvelopeGoal>(request), goal);
}

}  // namespace
}  // namespace cable_variation_ros
