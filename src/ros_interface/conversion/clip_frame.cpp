#include <ros_interface/conversion/clip_frame.h>

#include <algorithm>

#include <ros_interface/node/names.h>

namespace cable_variation_ros {

std::string clipFrame(const cable_variation::Scene& scene, const std::string& clip) {
  const bool taken =
      clip == kWorldFrame || clip == kSceneFrame ||
      std::any_of(scene.components.begin(), scene.components.end(),
                  [&](const cable_variation::Component& component) { return component.name == clip; });
  return taken ? kClipMarkers + clip : clip;
}

}  // namespace cable_variation_ros
