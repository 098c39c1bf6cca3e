#pragma once

#include <functional>
#include <string>

#include <QObject>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/service.h>
#include <ros/spinner.h>

#include <cable_variation/Status.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <rviz_plugins/panel/request_worker.h>

namespace cable_variation_rviz {

// How an answer says that it went wrong; empty: it did not.
template <typename Response>
std::string failureOf(const Response& response) {
  if (response.status.code == cable_variation::Status::SUCCESS) return "";
  return response.status.message.empty() ? "status " + std::to_string(response.status.code)
                                         : response.status.message;
}
inline std::string failureOf(const std_srvs::TriggerResponse& response) {
  return response.success ? "" : response.message;
}
inline std::string failureOf(const std_srvs::SetBoolResponse& response) {
  return response.success ? "" : response.message;
}

/// Asks the services of nodes on a thread of its own and hears their topics on another. What comes back is
/// handed to the thread of this object, Qt's, which never waits. Nothing comes back after its destruction.
class SolverConnection : public QObject {
  Q_OBJECT

 public:
  /// @param solver the node's name, such as /cable_solver
  explicit SolverConnection(std::string solver, QObject* parent = nullptr);
  ~SolverConnection() override;

  const std::string& solver() const { return solver_; }
  /// Of topics and actions: their callbacks are called on a thread of its own.
  ros::NodeHandle& node() { return node_; }

  template <typename Response>
  using Then = std::function<void(const Response& response, const std::string& failure)>;

  /// @param service its full name, such as /cable_solver/set_design
  /// @param key of requests that are out of date when a newer one with the same key comes: then these are not
  ///   asked and `then` is not called; empty: all are asked
  /// @param then called with the answer and what went wrong, nothing if empty. The response is as made by
  ///   default if there was no answer
  template <typename Service>
  void ask(const std::string& service, typename Service::Request request, const std::string& key,
           Then<typename Service::Response> then) {
    worker_.post(key, [this, service, request, then]() mutable {
      typename Service::Response response;
      std::string failure;
      if (!ros::service::exists(service, false)) {
        failure = "there is no service " + service + ": the node is not running, or still loads its scene";
      } else if (!ros::service::call(service, request, response)) {
        failure = "no answer from " + service;
      } else {
        failure = failureOf(response);
      }
      toQt([then, response, failure] { then(response, failure); });
    });
  }

  /// Has `receive` called in Qt's thread with every message of a topic, of several that wait the newest only.
  template <typename Message>
  ros::Subscriber hear(const std::string& topic,
                       std::function<void(const boost::shared_ptr<const Message>&)> receive) {
    return node_.subscribe<Message>(topic, 1,
                                    boost::function<void(const boost::shared_ptr<const Message>&)>(
                                        [this, receive](const boost::shared_ptr<const Message>& message) {
                                          toQt([receive, message] { receive(message); });
                                        }));
  }

  /// From any thread: has `task` done in the thread of this object.
  void toQt(std::function<void()> task);

 private:
  std::string solver_;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ros::AsyncSpinner spinner_;
  RequestWorker worker_;
};

}  // namespace cable_variation_rviz
