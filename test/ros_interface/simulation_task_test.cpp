// Requests for a simulation: their defaults, and what is refused by name.
#include <cable_variation/analysis/simulation_task.h>

#include <limits>

#include <gtest/gtest.h>

#include <cable_variation/SimulateVariationGoal.h>
#include <cable_variation/SimulateVariationResult.h>

#include <ros_interface/node/same_fields.h>
#include <ros_interface/request/request_status.h>
#include <ros_interface/runs/requests.h>

namespace cable_variation_ros {
namespace {

using namespace cable_variation;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

class SimulationTaskTest : public testing::Test {
 protected:
  SimulationTaskTest() {
    Scene& scene = design_.scene;
    scene.components.resize(1);
    scene.components[0].name = "engine";
    scene.design_variables.resize(2);
    scene.design_variables[0].name = "turn";
    scene.design_variables[1].name = "length";
    scene.measures.resize(2);
    scene.measures[0].name = "gap";
    scene.measures[1].name = "bend";
    scene.motions.resize(1);
    scene.motions[0].name = "run";
    scene.motions[0].component = "engine";
    scene.motions[0].samples = {{0.0, {}}, {2.0, {}}};
    request_.variables = {"*"};
  }

  SimulationTask task() const {
    figureOf(request_.show);  // throws
    return toSimulationTask(fromMessage(request_), design_, moved_, 3, memory_limit_);
  }
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
  SimulateVariationRequest request_;
  double memory_limit_ = 1e9;
};

TEST_F(SimulationTaskTest, EmptyFieldsAreDefaults) {
  const SimulationTask made = task();
  EXPECT_EQ(made.options.variables, (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(made.options.measures, (std::vector<std::size_t>{0, 1}));
  // As the message says.
  EXPECT_EQ(made.options.samples, 10000u);
  EXPECT_EQ(made.options.sigma_error, 0.0);
  EXPECT_EQ(made.options.confidence, 0.95);
  EXPECT_EQ(made.options.seed, 1u);
  EXPECT_EQ(made.options.sampler, SamplerType::monte_carlo);
  EXPECT_EQ(made.options.sections, 33u);
  EXPECT_EQ(made.options.kept_shapes, 0u);
  EXPECT_EQ(made.options.threads, 3u);
  EXPECT_TRUE(made.options.motions.empty());
  EXPECT_EQ(figureOf(request_.show), VariationFigure::six_sigma);
  EXPECT_EQ(made.name, "");
  EXPECT_FALSE(made.other_design);
}

TEST_F(SimulationTaskTest, WhatTakesMoreMemoryThanAllowedIsRefused) {
  design_.scene.harness.cables.resize(20);
  request_.motions = {"run"};
  request_.sections = 2000;
  EXPECT_NE(refusal().find("sections: is 2000"), std::string::npos) << refusal();
  request_.sections = 300;
  EXPECT_EQ(refusal(), "");
  request_.sample_shapes = 500;
  EXPECT_NE(refusal().find("sample_shapes: is 500"), std::string::npos) << refusal();
  EXPECT_NE(refusal().find("would take 5.2 GB, allowed are 500 MB"), std::string::npos) << refusal();
  memory_limit_ = 1.1e10;
  EXPECT_EQ(refusal(), "");
}

TEST_F(SimulationTaskTest, FieldsArriveWhereTheyBelong) {
  request_.samples = 7;
  request_.sigma_error = 0.02;
  request_.confidence = 0.9;
  request_.seed = 8;
  request_.sampler = "sobol";
  request_.variables = {"length"};
  request_.measures = {"bend"};
  request_.nominal_variables = {"turn"};
  request_.nominal_values = {0.1};
  request_.motions = {"run"};
  request_.from_time = 1.0;
  request_.to_time = 1.5;
  request_.sections = 9;
  request_.sample_shapes = 10;
  request_.show = "range";
  request_.name = "run_1";
  design_.shifted = {{"turn", 0.3}, {"length", 0.01}};
  const SimulationTask made = task();
  EXPECT_EQ(made.options.samples, 7u);
  EXPECT_EQ(made.options.sigma_error, 0.02);
  EXPECT_EQ(made.options.confidence, 0.9);
  EXPECT_EQ(made.options.seed, 8u);
  EXPECT_EQ(made.options.sampler, SamplerType::sobol);
  EXPECT_EQ(made.options.variables, std::vector<std::size_t>{1});
  EXPECT_EQ(made.options.measures, std::vector<std::size_t>{1});
  EXPECT_EQ(made.options.values, (DesignValues{{"turn", 0.1}, {"length", 0.01}}));
  EXPECT_TRUE(made.other_design);
  EXPECT_EQ(made.options.motions, std::vector<std::size_t>{0});
  EXPECT_EQ(made.options.from, 1.0);
  EXPECT_EQ(made.options.to, 1.5);
  EXPECT_EQ(made.options.sections, 9u);
  EXPECT_EQ(made.options.kept_shapes, 10u);
  EXPECT_EQ(figureOf(request_.show), VariationFigure::range);
  EXPECT_EQ(made.name, "run_1");
}

TEST_F(SimulationTaskTest, UntilSigmaIsKnownThereIsABoundOfItsOwn) {
  request_.sigma_error = 0.01;
  EXPECT_EQ(task().options.samples, 1000000u);  // as the message says
  request_.samples = 50;
  EXPECT_EQ(task().options.samples, 50u);
}

TEST_F(SimulationTaskTest, AMotionIsTakenWholeInPartOrAtATime) {
  request_.motions = {"run"};
  EXPECT_EQ(task().options.from, 0.0);
  EXPECT_EQ(task().options.to, 2.0);
  request_.from_time = request_.to_time = 0.5;
  EXPECT_EQ(task().options.from, 0.5);
  EXPECT_EQ(task().options.to, 0.5);
  request_.from_time = 0.0;
  request_.to_time = -1.0;
  EXPECT_EQ(task().options.from, 0.0);
  EXPECT_EQ(task().options.to, 0.0);
}

TEST_F(SimulationTaskTest, PartsAreWhereTheyAreNowUnlessAMotionSaysWhere) {
  moved_["engine"].position.x() = 0.5;
  EXPECT_EQ(task().options.moved.size(), 1u);
  request_.motions = {"run"};
  EXPECT_TRUE(task().options.moved.empty());
}

TEST_F(SimulationTaskTest, BadFieldsAreNamedWithTheirValue) {
  using Change = std::function<void(SimulateVariationRequest&)>;
  const std::vector<std::pair<Change, std::string>> cases = {
      {[](auto& r) { r.variables.clear(); }, "variables: is empty"},
      {[](auto& r) { r.variables = {"turns"}; }, "no design variable named 'turns'"},
      {[](auto& r) { r.measures = {"gaps"}; }, "no measure named 'gaps'"},
      {[](auto& r) { r.samples = kMostSamples + 1; }, "samples: is 1000000001, expected at most 1000000000"},
      {[](auto& r) { r.sigma_error = 1.0; }, "sigma_error: is 1"},
      {[](auto& r) { r.sigma_error = -0.1; }, "sigma_error: is -0.1"},
      {[](auto& r) { r.sigma_error = kNan; }, "sigma_error: is nan"},
      {[](auto& r) { r.sigma_error = 0.1, r.sampler = "latin_hypercube"; }, "sampler latin_hypercube"},
      {[](auto& r) { r.confidence = 1.5; }, "confidence: is 1.5"},
      {[](auto& r) { r.sampler = "halton"; }, "'halton'"},
      {[](auto& r) { r.sections = 1; }, "sections: is 1, expected 2 to 2000"},
      {[](auto& r) { r.sections = 2001; }, "sections: is 2001"},
      {[](auto& r) { r.sample_shapes = 501; }, "sample_shapes: is 501, expected at most 500"},
      {[](auto& r) { r.show = "sigma"; }, "show: is 'sigma'"},
      {[](auto& r) { r.motions = {"walk"}; }, "no motion named 'walk'"},
      {[](auto& r) { r.from_time = 1.0; }, "from_time: is 1"},
      {[](auto& r) { r.motions = {"run"}, r.from_time = -1.0; }, "from_time: is -1"},
      {[](auto& r) { r.motions = {"run"}, r.to_time = kNan; }, "to_time: is nan"},
      {[](auto& r) { r.name = "../x"; }, "'../x'"},
  };
  for (const auto& [change, part] : cases) {
    request_ = {};
    request_.variables = {"*"};
    change(request_);
    EXPECT_NE(refusal().find(part), std::string::npos) << "expected " << part << " in: " << refusal();
  }
}

TEST_F(SimulationTaskTest, GoalAndRequestSayTheSameAndSoDoResultAndResponse) {
  SimulateVariationGoal goal;
  goal.samples = 123456789012345;
  goal.sampler = "sobol";
  goal.name = "run";
  EXPECT_EQ(sameFields<SimulateVariationGoal>(sameFields<SimulateVariationRequest>(goal)), goal);
  SimulateVariationResult result;
  result.first_order = {0.25};
  result.report_file = "there";
  EXPECT_EQ(sameFields<SimulateVariationResult>(sameFields<SimulateVariationResponse>(result)), result);
}

}  // namespace
}  // namespace cable_variation_ros
