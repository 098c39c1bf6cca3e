#pragma once

#include <ros/publisher.h>

#include <cable_variation/EnvelopeMesh.h>

#include <cable_variation/scene/scene.h>
#include <ros_interface/interference_publisher.h>
#include <ros_interface/marker_channel.h>

namespace ros {
class NodeHandle;
}

namespace cable_variation_ros {

class SolverContext;

/// An envelope to be seen, and what it belongs to.
struct EnvelopeView {
  visualization_msgs::MarkerArray markers;
  cable_variation::EnvelopeMesh mesh;
  InterferenceView interference;

  std::size_t design_number = 0;          ///< SolverContext::designNumber()
  cable_variation::ComponentPoses moved;  ///< where components were, without those in `carried`
  std::vector<std::string> carried;  ///< components that may move: the envelope holds for all their poses
};

/// `moved` without the components in `carried`.
cable_variation::ComponentPoses without(const std::vector<std::string>& carried,
                                        cable_variation::ComponentPoses moved);

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
  bool fits(const EnvelopeView& view, const SolverContext& context) const;
  void publishNone();

  MarkerChannel markers_;
  ros::Publisher mesh_;
  InterferencePublisher& interference_;
  EnvelopeView shown_;  ///< without what was published
  bool showing_ = false;
};

}  // namespace cable_variation_ros
