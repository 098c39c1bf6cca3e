#include <cable_variation/variation/motion_phases.h>

#include <algorithm>
#include <cmath>

#include <cable_variation/scene/moving_components.h>

namespace cable_variation {
namespace {

// The clips as seen from every frame.
std::vector<Pose> clipsAt(const SampleSpace& space, const std::vector<std::string>& frames, double time) {
  const SamplePlace place = space.designAt(time);
  const Harness harness = space.harness(place);
  const ComponentPoses components = space.components(place);
  std::vector<Pose> clips;
  clips.reserve(frames.size() * harness.clips.size());
  for (const std::string& frame : frames) {
    const Pose to_frame = poseIn(components, frame).inverse();
    for (const Clip& clip : harness.clips) clips.push_back(to_frame * clip.pose);
  }
  return clips;
}

double largestMotion(const std::vector<Pose>& from, const std::vector<Pose>& to, double lever) {
  double largest = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const double turn = from[i].orientation.angularDistance(to[i].orientation);
    largest = std::max(largest, (to[i].position - from[i].position).norm() + lever * turn);
  }
  return largest;
}

std::vector<double> recordedTimes(const SampleSpace& space, double from, double to) {
  std::vector<double> times{from, to};
  for (const Motion* motion : space.motions()) {
    for (const TimedPose& sample : motion->samples) {
      if (sample.time > from && sample.time < to) times.push_back(sample.time);
    }
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}  // namespace

std::vector<MotionPhase> cutIntoPhases(const SampleSpace& space, const std::vector<std::string>& frames,
                                       double from, double to, double stride, double lever) {
  if (space.motions().empty()) return {{{from}, from}};
  const std::vector<double> recorded = recordedTimes(space, from, to);
  std::vector<MotionPhase> phases;
  MotionPhase phase{{recorded.front()}, recorded.front()};
  std::vector<Pose> first = clipsAt(space, frames, recorded.front()), last = first;
  const auto finish = [&] {
    phase.reference = phase.times[phase.times.size() / 2];
    phases.push_back(phase);
  };
  for (std::size_t i = 1; i < recorded.size(); ++i) {
    const double before = recorded[i - 1];
    std::vector<Pose> next = clipsAt(space, frames, recorded[i]);
    const int parts =
        std::max(1, static_cast<int>(std::ceil(largestMotion(last, next, lever) / (0.5 * stride))));
    for (int part = 1; part <= parts; ++part) {
      const double time = part == parts ? recorded[i] : before + (recorded[i] - before) * part / parts;
      const std::vector<Pose> there = part == parts ? next : clipsAt(space, frames, time);
      if (largestMotion(first, there, lever) > stride && phase.times.size() > 1) {
        const double boundary = phase.times.back();
        finish();
        phase = {{boundary}, boundary};
        first = clipsAt(space, frames, boundary);
      }
      phase.times.push_back(time);
    }
    last = std::move(next);
  }
  finish();
  return phases;
}

}  // namespace cable_variation
