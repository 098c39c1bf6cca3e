#pragma once

#include <functional>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include <ros/subscriber.h>

#include <cable_variation/CableEvent.h>
#include <cable_variation/MotionState.h>

namespace ros {
class NodeHandle;
}

namespace cable_variation_ros {

class SolverContext;

/// Closes and opens clips when the scene's `attachments` say so, by the time of the motions that
/// ~motion_state tells: the launch files connect it to moving_geometry_node's. When that goes back, to an
/// earlier time or to the start, clips are as they are at that time, however far the cables have fallen
/// since.
class AttachmentFollower {
 public:
  /// All must outlive this. @param tell takes changes that could not be made
  AttachmentFollower(ros::NodeHandle& node, SolverContext& context,
                     std::function<void(const std::vector<cable_variation::CableEvent>&)> tell);

 private:
  void hear(const cable_variation::MotionState& state);

  SolverContext& context_;
  std::function<void(const std::vector<cable_variation::CableEvent>&)> tell_;
  double time_ = -std::numeric_limits<double>::infinity();  ///< last heard [s]
  bool went_back_ = false;                                  ///< and clips are not yet as they were then
  std::set<std::pair<std::size_t, bool>> refused_;  ///< clips that were to close or open, and it was told
  ros::Subscriber subscriber_;
};

}  // namespace cable_variation_ros
