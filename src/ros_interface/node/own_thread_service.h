#pragma once

#include <functional>

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <ros/spinner.h>

namespace cable_variation_ros {

/// A service on a thread of its own: one call after another, while the node answers others.
template <typename Service>
class OwnThreadService {
 public:
  using Request = typename Service::Request;
  using Response = typename Service::Response;

  /// @param answer called on that thread
  OwnThreadService(const ros::NodeHandle& node, const char* name,
                   std::function<Response(const Request&)> answer)
      : answer_(std::move(answer)), spinner_(1, &queue_) {
    ros::NodeHandle own(node);
    own.setCallbackQueue(&queue_);
    server_ = own.advertiseService(name, &OwnThreadService::handle, this);
    spinner_.start();
  }

 private:
  bool handle(Request& request, Response& response) {
    response = answer_(request);
    return true;
  }

  std::function<Response(const Request&)> answer_;
  ros::CallbackQueue queue_;
  ros::ServiceServer server_;
  ros::AsyncSpinner spinner_;
};

}  // namespace cable_variation_ros
