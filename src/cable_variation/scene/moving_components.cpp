#include <cable_variation/scene/moving_components.h>

#include <algorithm>
#include <stdexcept>

namespace cable_variation {

namespace {

const Component& componentNamed(const Scene& scene, const std::string& name) {
  for (const Component& component : scene.components) {
    if (component.name == name) return component;
  }
  throw std::invalid_argument("no component named '" + name + "'");
}

/// How many components it rides on.
int depth(const Scene& scene, const std::string& name) {
  int count = 0;
  for (std::string next = name; next != "world"; next = componentNamed(scene, next).parent) ++count;
  return count;
}

}  // namespace

std::set<std::string> movingComponents(const Scene& scene) {
  std::set<std::string> own;
  for (const Component& component : scene.components) {
    if (movesItself(scene, component)) own.insert(component.name);
  }
  std::set<std::string> moving;
  for (const Component& component : scene.components) {
    for (std::string next = component.name; next != "world"; next = componentNamed(scene, next).parent) {
      if (own.count(next) != 0) moving.insert(component.name);
    }
  }
  return moving;
}

bool movesItself(const Scene& scene, const Component& component) {
  if (component.joint) return component.joint->type != LinkJoint::Type::fixed;
  if (component.driven_by != ComponentDriver::scene) return false;
  return std::any_of(scene.motions.begin(), scene.motions.end(),
                     [&](const Motion& motion) { return motion.component == component.name; });
}

std::vector<std::size_t> bodiesOf(const Scene& scene, std::size_t component) {
  const std::string& name = scene.components.at(component).name;
  std::vector<std::size_t> bodies{component};
  for (std::size_t i = 0; i < scene.components.size(); ++i) {
    if (i != component && scene.components[i].robot == name)
      bodies.push_back(i);  // a robot's root is its own
  }
  return bodies;
}

bool sameRobot(const Component& a, const Component& b) {
  return a.name == b.name || (!a.robot.empty() && a.robot == b.robot);
}

bool ridesOn(const Scene& scene, std::size_t clip, const Component& component) {
  const std::string& mount = scene.clip_mounts[clip].component;
  if (mount == component.name) return true;
  if (component.robot.empty() || mount == "world") return false;
  return sameRobot(componentNamed(scene, mount), component);
}

ComponentPoses posesDuring(const Scene& scene, const std::vector<const Motion*>& motions, double time) {
  std::vector<const Motion*> parents_first = motions;
  std::stable_sort(parents_first.begin(), parents_first.end(), [&](const Motion* a, const Motion* b) {
    return depth(scene, a->component) < depth(scene, b->component);
  });
  ComponentPoses poses;
  for (const Motion* motion : parents_first) {
    const Component& component = componentNamed(scene, motion->component);
    poses[component.name] = componentPose(scene, component.parent, poses) * poseAt(*motion, time);
  }
  return poses;
}

Pose poseIn(const ComponentPoses& poses, const std::string& component) {
  return component == "world" ? Pose() : poses.at(component);
}

}  // namespace cable_variation
