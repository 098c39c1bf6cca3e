#include <cable_variation/scene_file/plausibility.h>

#include <algorithm>
#include <set>

#include <cable_variation/harness/clip_preset.h>
#include <cable_variation/scene_file/slip_checks.h>

namespace cable_variation {
namespace {

// Whether a component is, or rides on, another.
bool rides(const Scene& scene, std::string name, const std::string& on) {
  for (std::size_t i = 0; i <= scene.components.size() && name != "world"; ++i) {
    if (name == on) return true;
    const auto it = std::find_if(scene.components.begin(), scene.components.end(),
                                 [&](const Component& component) { return component.name == name; });
    if (it == scene.components.end()) return false;
    name = it->parent;
  }
  return false;
}

// The shortest cable that is held both by what a motion moves and by something else; null: none.
const Cable* bridgingCable(const Motion& motion, const Scene& scene) {
  std::set<std::size_t> moved, kept;
  for (std::size_t i = 0; i < scene.clip_mounts.size(); ++i) {
    const Clip& clip = scene.harness.clips[i];
    if (!isMounted(clip)) continue;
    (rides(scene, scene.clip_mounts[i].component, motion.component) ? moved : kept).insert(clip.cable);
  }
  const Cable* shortest = nullptr;
  for (const std::size_t index : moved) {
    const Cable& cable = scene.harness.cables[index];
    if (kept.count(index) > 0 && (!shortest || cable.length < shortest->length)) shortest = &cable;
  }
  return shortest;
}

}  // namespace

std::string slipOf(const Motion& motion, const Scene& scene) {
  constexpr double kLongest = 30.0 * 86400.0;  // [s]
  constexpr double kReaches = 2.0;             // cable lengths between its ends, whatever they are held by
  if (motion.samples.empty()) return "";
  if (motion.duration() > kLongest) {
    return "its poses span " + shortNumber(motion.duration()) + " s, which is " +
           shortNumber(motion.duration() / 86400.0) + " days; expected seconds; in ns?";
  }
  double way = 0.0;
  for (const TimedPose& sample : motion.samples) {
    way = std::max(way, (sample.pose.position - motion.samples.front().pose.position).norm());
  }
  const Cable* cable = bridgingCable(motion, scene);
  if (!cable || !(way > kReaches * cable->length)) return "";
  return "component '" + motion.component + "' moves by " + shortNumber(way) + " m, which cable '" +
         cable->name + "' of " + shortNumber(cable->length) + " m cannot follow; in mm?";
}

void warnOfSlips(const YamlCursor& root, const Scene& scene) {
  checkWorld(root, scene);
  checkMaterials(root);
  checkComponents(root, scene);
  checkCables(root, scene);
  checkRouting(root, scene);
  checkForces(root, scene);
  checkTolerances(root, scene);
  checkLimits(root, scene);
  const std::vector<YamlCursor> motions = namedItems(root, "motions", "motion");
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const std::string slip = slipOf(scene.motions[i], scene);
    if (!slip.empty()) motions[i].warn(slip);
  }
}

}  // namespace cable_variation
