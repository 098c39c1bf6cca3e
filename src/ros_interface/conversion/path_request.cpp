#include <ros_interface/conversion/path_request.h>

#include <cmath>
#include <stdexcept>

#include <ros_interface/conversion/message_conversion.h>
#include <cable_variation/analysis/name_lookup.h>
#include <cable_variation/analysis/request_fields.h>

namespace cable_variation_ros {

using cable_variation::CheckPathRequest;
using cable_variation::ComponentPoses;
using cable_variation::Design;
using cable_variation::TimedPose;

namespace {

constexpr double kUsualStep = 5e-3;  // [m]
// Recorded poses that are looked at one by one if no step is asked for; of more, steps.
constexpr std::size_t kMostPoses = 15'000;

bool rise(const std::vector<geometry_msgs::PoseStamped>& poses) {
  for (std::size_t i = 1; i < poses.size(); ++i) {
    if (!(poses[i].header.stamp > poses[i - 1].header.stamp)) return false;
  }
  return true;
}

bool anyStamp(const std::vector<geometry_msgs::PoseStamped>& poses) {
  for (const geometry_msgs::PoseStamped& pose : poses) {
    if (!pose.header.stamp.isZero()) return true;
  }
  return false;
}

/// The frame that the poses are in, in the world.
cable_variation::Pose frameOf(const std::string& frame, const Design& design, const ComponentPoses& moved) {
  if (frame.empty() || frame == "world") return {};
  indexOf(frame, design.scene.components, "component");  // throws
  return componentPosesAt(design.scene, design.shifted, moved).at(frame);
}

std::vector<TimedPose> posesOf(const CheckPathRequest& request, const Design& design,
                               const ComponentPoses& moved, std::vector<std::string>& warnings) {
  const std::vector<geometry_msgs::PoseStamped>& poses = request.path.poses;
  const cable_variation::Pose frame = frameOf(request.path.header.frame_id, design, moved);
  const bool timed = poses.size() > 1 && rise(poses);
  if (!timed && anyStamp(poses)) {
    warnings.emplace_back("path: the stamps of its poses do not rise; they are taken a second apart");
  }
  std::vector<TimedPose> timed_poses;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const double time =
        timed ? (poses[i].header.stamp - poses.front().header.stamp).toSec() : static_cast<double>(i);
    timed_poses.push_back({time, frame * fromPose(poses[i].pose, "path: pose " + std::to_string(i + 1))});
  }
  return timed_poses;
}

void checkFields(const CheckPathRequest& request) {
  const int ways = (request.component.empty() ? 0 : 1) + (request.clip.empty() ? 0 : 1) +
                   (request.motions.empty() ? 0 : 1);
  if (ways != 1) {
    throw std::invalid_argument(
        std::string("component, clip, motions: ") + (ways == 0 ? "none is" : "more than one is") +
        " given; expected one of them: a component or clip with a path, or recorded motions");
  }
  if (!request.motions.empty() && !request.path.poses.empty())
    throw std::invalid_argument("path: given with motions, expected none");
  if (!(request.step >= 0.0 && std::isfinite(request.step)))
    cable_variation::refuse("step", request.step, "0 m or more");
}

}  // namespace

PathRequest toPath(const CheckPathRequest& request, const Design& design,
                   const cable_variation::Harness& harness, const ComponentPoses& moved,
                   const ComponentPoses& on_tf) {
  checkFields(request);
  PathRequest result;
  result.step = request.step > 0.0 ? request.step : kUsualStep;
  if (!request.motions.empty()) {
    const std::vector<std::size_t> motions = playedMotions(request.motions, design.scene);
    const cable_variation::TimeSpan span = timesOf(motions, request.from_time, request.to_time, design.scene);
    if (!(span.to > span.from)) cable_variation::refuse("to_time", request.to_time, "more than from_time");
    result.over_motions = true;
    for (const std::string& motion : request.motions)
      result.about += (result.about.empty() ? "motion " : " and ") + motion;
    result.path = pathOfMotions(design, on_tf, motions, span.from, span.to);
    result.path.every_pose = request.step == 0.0 && result.path.times.size() <= kMostPoses;
    return result;
  }
  timesOf({}, request.from_time, request.to_time, design.scene);  // throws
  if (request.component.empty()) {
    indexOf(request.clip, harness.clips, "clip");  // throws
  } else {
    indexOf(request.component, design.scene.components, "component");  // throws
  }
  const std::vector<TimedPose> poses = posesOf(request, design, moved, result.warnings);
  result.about = (request.component.empty() ? "clip " + request.clip : "component " + request.component) +
                 " through " + std::to_string(poses.size()) + " poses";
  result.path = request.component.empty() ? pathOfClip(design, moved, harness, request.clip, poses)
                                          : pathOfComponent(design, moved, request.component, poses);
  return result;
}

}  // namespace cable_variation_ros
