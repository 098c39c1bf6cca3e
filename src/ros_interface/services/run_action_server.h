#pragma once

#include <actionlib/server/simple_action_server.h>
#include <ros/callback_queue.h>
#include <ros/console.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>

#include <cable_variation/Status.h>

#include <ros_interface/conversion/progress_conversion.h>
#include <ros_interface/node/node_end.h>
#include <ros_interface/node/same_fields.h>
#include <ros_interface/runs/request_runner.h>
#include <ros_interface/services/client_watch.h>

namespace cable_variation_ros {

/// An action that does what a service does, with progress; cancelled by its client, by a new goal, or when
/// its client has gone. Goals and cancels arrive on a thread of its own, so that a cancel is heard while the
/// node's thread is busy.
/// @tparam Action with the fields of Run::Request and Run::Response @tparam Run see RequestRunner
template <typename Action, typename Run>
class RunActionServer {
  ACTION_DEFINITION(Action)

 public:
  /// @param runner must outlive it
  RunActionServer(const ros::NodeHandle& node, const char* name, RequestRunner<Run>& runner)
      : runner_(runner),
        name_(name),
        node_(onQueue(node, queue_)),
        client_(node_, name),
        server_(
            node_, name, [this](const GoalConstPtr& goal) { execute(*goal); }, false),
        spinner_(1, &queue_) {
    server_.start();
    spinner_.start();
  }

 private:
  static constexpr double kFeedbackPeriod = 0.1;  // [s]

  static ros::NodeHandle onQueue(ros::NodeHandle node, ros::CallbackQueue& queue) {
    node.setCallbackQueue(&queue);
    return node;
  }

  void execute(const Goal& goal) {
    const ros::WallTime start = ros::WallTime::now();
    double told = -kFeedbackPeriod;
    const auto watch = [&](const cable_variation::Progress& progress) {
      const double elapsed = (ros::WallTime::now() - start).toSec();
      if (elapsed - told >= kFeedbackPeriod) {
        Feedback feedback;
        setFeedback(progress, elapsed, feedback);
        server_.publishFeedback(feedback);
        told = elapsed;
      }
      return goesOn() && !server_.isPreemptRequested() && !clientHasGone();
    };
    end(sameFields<Result>(runner_.run(sameFields<typename Run::Request>(goal), watch)));
  }

  bool clientHasGone() const {
    if (!client_.hasGone()) return false;
    ROS_WARN_THROTTLE(5.0, "%s, which asked for %s, has gone: its run ends", client_.sender().c_str(), name_);
    return true;
  }

  /// As the status of the result says.
  void end(const Result& result) {
    const cable_variation::Status& status = result.status;
    if (status.code == cable_variation::Status::SUCCESS) {
      server_.setSucceeded(result);
    } else if (status.code == cable_variation::Status::CANCELLED) {
      server_.setPreempted(result, status.message);
    } else {
      server_.setAborted(result, status.message);
    }
  }

  RequestRunner<Run>& runner_;
  const char* name_;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ClientWatch<Action> client_;
  actionlib::SimpleActionServer<Action> server_;
  ros::AsyncSpinner spinner_;
};

}  // namespace cable_variation_ros
