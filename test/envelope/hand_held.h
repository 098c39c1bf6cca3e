#pragma once

// A recording as of a hand-held camera, made on the spot.

#include <cmath>
#include <vector>

#include <cable_variation/math/so3.h>
#include <cable_variation/scene/motion.h>

namespace cable_variation::test {

struct HandHeld {
  double seconds = 30.0;
  double rate = 100.0;                ///< of the recording [Hz]
  double reach = 0.25;                ///< along each axis, to both sides [m]
  double turn = 20.0 * M_PI / 180.0;  ///< about each axis, to both sides [rad]
  double tremor = 3e-4;               ///< of the hand, at some 9 Hz [m]
  std::size_t repeated_every = 40;    ///< samples: one comes with the stamp of that before; 0: none
};

/// Slow sweeps of incommensurable periods of a few seconds along and about all three axes, and the tremor of
/// a hand, about `middle`.
inline std::vector<TimedPose> handHeldRecording(const Pose& middle, const HandHeld& how = {}) {
  const auto wave = [](double time, double phase, double slow, double fast) {
    return 0.7 * std::sin(2.0 * M_PI * slow * time + phase) +
           0.3 * std::sin(2.0 * M_PI * fast * time + 2.3 * phase + 1.0);
  };
  std::vector<TimedPose> samples;
  const auto count = static_cast<std::size_t>(std::lround(how.seconds * how.rate)) + 1;
  for (std::size_t i = 0; i < count; ++i) {
    const double time = static_cast<double>(i) / how.rate;
    const Eigen::Vector3d place(wave(time, 0.0, 0.17, 0.61), wave(time, 1.1, 0.23, 0.47),
                                wave(time, 2.7, 0.13, 0.71));
    const Eigen::Vector3d turn(wave(time, 0.4, 0.19, 0.53), wave(time, 1.9, 0.11, 0.67),
                               wave(time, 3.3, 0.29, 0.43));
    const Eigen::Vector3d shake(std::sin(2.0 * M_PI * 8.7 * time), std::sin(2.0 * M_PI * 9.1 * time + 1.0),
                                std::sin(2.0 * M_PI * 9.6 * time + 2.0));
    Pose pose;
    pose.position = middle.position + how.reach * place + how.tremor * shake;
    pose.orientation = middle.orientation * so3::exp(how.turn * turn);
    const bool repeated = how.repeated_every > 0 && i > 0 && i % how.repeated_every == 0;
    samples.push_back({repeated ? samples.back().time : time, pose});
  }
  return samples;
}

}  // namespace cable_variation::test
