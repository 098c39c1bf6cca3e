#include <ros_interface/moving_geometry.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include <ros/console.h>

#include <cable_variation/scene/deviations.h>
#include <cable_variation/scene/moving_components.h>
#include <cable_variation/util/name_list.h>
#include <ros_interface/conversion/message_conversion.h>
#include <ros_interface/conversion/scene_loading.h>
#include <ros_interface/node/names.h>
#include <ros_interface/request/request_status.h>

namespace cable_variation_ros {

using cable_variation::Component;
using cable_variation::ComponentDriver;
using cable_variation::Motion;
using cable_variation::Scene;

namespace {

const ros::WallDuration kStatePause(0.05);  // between two messages of the state
const ros::WallDuration kPatience(5.0);     // with joints that no message tells of
constexpr int kJointQueue = 100;            // messages

const Component& componentOf(const Scene& scene, const Motion& motion) {
  return scene.components[componentIndex(scene, motion.component)];
}

// Without the motions of what others drive.
Scene loadMotions(const std::string& address, const cable_variation::InputLimits& limits) {
  Scene scene = loadScene(address, limits);
  const auto driven = [&](const Motion& motion) {
    return componentOf(scene, motion).driven_by != ComponentDriver::scene;
  };
  scene.motions.erase(std::remove_if(scene.motions.begin(), scene.motions.end(), driven),
                      scene.motions.end());
  std::map<std::string, std::string> mover;
  for (const Motion& motion : scene.motions) {
    const auto [other, first] = mover.emplace(motion.component, motion.name);
    if (!first) {
      throw std::invalid_argument("motions '" + other->second + "' and '" + motion.name +
                                  "' both move component '" + motion.component + "', expected one");
    }
  }
  return scene;
}

double longest(const Scene& scene) {
  double duration = 0.0;
  for (const Motion& motion : scene.motions) duration = std::max(duration, motion.duration());
  return duration;
}

}  // namespace

MovingGeometry::MovingGeometry(ros::NodeHandle node, const MovingGeometryParameters& parameters)
    : node_(node),
      parameters_(parameters),
      components_(node),
      state_(node.advertise<cable_variation::MotionState>(kMotionStateTopic, 1, true)),
      play_server_(node.advertiseService(kPlayService, &MovingGeometry::play, this)),
      seek_server_(node.advertiseService(kSeekService, &MovingGeometry::seek, this)),
      follower_(node, parameters.scene, [this](const std::string& address) { load(address); }) {
  if (parameters.scene.empty()) {
    take(Scene());
    ROS_INFO("moving_geometry_node is up, waiting for a scene on %s", node.resolveName(kDesignTopic).c_str());
  } else {
    load(parameters.scene);
  }
  timer_ = node.createTimer(ros::Duration(1.0 / parameters.rate_hz), &MovingGeometry::tick, this);
}

void MovingGeometry::load(const std::string& address) {
  take(loadMotions(address, parameters_.limits));
  ROS_INFO("moving_geometry_node plays %zu motions of %s%s", scene_->motions.size(), scene_->source.c_str(),
           joints_->hasJoints() ? (" and follows " + parameters_.joint_states).c_str() : "");
}

void MovingGeometry::take(Scene scene) {
  scene_ = std::make_shared<const Scene>(std::move(scene));
  player_ = std::make_unique<MotionPlayer>(longest(*scene_), parameters_.speed, parameters_.loop);
  player_->play(!halted_before_);
  halted_before_ = false;
  joints_ = std::make_unique<JointStateFollower>(*scene_);
  joint_states_.shutdown();
  if (joints_->hasJoints()) {
    joint_states_ =
        node_.subscribe(parameters_.joint_states, kJointQueue, &MovingGeometry::followJoints, this);
  }
  taken_ = ros::WallTime::now();
  const std::set<std::string> moving = movingComponents(*scene_);
  showStaticFrames(moving);
  components_.show(scene_, moving);
  told_at_ = ros::WallTime();
  publishState();
}

// Of what rides on something that moves.
void MovingGeometry::showStaticFrames(const std::set<std::string>& moving) {
  std::vector<geometry_msgs::TransformStamped> transforms;
  for (const Component& component : scene_->components) {
    if (moving.count(component.name) == 0 || movesItself(*scene_, component)) continue;
    if (component.driven_by == ComponentDriver::tf) continue;
    transforms.push_back(toTransform(component.pose, component.parent, component.name, ros::Time::now()));
  }
  static_broadcaster_.reset();  // it would go on telling of the frames of the scene before
  if (!transforms.empty()) {
    static_broadcaster_ = std::make_unique<tf2_ros::StaticTransformBroadcaster>();
    static_broadcaster_->sendTransform(transforms);
  }
}

void MovingGeometry::followJoints(const sensor_msgs::JointState& message) {
  std::vector<std::string> warnings;
  const auto transforms = joints_->take(message, ros::Time::now(), warnings);
  if (!transforms.empty()) broadcaster_.sendTransform(transforms);
  for (const std::string& warning : warnings)
    ROS_WARN("%s: %s", parameters_.joint_states.c_str(), warning.c_str());
}

void MovingGeometry::tellUnheard() {
  if (taken_.isZero() || ros::WallTime::now() - taken_ < kPatience) return;
  taken_ = ros::WallTime();
  const std::vector<std::string> unheard = joints_->unheard();
  if (unheard.empty()) return;
  ROS_WARN("%s has not told of %s: they are shown where the scene has them", parameters_.joint_states.c_str(),
           cable_variation::joined(unheard).c_str());
}

void MovingGeometry::tick(const ros::TimerEvent&) {
  const ros::Time now = ros::Time::now();
  if (!last_.isZero()) player_->advance((now - last_).toSec());
  last_ = now;
  sendTransforms();
  tellUnheard();
  publishState();
}

void MovingGeometry::sendTransforms() {
  std::vector<geometry_msgs::TransformStamped> transforms = joints_->waiting(last_);
  for (const Motion& motion : scene_->motions) {
    transforms.push_back(toTransform(poseAt(motion, player_->time()), componentOf(*scene_, motion).parent,
                                     motion.component, last_));
  }
  if (!transforms.empty()) broadcaster_.sendTransform(transforms);
}

void MovingGeometry::publishState() {
  const ros::WallTime now = ros::WallTime::now();
  if (now - told_at_ < kStatePause) return;
  cable_variation::MotionState state;
  state.duration = longest(*scene_);
  state.time = player_->time();
  state.playing = state.duration > 0.0 && player_->playing();
  if (!told_at_.isZero() && state.time == told_.time && state.playing == told_.playing) return;
  state_.publish(state);
  told_ = state;
  told_at_ = now;
}

bool MovingGeometry::play(std_srvs::SetBoolRequest& request, std_srvs::SetBoolResponse& response) {
  player_->play(request.data);
  halted_before_ = scene_->source.empty() && !request.data;
  response.success = !scene_->motions.empty();
  if (!response.success) {
    response.message = "scene '" + scene_->source + "' has no motions";
  }
  return true;
}

bool MovingGeometry::seek(cable_variation::SeekRequest& request, cable_variation::SeekResponse& response) {
  response.status = runRequest([&] { player_->seek(request.time); });
  return true;
}

}  // namespace cable_variation_ros
