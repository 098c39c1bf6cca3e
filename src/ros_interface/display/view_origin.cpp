#include <ros_interface/display/view_origin.h>

#include <cable_variation/scene/moving_components.h>
#include <ros_interface/conversion/same_poses.h>

namespace cable_variation_ros {

using cable_variation::ComponentPoses;
using cable_variation::Scene;

namespace {

ComponentPoses without(const std::vector<std::string>& carried, ComponentPoses moved) {
  for (const std::string& name : carried) moved.erase(name);
  return moved;
}

/// Components whose poses the motions give.
std::vector<std::string> carriedBy(const std::vector<std::size_t>& motions, const Scene& scene) {
  if (motions.empty()) return {};
  std::vector<const cable_variation::Motion*> played;
  played.reserve(motions.size());
  for (const std::size_t index : motions) played.push_back(&scene.motions[index]);
  std::vector<std::string> carried;
  for (const auto& [name, pose] : posesDuring(scene, played, 0.0)) carried.push_back(name);
  return carried;
}

}  // namespace

bool ViewOrigin::fits(const SolverContext& context) const {
  return design_number == context.designNumber() && same(moved, without(carried, context.moved()));
}

ViewOrigin viewOrigin(const SolverContext::Snapshot& snapshot, const std::vector<std::size_t>& motions) {
  ViewOrigin origin;
  origin.design_number = snapshot.design_number;
  origin.carried = carriedBy(motions, snapshot.design.scene);
  origin.moved = without(origin.carried, snapshot.moved);
  return origin;
}

std::vector<std::string> warningsOfMoved(const ViewOrigin& origin, const std::vector<std::size_t>& motions) {
  std::vector<std::string> warnings;
  if (motions.empty()) return warnings;
  for (const auto& [name, pose] : origin.moved) {
    warnings.push_back("component '" + name +
                       "' is not where the scene has it now, but is taken to be there: over a motion only "
                       "what the motions move leaves its place");
  }
  return warnings;
}

}  // namespace cable_variation_ros
