#include <ros_interface/interaction/drag_server.h>

#include <algorithm>
#include <utility>
#include <variant>

#include <boost/make_shared.hpp>
#include <ros/callback_queue.h>
#include <ros/console.h>
#include <ros/node_handle.h>

#include <cable_variation/harness/clip_preset.h>
#include <cable_variation/scene/added_cable.h>
#include <ros_interface/context/solver_context.h>
#include <ros_interface/conversion/message_conversion.h>
#include <ros_interface/conversion/same_poses.h>
#include <ros_interface/interaction/added_cable.h>
#include <ros_interface/interaction/added_clip.h>
#include <ros_interface/interaction/mouse_pose.h>
#include <ros_interface/node/names.h>
#include <ros_interface/node/queued_call.h>
#include <cable_variation/analysis/name_lookup.h>

namespace cable_variation_ros {

using cable_variation::Design;
using cable_variation::Pose;
using Kind = DragTarget::Kind;
using visualization_msgs::InteractiveMarkerFeedback;

namespace {

constexpr double kTick = 0.1;       // how often markers follow what they belong to [s]
constexpr int kCalmTicks = 3;       // before a cable gets its sheath
constexpr double kClipSize = 0.06;  // of arrows and rings together [m]
constexpr double kComponentSize = 0.10;

/// What a design variable is of: the marker's kind and the thing's index.
std::pair<Kind, std::size_t> subjectOf(const cable_variation::DesignTarget& target, bool& known) {
  using namespace cable_variation;
  known = true;
  if (const auto* t = std::get_if<ClipTranslation>(&target)) return {Kind::clip, t->clip};
  if (const auto* t = std::get_if<ClipRotation>(&target)) return {Kind::clip, t->clip};
  if (const auto* t = std::get_if<ClipArcLength>(&target)) return {Kind::clip, t->clip};
  if (const auto* t = std::get_if<CableProperty>(&target)) return {Kind::cable, t->cable};
  if (const auto* t = std::get_if<ComponentTranslation>(&target)) return {Kind::component, t->component};
  if (const auto* t = std::get_if<ComponentRotation>(&target)) return {Kind::component, t->component};
  if (const auto* t = std::get_if<LocatorDeviation>(&target)) return {Kind::component, t->component};
  known = false;
  return {Kind::cable, 0};
}

}  // namespace

DragServer::DragServer(ros::NodeHandle& node, SolverContext& context,
                       std::function<void(const std::vector<std::string>&)> analyse)
    : context_(context), analyse_(std::move(analyse)), server_(node.resolveName(kInteractionTopic)) {
  DragActions actions;
  actions.analyse = [this](const DragTarget& target) { analyse_(variablesOf(target)); };
  actions.set_as_design = [this](const DragTarget& target) { setAsDesign(target); };
  actions.put_back = [this](const DragTarget& target) { putBack(target); };
  actions.reset = [this](const DragTarget& target) { reset(target); };
  actions.add_clip = [this](const DragTarget& target, const Eigen::Vector3d& point, const std::string& type) {
    addClip(target, point, type);
  };
  actions.add_cable = [this](const DragTarget& target, const Eigen::Vector3d& point) {
    addCable(target, point);
  };
  for (const Kind kind : {Kind::clip, Kind::component, Kind::cable}) menus_[kind] = dragMenu(kind, actions);
  tick_ = node.createWallTimer(ros::WallDuration(kTick), [this](const ros::WallTimerEvent&) {
    ++calm_;
    if (dragged_.empty()) refresh();
  });
}

DragServer::~DragServer() {
  ros::getGlobalCallbackQueue()->removeByID(reinterpret_cast<std::uint64_t>(this));
}

void DragServer::contextChanged() {
  outdated_ = true;
  calm_ = 0;
  if (loads_ != context_.loads() || !context_.edited()) before_.clear();  // another scene, or it was reset
  loads_ = context_.loads();
}

void DragServer::hear(const Feedback& feedback) {
  const std::string& marker = feedback->marker_name;
  if (feedback->event_type == InteractiveMarkerFeedback::BUTTON_CLICK) {
    if (open_.erase(marker) == 0) open_.insert(marker);
    outdated_ = true;
  } else if (feedback->event_type == InteractiveMarkerFeedback::MOUSE_UP) {
    follow();
    dragged_.clear();
    calm_ = 0;             // the cables' sheaths, which did not follow meanwhile, are laid anew
    shown_.erase(marker);  // where it was let go need not be where it is
    outdated_ = true;
  } else if (feedback->event_type == InteractiveMarkerFeedback::POSE_UPDATE) {
    try {
      wanted_ = fromPose(feedback->pose, "interactive marker '" + marker + "'");
      dragged_ = marker;
    } catch (const std::exception& error) {
      ROS_WARN_THROTTLE(5.0, "dragging: %s", error.what());
    }
    if (std::exchange(woken_, true)) return;
    // behind what has come since: only the newest pose is followed
    ros::getGlobalCallbackQueue()->addCallback(boost::make_shared<QueuedCall>([this] { follow(); }),
                                               reinterpret_cast<std::uint64_t>(this));
  }
}

void DragServer::follow() {
  if (!std::exchange(woken_, false) || dragged_.empty()) return;
  const DragTarget target = dragTargetOf(dragged_);
  remember(target);
  edit(target, [&](Design& design) {
    const Pose before = before_.at(target.markerName()).value_or(Pose());
    if (target.kind == Kind::clip) {
      placeClip(design, target.name, wanted_, context_.moved());
      const std::size_t index = indexOf(target.name, design.scene.harness.clips, "clip");
      setClipPose(design, target.name, mousePose(before, design.scene.clip_mounts[index].pose));
    } else {
      placeComponent(design, target.name, wanted_, context_.onTf());
      Pose& shift = design.shifts[target.name];
      shift = mousePose(before, shift);
    }
  });
}

void DragServer::edit(const DragTarget& target, const std::function<void(Design&)>& change) {
  try {
    Design design = context_.design();
    change(design);
    context_.adopt(std::move(design));
  } catch (const std::exception& error) {
    ROS_WARN_THROTTLE(1.0, "%s stays where it was: %s", target.markerName().c_str(), error.what());
  }
}

void DragServer::remember(const DragTarget& target) {
  const cable_variation::Scene& scene = context_.design().scene;
  Before now;
  if (target.kind == Kind::clip) {
    now = scene.clip_mounts[indexOf(target.name, scene.harness.clips, "clip")].pose;
  } else {
    const auto shift = context_.design().shifts.find(target.name);
    if (shift != context_.design().shifts.end()) now = shift->second;
  }
  before_.emplace(target.markerName(), now);
}

void DragServer::setAsDesign(const DragTarget& target) {
  before_.erase(target.markerName());
  outdated_ = true;
}

void DragServer::putBack(const DragTarget& target) {
  const auto before = before_.find(target.markerName());
  if (before == before_.end()) return;
  edit(target, [&](Design& design) {
    if (target.kind == Kind::clip) {
      setClipPose(design, target.name, before->second.value());
    } else if (before->second) {
      design.shifts[target.name] = *before->second;
    } else {
      design.shifts.erase(target.name);
    }
  });
  setAsDesign(target);
}

void DragServer::reset(const DragTarget& target) {
  const cable_variation::Scene& loaded = context_.loaded();
  edit(target, [&](Design& design) {
    if (target.kind == Kind::component) {
      design.shifts.erase(target.name);
      return;
    }
    const std::size_t index = indexOf(target.name, design.scene.harness.clips, "clip");
    if (index < loaded.clip_mounts.size()) {
      setClipPose(design, target.name, loaded.clip_mounts[index].pose);
    } else {
      removeClip(design, target.name);
    }
  });
  setAsDesign(target);
}

void DragServer::addClip(const DragTarget& target, const Eigen::Vector3d& point, const std::string& type) {
  const std::string cable = target.kind == Kind::cable ? target.name : "";
  const std::string component = target.kind == Kind::component ? target.name : "";
  edit(target, [&](Design& design) {
    AddedClip added = clipAt(context_, point, type, cable, component);
    cable_variation::addClip(design, std::move(added.clip), added.mount);
  });
}

void DragServer::addCable(const DragTarget& target, const Eigen::Vector3d& point) {
  edit(target, [&](Design& design) {
    AddedCable added = cableAt(context_, point, target.name);
    cable_variation::addCable(design, std::move(added.cable));
    for (AddedClip& end : added.ends) cable_variation::addClip(design, std::move(end.clip), end.mount);
  });
}

std::vector<std::string> DragServer::variablesOf(const DragTarget& target) const {
  const cable_variation::Scene& scene = context_.design().scene;
  const std::size_t index = target.kind == Kind::clip ? indexOf(target.name, scene.harness.clips, "clip")
                            : target.kind == Kind::cable
                                ? indexOf(target.name, scene.harness.cables, "cable")
                                : indexOf(target.name, scene.components, "component");
  std::vector<std::string> names;
  for (const cable_variation::DesignVariable& variable : scene.design_variables) {
    bool known = false;
    const auto subject = subjectOf(variable.target, known);
    if (known && subject == std::make_pair(target.kind, index)) names.push_back(variable.name);
  }
  return names;
}

void DragServer::show(const DragTarget& target, const Pose& pose, double size) {
  const std::string name = target.markerName();
  const Shown now{pose, open_.count(name) != 0, before_.count(name) != 0};
  const auto known = shown_.find(name);
  if (known != shown_.end() && known->second.open == now.open && known->second.changed == now.changed) {
    if (!same(known->second.pose, pose)) server_.setPose(name, toPose(pose));
  } else {
    server_.insert(dragMarker(target, pose, size, now.open, now.changed),
                   [this](const Feedback& feedback) { hear(feedback); });
    menus_.at(target.kind).apply(server_, name);
  }
  shown_[name] = now;
}

void DragServer::showCables() {
  for (std::size_t i = 0; i < context_.equilibrium().shapes.size(); ++i) {
    const auto marker = cableMarker(context_.equilibrium().shapes[i], context_.harness().cables[i]);
    server_.insert(marker, [](const Feedback&) {});
    menus_.at(Kind::cable).apply(server_, marker.name);
    cables_shown_.insert(marker.name);
  }
}

void DragServer::hideCables() {
  for (const std::string& marker : cables_shown_) server_.erase(marker);
  cables_shown_.clear();
}

void DragServer::refresh() {
  if (calm_ == kCalmTicks && context_.equilibrium().converged()) {
    showCables();
    server_.applyChanges();
  }
  if (!std::exchange(outdated_, false)) return;
  if (calm_ < kCalmTicks) hideCables();
  std::map<std::string, Shown> old = shown_;
  const cable_variation::Scene& scene = context_.design().scene;
  for (const cable_variation::Clip& clip : context_.harness().clips) {
    if (!isMounted(clip)) continue;
    const DragTarget target{Kind::clip, clip.name};
    old.erase(target.markerName());
    show(target, clip.pose, kClipSize);
  }
  const cable_variation::ComponentPoses poses = context_.components();
  for (const cable_variation::Component& component : scene.components) {
    const DragTarget target{Kind::component, component.name};
    old.erase(target.markerName());
    show(target, poses.at(component.name), kComponentSize);
  }
  for (const auto& [gone, shown] : old) {
    server_.erase(gone);
    shown_.erase(gone);
  }
  server_.applyChanges();
}

}  // namespace cable_variation_ros
