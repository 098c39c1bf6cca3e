#include <ros_interface/node/node_end.h>

#include <atomic>
#include <csignal>

#include <malloc.h>
#include <sys/time.h>
#include <unistd.h>

#include <ros/callback_queue.h>
#include <ros/init.h>
#include <ros/xmlrpc_manager.h>

namespace cable_variation_ros {

namespace {

std::atomic<bool> told_to_end{false};
static_assert(std::atomic<bool>::is_always_lock_free, "signal handlers must not wait");

// Called by signal handlers too: nothing here may lock or allocate.
void tellToEnd() {
  if (told_to_end.exchange(true)) return;
  const itimerval patience{{0, 0}, {1, 800000}};  // [s], [us]
  ::setitimer(ITIMER_REAL, &patience, nullptr);
}

// What long runs have freed, which the allocator keeps: of 170 MB after some dozen, 30 were in use.
void giveBackMemory() {
#ifdef __GLIBC__
  ::malloc_trim(0);
#endif
}

void answerShutdown(XmlRpc::XmlRpcValue& /*parameters*/, XmlRpc::XmlRpcValue& result) {
  tellToEnd();
  result = ros::xmlrpc::responseInt(1, "", 0);
}

}  // namespace

void endOnSignals() {
  std::signal(SIGALRM, [](int) { ::_exit(0); });
  std::signal(SIGINT, [](int) { tellToEnd(); });
  std::signal(SIGTERM, [](int) { tellToEnd(); });
}

void endOnRequest() {
  const ros::XMLRPCManagerPtr& requests = ros::XMLRPCManager::instance();
  requests->unbind("shutdown");
  requests->bind("shutdown", answerShutdown);
}

bool goesOn() { return !told_to_end && ros::ok(); }

void spinUntilTheEnd() {
  constexpr double kLook = 0.05, kTidy = 10.0;  // [s]
  ros::WallTime tidied = ros::WallTime::now();
  while (goesOn()) {
    ros::getGlobalCallbackQueue()->callOne(ros::WallDuration(kLook));
    const ros::WallTime now = ros::WallTime::now();
    if (now - tidied < ros::WallDuration(kTidy)) continue;
    giveBackMemory();
    tidied = now;
  }
}

}  // namespace cable_variation_ros
