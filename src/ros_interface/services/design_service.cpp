#include <ros_interface/services/design_service.h>

#include <utility>

#include <ros/console.h>
#include <ros/node_handle.h>

#include <cable_variation/scene/design_slips.h>
#include <ros_interface/context/solver_context.h>
#include <ros_interface/conversion/design_request.h>
#include <ros_interface/conversion/message_conversion.h>
#include <ros_interface/node/names.h>
#include <ros_interface/request/request_status.h>

namespace cable_variation_ros {

using cable_variation::Design;
using cable_variation::SceneFault;
using cable_variation::Status;

namespace {

/// Implausible edits of a design; they are then among the warnings of its scene, wherever these are
/// told.
std::vector<std::string> warnOfEdits(const cable_variation::Scene& loaded, Design& design,
                                     const cable_variation::SetDesignRequest& request) {
  std::vector<std::string> texts = cable_variation::newSlips({loaded, {}}, design);
  design.scene.warnings = loaded.warnings;
  for (const std::string& text : texts) design.scene.warnings.push_back({kSetDesignService, 0, text});
  for (const cable_variation::ClipEdit& edit : request.clips) {
    const std::string who = "clip '" + edit.clip + "', ";
    const std::string turn = cable_variation::turnSlip(fromVector(edit.rotation).norm());
    const std::string shift = cable_variation::shiftSlip(design.scene, fromVector(edit.translation).norm());
    if (!turn.empty()) texts.push_back(who + "rotation: " + turn);
    if (!shift.empty()) texts.push_back(who + "translation: " + shift);
  }
  return texts;
}

}  // namespace

DesignService::DesignService(ros::NodeHandle& node, SolverContext& context)
    : context_(context),
      set_server_(node.advertiseService(kSetDesignService, &DesignService::set, this)),
      reset_server_(node.advertiseService(kResetDesignService, &DesignService::reset, this)) {}

bool DesignService::set(cable_variation::SetDesignRequest& request,
                        cable_variation::SetDesignResponse& response) {
  response.status = runRequest([&] {
    Design design = edited(context_.design(), request);
    response.warnings = warnOfEdits(context_.loaded(), design, request);
    for (const std::string& warning : response.warnings)
      ROS_WARN("%s: %s", kSetDesignService, warning.c_str());
    context_.adopt(std::move(design));
  });
  return true;
}

bool DesignService::reset(std_srvs::TriggerRequest&, std_srvs::TriggerResponse& response) {
  const Status status = runRequest([&] { context_.reset(); });
  response.success = status.code == Status::SUCCESS;
  response.message = status.message;
  return true;
}

}  // namespace cable_variation_ros
