#include <ros_interface/services/simulate_variation_action.h>

#include <cmath>

#include <ros/node_handle.h>

#include <cable_variation/SimulateVariation.h>

#include <ros_interface/node/names.h>
#include <ros_interface/node/same_fields.h>
#include <ros_interface/runs/action_end.h>
#include <ros_interface/runs/simulation_runner.h>

namespace cable_variation_ros {

using cable_variation::SimulateVariationFeedback;
using cable_variation::SimulateVariationGoal;
using cable_variation::SimulateVariationRequest;
using cable_variation::SimulateVariationResult;
using cable_variation::SimulationProgress;

namespace {

constexpr double kFeedbackPeriod = 0.1;  // [s]

SimulateVariationFeedback toFeedback(const SimulationProgress& progress,
                                     const std::vector<std::string>& measures, double elapsed) {
  SimulateVariationFeedback feedback;
  feedback.samples = progress.samples;
  feedback.wanted = progress.wanted;
  feedback.elapsed = elapsed;
  feedback.remaining = progress.samples == 0 || std::isnan(progress.remaining) ? -1.0 : progress.remaining;
  feedback.snapped = progress.snapped;
  feedback.failed = progress.failed;
  feedback.measures = measures;
  feedback.mean = progress.mean;
  feedback.sigma = progress.sigma;
  return feedback;
}

}  // namespace

SimulateVariationServer::SimulateVariationServer(ros::NodeHandle& node, SimulationRunner& runner)
    : runner_(runner),
      server_(std::make_unique<actionlib::SimpleActionServer<cable_variation::SimulateVariationAction>>(
          node, kSimulateVariationAction,
          [this](const cable_variation::SimulateVariationGoalConstPtr& goal) { execute(*goal); }, false)) {
  server_->start();
}

SimulateVariationServer::~SimulateVariationServer() = default;

void SimulateVariationServer::execute(const SimulateVariationGoal& goal) {
  const ros::WallTime start = ros::WallTime::now();
  double told = -kFeedbackPeriod;
  const auto watch = [&](const SimulationProgress& progress, const std::vector<std::string>& measures) {
    const double elapsed = (ros::WallTime::now() - start).toSec();
    if (elapsed - told >= kFeedbackPeriod) {
      server_->publishFeedback(toFeedback(progress, measures, elapsed));
      told = elapsed;
    }
    return ros::ok() && !server_->isPreemptRequested();
  };
  endGoal(*server_, sameFields<SimulateVariationResult>(
                        runner_.run(sameFields<SimulateVariationRequest>(goal), watch)));
}

}  // namespace cable_variation_ros
