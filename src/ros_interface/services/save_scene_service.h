#pragma once

#include <ros/service_server.h>

#include <cable_variation/SaveScene.h>

#include <cable_variation/analysis/output_directory.h>
#include <ros_interface/request/name_registry.h>

namespace ros {
class NodeHandle;
}

namespace cable_variation_ros {

class SolverContext;

/// Answers ~save_scene: the design in force as a scene file.
class SaveSceneService {
 public:
  /// All must outlive this.
  SaveSceneService(ros::NodeHandle& node, SolverContext& context, cable_variation::OutputDirectory output,
                   NameRegistry& names);

 private:
  bool handle(cable_variation::SaveSceneRequest& request, cable_variation::SaveSceneResponse& response);
  void save(const cable_variation::SaveSceneRequest& request, cable_variation::SaveSceneResponse& response);

  SolverContext& context_;
  cable_variation::OutputDirectory output_;
  NameRegistry& names_;
  ros::ServiceServer server_;
};

}  // namespace cable_variation_ros
