#include <cable_variation/envelope/clearance/clearance_skips.h>

#include <algorithm>

#include <cable_variation/scene/deviations.h>
#include <cable_variation/scene/measure_traits.h>
#include <cable_variation/scene/moving_components.h>

namespace cable_variation {
namespace {

bool has(const std::vector<std::size_t>& list, std::size_t index) {
  return std::find(list.begin(), list.end(), index) != list.end();
}

}  // namespace

double skippedNearClips(const Scene& scene, const ClearanceOptions& options, std::size_t cable,
                        std::size_t component) {
  if (options.skip_near_clips) return *options.skip_near_clips;
  std::optional<double> smallest;
  for (const Measure& measure : scene.measures) {
    if (!traitsOf(measure.type).clearance || !measure.component) continue;
    if (!has(bodiesOf(scene, *measure.component), component) || !has(measure.cables, cable)) continue;
    smallest = std::min(smallest.value_or(measure.skip_near_clips), measure.skip_near_clips);
  }
  return smallest.value_or(ClearanceOptions::kNearClips);
}

double skippedNearJoints(const Scene& scene, const ClearanceOptions& options, std::size_t cable,
                         std::size_t other, double radii) {
  if (options.skip_near_joints) return *options.skip_near_joints;
  std::optional<double> smallest;
  for (const Measure& measure : scene.measures) {
    if (!traitsOf(measure.type).clearance || measure.component) continue;
    if (!(has(measure.cables, cable) && has(measure.other_cables, other)) &&
        !(has(measure.cables, other) && has(measure.other_cables, cable))) {
      continue;
    }
    smallest = std::min(smallest.value_or(measure.skip_near_joints), measure.skip_near_joints);
  }
  return smallest.value_or(4.0 * radii);
}

std::vector<std::size_t> clipsBetween(const Scene& scene, const Harness& harness, std::size_t cable,
                                      const std::string& component) {
  std::vector<std::size_t> clips;
  const Component& part = scene.components[componentIndex(scene, component)];
  for (std::size_t i = 0; i < harness.clips.size(); ++i) {
    const Clip& clip = harness.clips[i];
    if (clip.attached && clip.cable == cable && ridesOn(scene, i, part)) clips.push_back(i);
  }
  return clips;
}

std::vector<SkippedStretch> stretchesNearClips(const Scene& scene, const Harness& harness,
                                               const Equilibrium& equilibrium, std::size_t cable,
                                               const std::string& component, double near) {
  std::vector<SkippedStretch> stretches;
  if (!(near > 0.0)) return stretches;
  for (const std::size_t clip : clipsBetween(scene, harness, cable, component)) {
    const double held = equilibrium.clip_reactions[clip].arc_length;
    stretches.push_back({held - near, held + near});
  }
  return stretches;
}

}  // namespace cable_variation
