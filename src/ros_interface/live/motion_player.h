#pragma once

namespace cable_variation_ros {

/// Where in its recordings a player is.
class MotionPlayer {
 public:
  /// `duration` [s] of the longest recording, `speed` in seconds of it per second.
  MotionPlayer(double duration, double speed, bool loop);

  double time() const { return time_; }  ///< [s], 0 to the duration
  bool playing() const { return playing_; }

  /// Playing on at the end without `loop` starts again.
  void play(bool playing);

  /// Throws std::invalid_argument unless 0 <= time <= duration.
  void seek(double time);

  /// Lets `elapsed` [s] go by; a clock set back (negative) counts as none.
  void advance(double elapsed);

 private:
  double duration_;
  double speed_;
  bool loop_;
  bool playing_ = true;
  double time_ = 0.0;
};

}  // namespace cable_variation_ros
