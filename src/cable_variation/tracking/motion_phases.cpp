#include <cable_variation/tracking/motion_phases.h>

#include <algorithm>
#include <cmath>

#include <cable_variation/scene/moving_components.h>

namespace cable_variation {
namespace {

constexpr double kLonger = 1.3;  // phases, when there are more than wanted
constexpr double kLookAgain = 1.1;
constexpr std::size_t kLookedAt = 12;  // poses of a phase, to learn its excess
constexpr double kStill = 1e-9;        // moves no clip: as far as rounding [m]

/// The clips of the design as seen from the frames, those that move as seen from one.
class ClipWays {
 public:
  ClipWays(const SampleSpace& space, const std::vector<std::string>& frames, double from)
      : space_(space), frames_(frames) {
    const SamplePlace start = space.designAt(from);
    const ComponentPoses components = space.components(start);
    const Harness harness = space.harness(start);
    for (std::size_t i = 0; i < harness.clips.size(); ++i) {
      const std::string& component = space.scene().clip_mounts[i].component;
      mounts_.emplace_back(component, poseIn(components, component).inverse() * harness.clips[i].pose);
    }
  }

  std::vector<Pose> at(double time) const {
    const ComponentPoses components = space_.components(space_.designAt(time));
    std::vector<Pose> clips;
    clips.reserve(frames_.size() * mounts_.size());
    for (const std::string& frame : frames_) {
      const Pose to_frame = poseIn(components, frame).inverse();
      for (const auto& [component, pose] : mounts_)
        clips.push_back(to_frame * poseIn(components, component) * pose);
    }
    return clips;
  }

 private:
  const SampleSpace& space_;
  const std::vector<std::string>& frames_;
  std::vector<std::pair<std::string, Pose>> mounts_;  // per clip: what it rides on, and its pose there
};

double turnBetween(const Pose& a, const Pose& b) { return a.orientation.angularDistance(b.orientation); }

double motionOf(const Pose& from, const Pose& to, double lever) {
  return (to.position - from.position).norm() + lever * turnBetween(from, to);
}

double largestMotion(const std::vector<Pose>& from, const std::vector<Pose>& to, double lever) {
  double largest = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) largest = std::max(largest, motionOf(from[i], to[i], lever));
  return largest;
}

// How far clips are off the way from `first` to `last` that is even and straight, all at the same share of
// it.
double offStraight(const std::vector<Pose>& first, const std::vector<Pose>& last,
                   const std::vector<Pose>& there, double lever) {
  std::size_t leader = 0;
  double furthest = 0.0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const double motion = motionOf(first[i], last[i], lever);
    if (motion <= furthest) continue;
    furthest = motion;
    leader = i;
  }
  double share = 0.0;
  if (furthest > kStill) {
    const Eigen::Vector3d way = last[leader].position - first[leader].position;
    const double turn = turnBetween(first[leader], last[leader]);
    const bool goes = way.norm() >= lever * turn;
    share = goes ? way.dot(there[leader].position - first[leader].position) / way.squaredNorm()
                 : turnBetween(first[leader], there[leader]) / turn;
    share = std::clamp(share, 0.0, 1.0);
  }
  double off = 0.0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const Pose expected{first[i].position + share * (last[i].position - first[i].position),
                        first[i].orientation.slerp(share, last[i].orientation)};
    off = std::max(off, motionOf(expected, there[i], lever));
  }
  return off;
}

std::vector<double> recordedTimes(const SampleSpace& space, double from, double to) {
  std::vector<double> times{from, to};
  for (const Motion* motion : space.motions()) {
    for (std::size_t i = 0; i < motion->samples.size(); ++i) {
      const double time = motion->samples[i].time;
      if (!(time > from && time < to)) continue;
      times.push_back(time);
      const bool steps = i > 0 && motion->samples[i - 1].time == time;
      const double before = std::nextafter(time, from);
      if (steps && before > from) times.push_back(before);
    }
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

/// Times to look at, and where the clips that move are then.
struct Stations {
  std::vector<double> times;
  std::vector<std::vector<Pose>> clips;
};

Stations stationsOf(const SampleSpace& space, const ClipWays& ways, double from, double to,
                    const PhaseRule& rule) {
  const std::vector<double> recorded = recordedTimes(space, from, to);
  Stations stations{{recorded.front()}, {ways.at(recorded.front())}};
  for (std::size_t i = 1; i < recorded.size(); ++i) {
    const double before = recorded[i - 1], span = recorded[i] - before;
    std::vector<Pose> next = ways.at(recorded[i]);
    int parts =
        std::max(1, static_cast<int>(std::ceil(largestMotion(stations.clips.back(), next, rule.lever) /
                                               (0.5 * rule.stride))));
    if (before + span / parts <= before) parts = 1;  // a step
    for (int part = 1; part < parts; ++part) {
      stations.times.push_back(before + span * part / parts);
      stations.clips.push_back(ways.at(stations.times.back()));
    }
    stations.times.push_back(recorded[i]);
    stations.clips.push_back(std::move(next));
  }
  // all but those clips that move
  std::vector<char> moves(stations.clips.front().size(), 0);
  for (const auto& clips : stations.clips) {
    for (std::size_t i = 0; i < moves.size(); ++i)
      moves[i] = moves[i] || motionOf(stations.clips.front()[i], clips[i], rule.lever) > kStill;
  }
  for (auto& clips : stations.clips) {
    std::vector<Pose> moving;
    for (std::size_t i = 0; i < moves.size(); ++i) {
      if (moves[i]) moving.push_back(clips[i]);
    }
    clips = std::move(moving);
  }
  return stations;
}

// See MotionPhase::excess.
double excessOf(const std::vector<std::vector<Pose>>& clips, std::size_t first, std::size_t last,
                double lever) {
  const std::size_t count = std::min(last - first, kLookedAt);
  const auto pose = [&](std::size_t k) -> const std::vector<Pose>& {
    return clips[first + (last - first) * k / count];
  };
  double excess = 0.0;
  for (std::size_t i = 0; i + 1 < count; ++i) {
    for (std::size_t j = i + 2; j <= count; ++j) {
      std::vector<Pose> middle;
      for (std::size_t clip = 0; clip < pose(i).size(); ++clip) {
        const Pose &a = pose(i)[clip], &b = pose(j)[clip];
        middle.push_back({0.5 * (a.position + b.position), a.orientation.slerp(0.5, b.orientation)});
      }
      double off = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < count && off > excess; ++k)
        off = std::min(off, offStraight(pose(k), pose(k + 1), middle, lever));
      if (std::isfinite(off)) excess = std::max(excess, off);
    }
  }
  return excess;
}

std::vector<MotionPhase> cut(const Stations& stations, const PhaseRule& rule) {
  // no binding: C++17 has lambdas capture none
  const std::vector<double>& times = stations.times;
  const std::vector<std::vector<Pose>>& clips = stations.clips;
  std::vector<MotionPhase> phases;
  const auto bowOf = [&](std::size_t first, std::size_t last) {
    double bow = 0.0;
    for (std::size_t i = first + 1; i < last; ++i)
      bow = std::max(bow, offStraight(clips[first], clips[last], clips[i], rule.lever));
    return bow;
  };
  const auto finish = [&](std::size_t first, std::size_t last) {
    MotionPhase phase;
    phase.times.assign(times.begin() + static_cast<std::ptrdiff_t>(first),
                       times.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    phase.reference = phase.times[phase.times.size() / 2];
    phase.excess = excessOf(clips, first, last, rule.lever);
    phases.push_back(std::move(phase));
  };
  std::size_t first = 0;
  double extent = 0.0;  // how far clips have gone from the first
  // Seen to be straight so far; looked at again when that has grown by a tenth.
  std::size_t straight_poses = 0;
  double straight_extent = 0.0;
  for (std::size_t i = 1; i < times.size(); ++i) {
    extent = std::max(extent, largestMotion(clips[first], clips[i], rule.lever));
    if (extent <= rule.stride || i == first + 1) continue;
    if (extent <= rule.reach) {
      const auto poses = static_cast<double>(i - first);
      if (poses <= kLookAgain * static_cast<double>(straight_poses) && extent <= kLookAgain * straight_extent)
        continue;
      straight_poses = i - first;
      straight_extent = extent;
      if (bowOf(first, i) <= rule.bow) continue;
    }
    finish(first, i - 1);
    first = i - 1;
    extent = largestMotion(clips[first], clips[i], rule.lever);
    straight_poses = 0;
    straight_extent = 0.0;
  }
  finish(first, times.size() - 1);
  return phases;
}

}  // namespace

std::vector<MotionPhase> cutIntoPhases(const SampleSpace& space, const std::vector<std::string>& frames,
                                       double from, double to, const PhaseRule& rule, std::size_t* wanted) {
  if (wanted != nullptr) *wanted = 1;
  if (space.motions().empty()) return {{{from}, from}};
  const Stations stations = stationsOf(space, ClipWays(space, frames, from), from, to, rule);
  PhaseRule longer = rule;
  for (bool first = true;; first = false) {
    std::vector<MotionPhase> phases = cut(stations, longer);
    if (first && wanted != nullptr) *wanted = phases.size();
    if (phases.size() <= std::max<std::size_t>(rule.most, 1)) return phases;
    longer.stride *= kLonger;
    longer.reach *= kLonger;
    longer.bow *= kLonger;
  }
}

}  // namespace cable_variation
