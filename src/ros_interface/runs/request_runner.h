#pragma once

#include <memory>

#include <ros_interface/request/request_status.h>
#include <ros_interface/runs/runner.h>

namespace cable_variation_ros {

/// Answers the requests for one kind of run, whoever asks.
/// @tparam Run a LongRun with its types Request, Response and Publisher, made of (request, limits,
/// publisher), and with takeResponse()
template <typename Run>
class RequestRunner {
 public:
  using Request = typename Run::Request;
  using Response = typename Run::Response;

  /// Both must outlive it. @param who asks, see Runner::run()
  RequestRunner(Runner& runner, typename Run::Publisher& publisher, const char* who)
      : runner_(runner), publisher_(publisher), who_(who) {}

  /// Not from the spinning thread. The answer's status tells how it ended; unless the run itself says what
  /// else there is, it has nothing but its status if that is not SUCCESS.
  Response run(const Request& request, const Runner::Watcher& watcher) {
    const auto run = std::make_shared<Run>(request, runner_.limits(), publisher_);
    return answered<Response>([&] {
      runner_.run(run, who_, watcher);
      return run->takeResponse();
    });
  }

 private:
  Runner& runner_;
  typename Run::Publisher& publisher_;
  const char* who_;
};

}  // namespace cable_variation_ros
