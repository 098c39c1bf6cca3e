#include <ros_interface/live/motion_player.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace cable_variation_ros {

MotionPlayer::MotionPlayer(double duration, double speed, bool loop)
    : duration_(duration), speed_(speed), loop_(loop) {}

void MotionPlayer::play(bool playing) {
  if (playing && !playing_ && !loop_ && time_ >= duration_) time_ = 0.0;
  playing_ = playing;
}

void MotionPlayer::seek(double time) {
  if (!(time >= 0.0 && time <= duration_)) {
    std::ostringstream text;
    text << "time " << time << " s, expected 0 to " << duration_ << " s";
    throw std::invalid_argument(text.str());
  }
  time_ = time;
}

void MotionPlayer::advance(double elapsed) {
  if (!playing_ || !(elapsed > 0.0)) return;
  time_ += elapsed * speed_;
  if (time_ <= duration_) return;
  if (loop_ && duration_ > 0.0) {
    time_ = std::fmod(time_, duration_);
  } else {
    time_ = duration_;
    playing_ = false;
  }
}

}  // namespace cable_variation_ros
