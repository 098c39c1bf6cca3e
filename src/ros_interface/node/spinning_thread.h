#pragma once

#include <functional>
#include <memory>

#include <cable_variation/util/error.h>

namespace ros {
class CallbackQueueInterface;
}

namespace cable_variation_ros {

/// Thrown by SpinningThread::run() when the node ends.
struct NodeEnds : cable_variation::Cancelled {
  NodeEnds() : Cancelled("the node ends") {}
};

/// The thread that spins a node, as seen from others. Only there the design in force is read and changed, and
/// things are published: nothing of that needs locks.
class SpinningThread {
 public:
  /// @param queue that the node spins; must outlive this
  explicit SpinningThread(ros::CallbackQueueInterface& queue);

  /// From another thread: has `task` run between two callbacks, waits for it and throws what it throws.
  /// Throws NodeEnds if stop() came first.
  void run(const std::function<void()>& task);

  /// From the spinning thread, when it spins no more.
  void stop();
  bool stopped() const;

 private:
  struct Shared;
  ros::CallbackQueueInterface& queue_;
  std::shared_ptr<Shared> shared_;
};

}  // namespace cable_variation_ros
