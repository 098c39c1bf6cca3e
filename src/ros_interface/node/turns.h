#pragma once

#include <condition_variable>
#include <cstddef>
#include <mutex>

namespace cable_variation_ros {

/// Calls from many threads, one at work after the other in the order they came, of which no more than some
/// wait.
class Turns {
 public:
  /// @param waiting how many may
  explicit Turns(std::size_t waiting) : waiting_(waiting) {}

  /// The turn of the thread that makes it, as long as it lives.
  class Turn {
   public:
    /// Waits for it. Throws cable_variation::Cancelled, "busy: ...", at once when as many wait as may.
    explicit Turn(Turns& turns);
    ~Turn();
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

   private:
    Turns& turns_;
  };

 private:
  const std::size_t waiting_;
  std::mutex mutex_;
  std::condition_variable ended_one_;
  std::size_t come_ = 0, ended_ = 0;  ///< so far
};

}  // namespace cable_variation_ros
