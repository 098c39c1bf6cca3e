#include <ros_interface/display/live_publisher.h>

#include <limits>

#include <geometry_msgs/WrenchStamped.h>
#include <std_msgs/Float64.h>

#include <cable_variation/ClipReactions.h>
#include <cable_variation/LiveMeasures.h>

#include <cable_variation/equilibrium/require_converged.h>
#include <cable_variation/harness/clip_preset.h>
#include <ros_interface/context/solver_context.h>
#include <ros_interface/conversion/clip_frame.h>
#include <ros_interface/conversion/measure_conversion.h>
#include <ros_interface/conversion/message_conversion.h>
#include <ros_interface/node/names.h>
#include <ros_interface/node/topic_names.h>
#include <ros_interface/request/request_status.h>

namespace cable_variation_ros {

using cable_variation::ClipReactions;
using cable_variation::Equilibrium;
using cable_variation::LiveMeasures;
using cable_variation::MeasureValue;
using cable_variation::Scene;

namespace {

constexpr bool kLatched = true;

template <typename Named>
std::vector<std::string> namesOf(const std::vector<Named>& all) {
  std::vector<std::string> names;
  for (const Named& each : all) names.push_back(each.name);
  return names;
}

std_msgs::Header headerOf(const SolverContext& context) {
  std_msgs::Header header;
  header.stamp = context.stamp();
  header.frame_id = kWorldFrame;
  return header;
}

LiveMeasures toMeasures(const SolverContext& context, const std::vector<MeasureValue>& measured) {
  LiveMeasures message;
  message.header = headerOf(context);
  if (context.harness().cables.empty()) {
    message.smallest_eigenvalue = std::numeric_limits<double>::quiet_NaN();
    return message;
  }
  message.status = runRequest([&] { requireConverged(context.equilibrium()); });
  if (!context.equilibrium().converged()) return message;
  const Scene& scene = context.design().scene;
  message.smallest_eigenvalue = context.equilibrium().smallest_eigenvalue;
  for (std::size_t i = 0; i < measured.size(); ++i)
    message.measures.push_back(toResult(scene.measures[i], measured[i], scene));
  return message;
}

}  // namespace

LivePublisher::LivePublisher(const ros::NodeHandle& node, bool each_measure)
    : node_(node),
      each_measure_(each_measure),
      measures_(node_.advertise<LiveMeasures>(kMeasuresTopic, 1, kLatched)),
      reactions_(node_.advertise<ClipReactions>(kReactionsTopic, 1, kLatched)) {}

void LivePublisher::advertise(const SolverContext& context) {
  if (design_number_ == context.designNumber()) return;
  design_number_ = context.designNumber();
  const std::vector<cable_variation::Clip>& all = context.harness().clips;
  mounted_.clear();
  std::vector<std::string> clips;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!isMounted(all[i])) continue;
    mounted_.push_back(i);
    clips.push_back(all[i].name);
  }
  if (clips != clips_) {
    reaction_of_clip_.clear();
    for (const std::string& topic : topicNames(kReactionTopics, clips))
      reaction_of_clip_.push_back(node_.advertise<geometry_msgs::WrenchStamped>(topic, 1, kLatched));
    clips_ = clips;
  }
  if (!each_measure_) return;
  const std::vector<std::string> values = namesOf(context.design().scene.measures);
  if (values == values_) return;
  value_of_measure_.clear();
  for (const std::string& topic : topicNames(kLiveTopics, values))
    value_of_measure_.push_back(node_.advertise<std_msgs::Float64>(topic, 1, kLatched));
  values_ = values;
}

void LivePublisher::publish(const SolverContext& context, const std::vector<MeasureValue>& measured) {
  advertise(context);
  measures_.publish(toMeasures(context, measured));
  ClipReactions reactions;
  reactions.header = headerOf(context);
  reactions.reactions = toClipReactions(context.equilibrium(), context.harness());
  reactions_.publish(reactions);
  if (!context.equilibrium().converged()) return;
  for (std::size_t i = 0; i < mounted_.size(); ++i) {
    const cable_variation::Clip& clip = context.harness().clips[mounted_[i]];
    geometry_msgs::WrenchStamped message;
    message.header.stamp = context.stamp();
    message.header.frame_id = clipFrame(context.design().scene, clip.name);
    message.wrench = toWrench(context.equilibrium().clip_reactions[mounted_[i]], clip.pose);
    reaction_of_clip_[i].publish(message);
  }
  for (std::size_t i = 0; i < value_of_measure_.size() && i < measured.size(); ++i) {
    std_msgs::Float64 message;
    message.data = measured[i].value;
    value_of_measure_[i].publish(message);
  }
}

}  // namespace cable_variation_ros
