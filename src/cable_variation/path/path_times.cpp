#include <cable_variation/path/path_times.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>

#include <cable_variation/util/quantity.h>

namespace cable_variation {

namespace {

constexpr double kLever = 0.05;  // [m]

double travel(const Pose& a, const Pose& b) {
  return (b.position - a.position).norm() + kLever * a.orientation.angularDistance(b.orientation);
}

/// Where clips and moved components are at one time.
struct Places {
  Harness harness;
  ComponentPoses components;

  double travelTo(const Places& next) const {
    double furthest = 0.0;
    for (std::size_t i = 0; i < harness.clips.size(); ++i)
      furthest = std::max(furthest, travel(harness.clips[i].pose, next.harness.clips[i].pose));
    for (const auto& [name, pose] : next.components) {
      const auto before = components.find(name);
      if (before != components.end()) furthest = std::max(furthest, travel(before->second, pose));
    }
    return furthest;
  }
};

}  // namespace

std::vector<double> pathTimes(const Design& design, const ComponentPath& path, double step,
                              const std::vector<double>& also, std::size_t most) {
  const double first = path.times.front(), last = path.times.back();
  std::set<double> wanted(path.times.begin(), path.times.end());
  std::set<double> kept{first, last};
  for (const double time : also) {
    if (time < first || time > last) continue;
    wanted.insert(time);
    kept.insert(time);
  }
  const auto placesAt = [&](double time) {
    const ComponentPoses places = path.places(time);
    return Places{harnessAt(design, {}, places), places};
  };
  std::vector<double> times{first};
  const auto refuseMore = [&](double count) {
    if (count <= static_cast<double>(most)) return;
    throw std::invalid_argument("step " + shortNumber(1e3 * step) +
                                " mm: the path would be looked at more than " + std::to_string(most) +
                                " times; expected a larger step or a shorter path");
  };
  const auto add = [&](double time) {
    if (time > times.back()) times.push_back(time);
    refuseMore(static_cast<double>(times.size()));
  };
  Places here = placesAt(first);
  double since = 0.0, before = first;  // [m] that it went since the last of `times`
  for (const double time : wanted) {
    if (time == first) continue;
    Places next = placesAt(time);
    const double distance = here.travelTo(next);
    if (since + distance > step) {
      add(before);
      since = 0.0;
    }
    const auto parts = std::max(1.0, std::ceil(distance / step));
    refuseMore(parts);  // so many that the first ones are at the same time, too
    for (double part = 1.0; part < parts; ++part) add(before + (time - before) * part / parts);
    since = parts > 1.0 ? distance / parts : since + distance;
    if (path.every_pose || kept.count(time) != 0) {
      add(time);
      since = 0.0;
    }
    here = std::move(next);
    before = time;
  }
  return times;
}

}  // namespace cable_variation
