#pragma once

#include <ros/publisher.h>

#include <cable_variation/EnvelopeMesh.h>

#include <ros_interface/display/interference_publisher.h>
#include <ros_interface/display/marker_channel.h>
#include <ros_interface/display/view_origin.h>

namespace ros {
class NodeHandle;
}

namespace cable_variation_ros {

/// An envelope to be seen, and what it belongs to.
struct EnvelopeView {
  visualization_msgs::MarkerArray markers;
  cable_variation::EnvelopeMesh mesh;
  InterferenceView interference;
  ViewOrigin origin;
};

/// ~envelope, ~envelope_mesh and an envelope's part of ~interference. An envelope is shown only with the
/// design and the places of components that it belongs to.
class EnvelopePublisher {
 public:
  EnvelopePublisher(ros::NodeHandle& node, InterferencePublisher& interference);

  /// Shows it unless it belongs to something else than what is in force: false.
  bool show(EnvelopeView view, const SolverContext& context);
  /// Takes it away if it no longer belongs to what is in force.
  void contextChanged(const SolverContext& context);

 private:
  void publishNone();

  MarkerChannel markers_;
  ros::Publisher mesh_;
  InterferencePublisher& interference_;
  ViewOrigin shown_;
  bool showing_ = false;
};

}  // namespace cable_variation_ros
