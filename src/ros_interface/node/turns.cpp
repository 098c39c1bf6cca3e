#include <ros_interface/node/turns.h>

#include <string>

#include <cable_variation/util/error.h>

namespace cable_variation_ros {

Turns::Turn::Turn(Turns& turns) : turns_(turns) {
  std::unique_lock<std::mutex> lock(turns_.mutex_);
  const std::size_t there = turns_.come_ - turns_.ended_;
  if (there > turns_.waiting_) {
    throw cable_variation::Cancelled("busy: a request is at work and " + std::to_string(there - 1) +
                                     " wait, as many as may; expected to be asked again later");
  }
  const std::size_t mine = turns_.come_++;
  turns_.ended_one_.wait(lock, [&] { return turns_.ended_ == mine; });
}

Turns::Turn::~Turn() {
  const std::lock_guard<std::mutex> lock(turns_.mutex_);
  ++turns_.ended_;
  turns_.ended_one_.notify_all();
}

}  // namespace cable_variation_ros
