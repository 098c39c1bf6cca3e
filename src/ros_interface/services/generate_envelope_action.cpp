#include <ros_interface/services/generate_envelope_action.h>

#include <ros/node_handle.h>

#include <cable_variation/GenerateEnvelope.h>

#include <ros_interface/node/names.h>
#include <ros_interface/node/same_fields.h>
#include <ros_interface/runs/action_end.h>
#include <ros_interface/runs/envelope_runner.h>

namespace cable_variation_ros {

using cable_variation::GenerateEnvelopeFeedback;
using cable_variation::GenerateEnvelopeGoal;
using cable_variation::GenerateEnvelopeRequest;
using cable_variation::GenerateEnvelopeResult;

namespace {

constexpr double kFeedbackPeriod = 0.1;     // [s]
constexpr double kEnoughToEstimate = 0.02;  // share done

GenerateEnvelopeFeedback toFeedback(const RunProgress& progress, double elapsed) {
  GenerateEnvelopeFeedback feedback;
  feedback.stage = progress.stage;
  feedback.share = progress.share;
  feedback.solves = static_cast<std::uint32_t>(progress.solves);
  feedback.time = progress.time;
  feedback.elapsed = elapsed;
  feedback.remaining =
      progress.share > kEnoughToEstimate ? elapsed * (1.0 - progress.share) / progress.share : -1.0;
  return feedback;
}

}  // namespace

GenerateEnvelopeServer::GenerateEnvelopeServer(ros::NodeHandle& node, EnvelopeRunner& runner)
    : runner_(runner),
      server_(std::make_unique<actionlib::SimpleActionServer<cable_variation::GenerateEnvelopeAction>>(
          node, kGenerateEnvelopeAction,
          [this](const cable_variation::GenerateEnvelopeGoalConstPtr& goal) { execute(*goal); }, false)) {
  server_->start();
}

GenerateEnvelopeServer::~GenerateEnvelopeServer() = default;

void GenerateEnvelopeServer::execute(const GenerateEnvelopeGoal& goal) {
  const ros::WallTime start = ros::WallTime::now();
  double told = -kFeedbackPeriod;
  const auto watch = [&](const RunProgress& progress) {
    const double elapsed = (ros::WallTime::now() - start).toSec();
    if (elapsed - told >= kFeedbackPeriod) {
      server_->publishFeedback(toFeedback(progress, elapsed));
      told = elapsed;
    }
    return ros::ok() && !server_->isPreemptRequested();
  };
  endGoal(*server_,
          sameFields<GenerateEnvelopeResult>(runner_.run(sameFields<GenerateEnvelopeRequest>(goal), watch)));
}

}  // namespace cable_variation_ros
