#include <ros_interface/services/set_attachment_service.h>

#include <cmath>
#include <utility>
#include <vector>

#include <ros/node_handle.h>

#include <cable_variation/equilibrium/require_converged.h>
#include <cable_variation/tracking/attached_design.h>
#include <ros_interface/context/measured_shape.h>
#include <ros_interface/context/solver_context.h>
#include <ros_interface/conversion/measure_conversion.h>
#include <ros_interface/conversion/message_conversion.h>
#include <ros_interface/live/shape_watch.h>
#include <ros_interface/node/names.h>
#include <cable_variation/analysis/name_lookup.h>
#include <cable_variation/analysis/request_fields.h>
#include <ros_interface/request/request_status.h>

namespace cable_variation_ros {

using cable_variation::AttachmentWish;
using cable_variation::SetAttachmentRequest;
using cable_variation::SetAttachmentResponse;

namespace {

/// The clip first, then those that open with it.
std::vector<AttachmentWish> wishesOf(const SetAttachmentRequest& request,
                                     const std::vector<cable_variation::Clip>& clips) {
  if (!(request.reach >= 0.0 && std::isfinite(request.reach)))
    cable_variation::refuse("reach", request.reach, "0 m or more");
  if (request.section > SetAttachmentRequest::CLOSEST)
    cable_variation::refuse("section", request.section, "DESIGN, 0, or CLOSEST, 1");
  std::vector<std::string> names = {request.clip};
  names.insert(names.end(), request.opens.begin(), request.opens.end());
  std::vector<AttachmentWish> wishes;
  for (const std::size_t index : indicesOf(names, clips, "clip")) {
    AttachmentWish wish;
    wish.clip = index;
    wish.attached = wishes.empty() && request.attached != 0;
    wish.closest = request.section == SetAttachmentRequest::CLOSEST;
    if (request.reach > 0.0) wish.reach = request.reach;
    wishes.push_back(wish);
  }
  return wishes;
}

void tellShape(const SolverContext& context, SetAttachmentResponse& response) {
  cable_variation::SolveEquilibriumResponse solved = toResponse(context.equilibrium(), context.harness());
  response.shapes = std::move(solved.shapes);
  response.clip_reactions = std::move(solved.clip_reactions);
  response.joint_reactions = std::move(solved.joint_reactions);
  response.energy = solved.energy;
  response.smallest_eigenvalue = solved.smallest_eigenvalue;
  response.residual = solved.residual;
}

}  // namespace

SetAttachmentService::SetAttachmentService(ros::NodeHandle& node, SolverContext& context,
                                           const Watchers& watchers)
    : context_(context),
      watchers_(watchers),
      server_(node.advertiseService(kSetAttachmentService, &SetAttachmentService::handle, this)) {}

bool SetAttachmentService::handle(SetAttachmentRequest& request, SetAttachmentResponse& response) {
  response.status = runRequest([&] {
    const std::vector<AttachmentWish> wishes = wishesOf(request, context_.harness().clips);
    requireConverged(context_.equilibrium());
    cable_variation::AttachedDesign wanted =
        withAttachments(context_.design(), wishes, context_.harness(), context_.equilibrium());
    context_.attach(std::move(wanted.design));
    const cable_variation::AttachedClips& attached = *context_.lastAttachment();
    response.arc_length = wanted.gaps.front().arc_length;
    response.gap = wanted.gaps.front().distance;
    response.gap_angle = wanted.gaps.front().angle;
    response.distance = attached.distance;
    response.energy_before = attached.energy_before;
    response.snapped = attached.followed.jump.has_value();
    response.events = watchers_.events.lastEvents();
    tellShape(context_, response);
    const cable_variation::Scene& scene = context_.design().scene;
    const std::vector<cable_variation::MeasureValue>& measured = watchers_.measured.values();
    for (std::size_t i = 0; i < measured.size(); ++i)
      response.measures.push_back(toResult(scene.measures[i], measured[i], scene));
  });
  return true;
}

}  // namespace cable_variation_ros
