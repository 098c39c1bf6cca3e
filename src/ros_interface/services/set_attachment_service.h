#pragma once

#include <ros/service_server.h>

#include <cable_variation/SetAttachment.h>

namespace ros {
class NodeHandle;
}

namespace cable_variation_ros {

class MeasuredShape;
class ShapeWatch;
class SolverContext;

/// ~set_attachment
class SetAttachmentService {
 public:
  /// What knows of a change once it is made. All must outlive the service.
  struct Watchers {
    const ShapeWatch& events;
    MeasuredShape& measured;
  };
  SetAttachmentService(ros::NodeHandle& node, SolverContext& context, const Watchers& watchers);

 private:
  bool handle(cable_variation::SetAttachmentRequest& request,
              cable_variation::SetAttachmentResponse& response);

  SolverContext& context_;
  Watchers watchers_;
  ros::ServiceServer server_;
};

}  // namespace cable_variation_ros
