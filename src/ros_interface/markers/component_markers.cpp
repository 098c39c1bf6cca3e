#include <ros_interface/markers/component_markers.h>

#include <ros_interface/markers/marker_shapes.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

visualization_msgs::MarkerArray componentMarkers(const cable_variation::Scene& scene,
                                                 const std::set<std::string>& which,
                                                 const cable_variation::ComponentPoses& deviations) {
  visualization_msgs::MarkerArray array;
  for (const cable_variation::Component& component : scene.components) {
    if (which.count(component.name) == 0) continue;
    MarkerGroup group(kComponentMarkers + component.name, component.name, Eigen::Vector4d::Ones());
    const auto found = deviations.find(component.name);
    const cable_variation::Pose part = found != deviations.end() ? found->second : cable_variation::Pose();
    for (const cable_variation::Visual& visual : component.visuals) {
      group.setColor(visual.color);
      if (!visual.mesh_resource.empty()) {
        group.addMeshResource(part * visual.pose, visual.mesh_resource, visual.mesh_scale);
      } else if (visual.mesh) {
        group.addMesh(part * visual.pose, *visual.mesh);
      }
    }
    group.lockToFrame();
    array.markers.insert(array.markers.end(), group.markers().begin(), group.markers().end());
  }
  return array;
}

}  // namespace cable_variation_ros
