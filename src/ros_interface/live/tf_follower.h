#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include <ros/wall_timer.h>

#include <cable_variation/scene/scene.h>
#include <ros_interface/live/tf_input.h>
#include <ros_interface/live/tf_watch.h>

namespace cable_variation_ros {

class SolverContext;

struct TfFollowerOptions {
  double rate_hz = 200.0;  ///< how often to follow, at most
  double timeout = 1.0;    ///< how old the tf of a component may be [s]
};

/// Moves the context's components to where tf has them, as soon as it tells. A component that is not on tf
/// stays where the scene puts it.
class TfFollower {
 public:
  /// All must outlive this. @param tell takes what happened to tf
  TfFollower(ros::NodeHandle& node, SolverContext& context, const TfFollowerOptions& options,
             std::function<void(const std::vector<cable_variation::CableEvent>&)> tell);
  ~TfFollower();

  /// What is late now, for a person: one sentence each.
  std::vector<std::string> late() const { return watch_.late(ros::Time::now()); }

 private:
  /// What tf tells of the components now.
  struct Sight {
    cable_variation::ComponentPoses moved;  ///< that are not where the scene has them
    ros::Time newest;                       ///< stamp; that of looking, if none of it has one
    bool stamped = false;                   ///< some of it has
  };
  Sight look();
  void wake();   // by tf's thread
  void awake();  // by the node's
  void follow();
  void checkTime();

  SolverContext& context_;
  TfFollowerOptions options_;
  std::function<void(const std::vector<cable_variation::CableEvent>&)> tell_;
  TfWatch watch_;
  std::size_t times_back_ = 0;
  std::size_t design_number_ = 0;
  ros::WallTime followed_;  // last
  std::atomic<bool> woken_{false};
  ros::WallTimer pause_;  // until it may follow again
  ros::WallTimer check_;
  TfInput input_;  // last: it calls wake()
};

}  // namespace cable_variation_ros
