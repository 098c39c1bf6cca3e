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
  /// @param task must own what it uses if `goes_on` is given: it may still run when nobody waits for it
  /// @param goes_on asked by the waiting thread, some fifty times a second; false: it waits no longer
  /// Throws cable_variation::Cancelled as soon as `goes_on` says false, the task is then not begun any more;
  /// NodeEnds if stop() came first.
  void run(std::function<void()> task, const std::function<bool()>& goes_on = {});

  /// From the spinning thread, when it spins no more.
  void stop();
  bool stopped() const;

 private:
  struct Shared;
  ros::CallbackQueueInterface& queue_;
  std::shared_ptr<Shared> shared_;
};

}  // namespace cable_variation_ros
