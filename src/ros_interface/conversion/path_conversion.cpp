#include <ros_interface/conversion/path_conversion.h>

#include <limits>

#include <ros_interface/conversion/event_conversion.h>
#include <ros_interface/conversion/measure_conversion.h>
#include <ros_interface/conversion/message_conversion.h>

namespace cable_variation_ros {

using cable_variation::CheckPathResponse;
using cable_variation::PathBend;
using cable_variation::PathCheck;
using cable_variation::PathMeasure;
using cable_variation::PathReaction;
using cable_variation::PathSample;
using cable_variation::Scene;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

PathMeasure toMeasure(const Scene& scene, const PathCheck& check, std::size_t index) {
  const cable_variation::Measure& measure = scene.measures[index];
  auto message = described<PathMeasure>(measure);
  for (const PathSample& sample : check.samples)
    message.values.push_back(sample.solved ? sample.measures[index].value : kNaN);
  const cable_variation::PathWorst worst = worstAlong(check, measure, index);
  message.smallest = worst.smallest;
  message.largest = worst.largest;
  message.worst = worst.worst;
  message.worst_time = worst.time;
  message.within = static_cast<std::uint8_t>(worst.within);
  return message;
}

PathReaction toReaction(const Scene& scene, const PathCheck& check, std::size_t index) {
  const cable_variation::Clip& clip = scene.harness.clips[index];
  PathReaction message;
  message.clip = clip.name;
  message.cable = scene.harness.cables[clip.cable].name;
  for (const PathSample& sample : check.samples) {
    geometry_msgs::Wrench wrench;
    wrench.force = toVector(sample.solved ? sample.reactions[index].force : Eigen::Vector3d::Constant(kNaN));
    wrench.torque =
        toVector(sample.solved ? sample.reactions[index].moment : Eigen::Vector3d::Constant(kNaN));
    message.wrenches.push_back(wrench);
    message.arc_lengths.push_back(sample.solved ? sample.reactions[index].arc_length : kNaN);
  }
  const cable_variation::LargestReaction largest = largestReaction(check, index);
  message.largest_force = largest.force;
  message.largest_force_time = largest.force_time;
  message.largest_moment = largest.moment;
  message.largest_moment_time = largest.moment_time;
  return message;
}

PathBend toBend(const Scene& scene, const PathCheck& check, std::size_t cable) {
  PathBend message;
  message.cable = scene.harness.cables[cable].name;
  for (const PathSample& sample : check.samples) {
    message.smallest_bend_radius.push_back(sample.solved ? sample.bends[cable].radius : kNaN);
    message.arc_lengths.push_back(sample.solved ? sample.bends[cable].arc_length : kNaN);
  }
  const cable_variation::TightestBend tightest = tightestBend(check, cable);
  message.smallest = tightest.radius;
  message.smallest_time = tightest.time;
  return message;
}

}  // namespace

CheckPathResponse toResponse(const Scene& scene, const PathCheck& check,
                             const cable_variation::ComponentPath& path) {
  CheckPathResponse response;
  for (const PathSample& sample : check.samples) {
    response.times.push_back(sample.time);
    response.lengths.push_back(sample.length);
    response.solved.push_back(static_cast<std::uint8_t>(sample.solved));
    response.smallest_eigenvalue.push_back(sample.smallest_eigenvalue);
    if (path.frame) response.poses.push_back(toPose(path.frame(sample.time)));
  }
  for (std::size_t i = 0; i < scene.measures.size(); ++i)
    response.measures.push_back(toMeasure(scene, check, i));
  for (std::size_t i = 0; i < scene.harness.clips.size(); ++i)
    response.reactions.push_back(toReaction(scene, check, i));
  for (std::size_t i = 0; i < scene.harness.cables.size(); ++i)
    response.bends.push_back(toBend(scene, check, i));
  for (const cable_variation::TimedEvent& each : check.events) {
    cable_variation::PathEvent event;
    event.time = each.time;
    event.length = each.length;
    event.event = toMessage(each.event, ros::Time(each.time));
    response.events.push_back(event);
  }
  response.kept = static_cast<std::uint8_t>(check.kept);
  response.solves = static_cast<std::uint32_t>(check.solves);
  response.warnings = check.warnings;
  return response;
}

}  // namespace cable_variation_ros
