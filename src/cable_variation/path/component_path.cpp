#include <cable_variation/path/component_path.h>

#include <algorithm>
#include <memory>
#include <set>
#include <stdexcept>

#include <cable_variation/scene/deviations.h>
#include <cable_variation/scene/moving_components.h>
#include <cable_variation/util/quantity.h>

namespace cable_variation {

namespace {

const Component& componentNamed(const Scene& scene, const std::string& name) {
  return scene.components[componentIndex(scene, name)];
}

/// The closest of `taken` that a component rides on; empty: none.
std::string carrierAmong(const Scene& scene, const std::string& component, const ComponentPoses& taken) {
  for (std::string at = componentNamed(scene, component).parent; at != "world";
       at = componentNamed(scene, at).parent) {
    if (taken.count(at) != 0) return at;
  }
  return "";
}

/// `moved` with some components elsewhere; what rides on them keeps its place on them.
ComponentPoses withTaken(const Scene& scene, const ComponentPoses& moved, const ComponentPoses& taken) {
  ComponentPoses places = taken;
  for (const auto& [component, pose] : moved) {
    if (taken.count(component) != 0) continue;
    const std::string carrier = carrierAmong(scene, component, taken);
    places[component] =
        carrier.empty() ? pose : taken.at(carrier) * componentPose(scene, carrier, moved).inverse() * pose;
  }
  return places;
}

void checkPoses(const std::vector<TimedPose>& poses) {
  if (poses.size() < 2) {
    throw std::invalid_argument("path: has " + std::to_string(poses.size()) +
                                " poses, expected two at least");
  }
  for (std::size_t i = 1; i < poses.size(); ++i) {
    if (poses[i].time > poses[i - 1].time) continue;
    throw std::invalid_argument("path: pose " + std::to_string(i + 1) + " is at " +
                                shortNumber(poses[i].time) + " s, expected more than the " +
                                shortNumber(poses[i - 1].time) + " s of the one before");
  }
}

/// A frame on a component, and where everything else is.
struct Traveller {
  Design design;
  ComponentPoses moved;
  std::string component;
  Pose within;  ///< of the frame, in the component's as it is

  /// With the frame at `target`. `places` tell of components as designed, off which deviations take them:
  /// what is left of the gap shrinks by as much as those turn the component, each time.
  ComponentPoses placesAt(const Pose& target) const {
    constexpr int kMost = 30;
    constexpr double kClose = 1e-13;  // [m], [1]
    const Pose back = within.inverse();
    Pose designed = target * back;
    ComponentPoses places;
    for (int i = 0; i < kMost; ++i) {
      places = withTaken(design.scene, moved, {{component, designed}});
      if (design.shifted.empty()) break;
      const Pose is = componentPosesAt(design.scene, design.shifted, places).at(component);
      const Pose gap = (is * within).inverse() * target;
      if (gap.position.norm() <= kClose && gap.orientation.vec().norm() <= kClose) break;
      designed = designed * (within * gap * back);
    }
    return places;
  }
};

ComponentPath pathOfFrame(Traveller traveller, const std::vector<TimedPose>& poses) {
  checkPoses(poses);
  ComponentPath path;
  path.every_pose = true;
  for (const TimedPose& pose : poses) path.times.push_back(pose.time);
  const auto way = std::make_shared<Motion>();
  way->samples = poses;
  path.frame = [way](double time) { return poseAt(*way, time); };
  path.places = [shared = std::make_shared<const Traveller>(std::move(traveller)), way](double time) {
    return shared->placesAt(poseAt(*way, time));
  };
  return path;
}

}  // namespace

ComponentPath pathOfComponent(const Design& design, const ComponentPoses& moved, const std::string& component,
                              const std::vector<TimedPose>& poses) {
  if (component == "world") throw std::invalid_argument("component: 'world' goes nowhere");
  componentIndex(design.scene, component);  // throws
  return pathOfFrame({design, moved, component, Pose()}, poses);
}

ComponentPath pathOfClip(const Design& design, const ComponentPoses& moved, const Harness& harness,
                         const std::string& clip, const std::vector<TimedPose>& poses) {
  const auto found = std::find_if(harness.clips.begin(), harness.clips.end(),
                                  [&](const Clip& each) { return each.name == clip; });
  if (found == harness.clips.end()) throw std::invalid_argument("no clip named '" + clip + "'");
  const auto index = static_cast<std::size_t>(found - harness.clips.begin());
  const std::string& component = design.scene.clip_mounts[index].component;
  if (component == "world") {
    throw std::invalid_argument("clip '" + clip +
                                "' is on the world, which goes nowhere; expected one of a " + "component");
  }
  const Pose carrier = componentPosesAt(design.scene, design.shifted, moved).at(component);
  return pathOfFrame({design, moved, component, carrier.inverse() * found->pose}, poses);
}

ComponentPath pathOfMotions(const Design& design, const ComponentPoses& on_tf,
                            const std::vector<std::size_t>& motions, double from, double to) {
  const auto own = std::make_shared<const Design>(design);
  std::vector<const Motion*> played;
  std::set<double> times{from, to};
  for (const std::size_t index : motions) {
    played.push_back(&own->scene.motions.at(index));
    for (const TimedPose& sample : played.back()->samples) {
      if (sample.time > from && sample.time < to) times.insert(sample.time);
    }
  }
  ComponentPath path;
  path.times.assign(times.begin(), times.end());
  path.places = [own, on_tf, played](double time) {
    return placesOf(*own, withTaken(own->scene, on_tf, posesDuring(own->scene, played, time)));
  };
  if (played.size() == 1) {
    path.frame = [own, places = path.places, component = played.front()->component](double time) {
      return componentPosesAt(own->scene, own->shifted, places(time)).at(component);
    };
  }
  return path;
}

}  // namespace cable_variation
