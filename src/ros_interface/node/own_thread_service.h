#pragma once

#include <functional>
#include <utility>

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <ros/spinner.h>

#include <cable_variation/util/error.h>
#include <ros_interface/node/turns.h>

namespace cable_variation_ros {

/// A service on threads of its own: one call after another, while the node answers others. A few calls wait;
/// what comes beyond them is answered at once that it is busy (CANCELLED).
template <typename Service>
class OwnThreadService {
 public:
  using Request = typename Service::Request;
  using Response = typename Service::Response;

  /// @param answer called on one of these threads at a time
  OwnThreadService(const ros::NodeHandle& node, const char* name,
                   std::function<Response(const Request&)> answer)
      : answer_(std::move(answer)), turns_(kWaiting), spinner_(kWaiting + 2, &queue_) {
    ros::NodeHandle own(node);
    own.setCallbackQueue(&queue_);
    server_ = own.advertiseService(name, &OwnThreadService::handle, this);
    spinner_.start();
  }

 private:
  // A call that waits takes a thread, as one at work does; one more refuses.
  static constexpr unsigned kWaiting = 4;

  bool handle(Request& request, Response& response) {
    try {
      const Turns::Turn turn(turns_);
      response = answer_(request);
    } catch (const cable_variation::Cancelled& busy) {
      response.status.code = decltype(response.status)::CANCELLED;
      response.status.message = busy.what();
    }
    return true;
  }

  std::function<Response(const Request&)> answer_;
  Turns turns_;
  ros::CallbackQueue queue_;
  ros::ServiceServer server_;
  ros::AsyncSpinner spinner_;
};

}  // namespace cable_variation_ros
