#include <ros_interface/live/attachment_follower.h>

#include <exception>
#include <limits>
#include <string>

#include <ros/node_handle.h>

#include <cable_variation/tracking/attached_design.h>
#include <ros_interface/context/solver_context.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

using cable_variation::AttachmentWish;
using cable_variation::CableEvent;

AttachmentFollower::AttachmentFollower(ros::NodeHandle& node, SolverContext& context,
                                       std::function<void(const std::vector<CableEvent>&)> tell)
    : context_(context),
      tell_(std::move(tell)),
      subscriber_(node.subscribe(kMotionStateTopic, 1, &AttachmentFollower::hear, this)) {}

void AttachmentFollower::hear(const cable_variation::MotionState& state) {
  std::vector<AttachmentWish> wishes = scheduledAt(context_.design().scene, context_.harness(), state.time);
  went_back_ = went_back_ || state.time < time_;
  time_ = state.time;
  std::set<std::pair<std::size_t, bool>> wanted;
  for (const AttachmentWish& wish : wishes) wanted.emplace(wish.clip, wish.attached);
  if (wishes.empty() || !context_.equilibrium().converged()) {
    if (wishes.empty()) {
      refused_.clear();
      went_back_ = false;
    }
    return;
  }
  // What was let go or missed later in the motion is held again, wherever it is: this is no assembly.
  for (AttachmentWish& wish : wishes) {
    if (went_back_) wish.reach = std::numeric_limits<double>::infinity();
  }
  went_back_ = false;
  try {
    context_.attach(
        withAttachments(context_.design(), wishes, context_.harness(), context_.equilibrium()).design);
    refused_.clear();
  } catch (const std::exception& error) {
    if (refused_ == wanted) return;
    refused_ = wanted;
    CableEvent event;
    event.header.stamp = context_.stamp();
    event.kind = CableEvent::CLIP_REFUSED;
    event.clip = context_.harness().clips[wishes.front().clip].name;
    event.text = error.what();
    tell_({event});
  }
}

}  // namespace cable_variation_ros
