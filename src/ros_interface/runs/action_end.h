#pragma once

#include <actionlib/server/simple_action_server.h>

#include <cable_variation/Status.h>

namespace cable_variation_ros {

/// Ends a goal as the status of its result says.
template <typename Action, typename Result>
void endGoal(actionlib::SimpleActionServer<Action>& server, const Result& result) {
  const cable_variation::Status& status = result.status;
  if (status.code == cable_variation::Status::SUCCESS) {
    server.setSucceeded(result);
  } else if (status.code == cable_variation::Status::CANCELLED) {
    server.setPreempted(result, status.message);
  } else {
    server.setAborted(result, status.message);
  }
}

}  // namespace cable_variation_ros
