#include <ros_interface/live/tf_follower.h>

#include <algorithm>
#include <set>
#include <utility>

#include <boost/make_shared.hpp>
#include <ros/callback_queue.h>
#include <ros/console.h>
#include <ros/node_handle.h>

#include <ros_interface/context/solver_context.h>
#include <ros_interface/conversion/message_conversion.h>
#include <ros_interface/conversion/same_poses.h>
#include <ros_interface/node/names.h>
#include <ros_interface/node/queued_call.h>

namespace cable_variation_ros {

using cable_variation::CableEvent;
using cable_variation::Pose;

namespace {

constexpr double kLongestCheck = 0.1;  // between two looks at how old tf is [s]

}  // namespace

TfFollower::TfFollower(ros::NodeHandle& node, SolverContext& context, const TfFollowerOptions& options,
                       std::function<void(const std::vector<CableEvent>&)> tell)
    : context_(context),
      options_(options),
      tell_(std::move(tell)),
      watch_(options.timeout),
      design_number_(context.designNumber()),
      input_([this] { wake(); }) {
  constexpr bool kOnce = true, kStart = true;
  pause_ = node.createWallTimer(
      ros::WallDuration(1.0 / options.rate_hz), [this](const ros::WallTimerEvent&) { awake(); }, kOnce,
      !kStart);
  const double check = std::min(kLongestCheck, 0.25 * options.timeout);
  check_ =
      node.createWallTimer(ros::WallDuration(check), [this](const ros::WallTimerEvent&) { checkTime(); });
}

TfFollower::~TfFollower() {
  input_.stop();
  ros::getGlobalCallbackQueue()->removeByID(reinterpret_cast<std::uint64_t>(this));
}

void TfFollower::wake() {
  if (woken_.exchange(true)) return;
  ros::getGlobalCallbackQueue()->addCallback(boost::make_shared<QueuedCall>([this] { awake(); }),
                                             reinterpret_cast<std::uint64_t>(this));
}

void TfFollower::awake() {
  woken_ = false;
  const ros::WallDuration left = followed_ + ros::WallDuration(1.0 / options_.rate_hz) - ros::WallTime::now();
  if (left > ros::WallDuration(0.0)) {
    pause_.stop();
    pause_.setPeriod(left);
    pause_.start();
    return;
  }
  followed_ = ros::WallTime::now();
  follow();
}

TfFollower::Sight TfFollower::look() {
  Sight sight;
  const ros::Time now = ros::Time::now();
  const cable_variation::Scene& scene = context_.design().scene;
  const tf2_ros::Buffer& buffer = input_.buffer();
  for (const cable_variation::Component& component : scene.components) {
    if (!buffer.canTransform(kWorldFrame, component.name, ros::Time(0))) continue;
    const geometry_msgs::TransformStamped transform =
        buffer.lookupTransform(kWorldFrame, component.name, ros::Time(0));
    const Pose pose = fromTransform(transform.transform, "tf frame '" + component.name + "'");
    if (!same(pose, componentPose(scene, component.name))) sight.moved[component.name] = pose;
    const ros::Time& stamp = transform.header.stamp;
    if (!stamp.isZero()) watch_.saw(component.name, stamp, now);
    sight.newest = std::max(sight.newest, stamp);
  }
  sight.stamped = !sight.newest.isZero();
  if (!sight.stamped) sight.newest = now;  // nothing on tf, or all of it static
  return sight;
}

void TfFollower::follow() {
  try {
    const Sight sight = look();
    if (!same(sight.moved, context_.onTf())) {
      context_.move(sight.moved, sight.newest);
    } else if (sight.stamped) {
      context_.confirm(sight.newest);
    }
  } catch (const std::exception& error) {
    ROS_WARN_THROTTLE(5.0, "live: %s", error.what());
  }
}

void TfFollower::checkTime() {
  if (design_number_ != context_.designNumber()) {  // another scene, perhaps
    design_number_ = context_.designNumber();
    std::set<std::string> components;
    for (const auto& component : context_.design().scene.components) components.insert(component.name);
    watch_.keepOnly(components);
    wake();
  }
  const std::size_t times_back = input_.timesBack();
  if (times_back != times_back_) {
    times_back_ = times_back;
    watch_.restart();
    CableEvent event;
    event.header.stamp = ros::Time::now();
    event.kind = CableEvent::TIME_WENT_BACK;
    event.text = "the clock was set back: tf starts afresh";
    tell_({event});
  }
  for (const cable_variation::Component& component : context_.design().scene.components) {
    const bool by_joint = component.joint && component.joint->type != cable_variation::LinkJoint::Type::fixed;
    if (by_joint || component.driven_by == cable_variation::ComponentDriver::tf)
      watch_.expect(component.name, ros::Time::now());
  }
  tell_(watch_.eventsAt(ros::Time::now()));
}

}  // namespace cable_variation_ros
