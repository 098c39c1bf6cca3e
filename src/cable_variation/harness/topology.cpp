#include <cable_variation/harness/topology.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include <cable_variation/rod/profile.h>

namespace cable_variation {
namespace {

// Arc lengths closer than this share of the cable's length are one place.
constexpr double kSamePlace = 1e-6;

// The stations of one cable while they are collected.
class Places {
 public:
  explicit Places(double length) : tolerance_(kSamePlace * length) {
    add(0.0);
    add(length);
  }

  void add(double arc_length) {
    if (find(arc_length) == places_.size()) places_.push_back(arc_length);
  }

  std::size_t find(double arc_length) const {
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (std::abs(places_[i] - arc_length) <= tolerance_) return i;
    }
    return places_.size();
  }

  bool has(double arc_length) const { return find(arc_length) != places_.size(); }

  std::vector<double> sorted() const {
    std::vector<double> result = places_;
    std::sort(result.begin(), result.end());
    return result;
  }

 private:
  double tolerance_;
  std::vector<double> places_;
};

std::size_t stationAt(const Topology& topology, std::size_t cable, double arc_length) {
  const auto& stations = topology.cable_stations[cable];
  const auto nearest = std::min_element(stations.begin(), stations.end(), [&](std::size_t a, std::size_t b) {
    return std::abs(topology.stations[a].arc_length - arc_length) <
           std::abs(topology.stations[b].arc_length - arc_length);
  });
  return *nearest;
}

std::vector<Places> collectPlaces(const Harness& harness) {
  std::vector<Places> places;
  for (const Cable& cable : harness.cables) {
    places.emplace_back(cable.length);
    for (double s : RodProfile(cable).breaks()) places.back().add(s);
  }
  for (const Clip& clip : harness.clips) {
    if (clip.attached && !clip.constraint.slides) places[clip.cable].add(clip.arc_length);
  }
  for (const Joint& joint : harness.joints) {
    places[joint.parent].add(joint.parent_arc_length);
    places[joint.child].add(joint.child_arc_length);
  }
  for (const PointLoad& load : harness.loads) places[load.cable].add(load.arc_length);
  for (const Clip& clip : harness.clips) {
    if (!clip.attached || !clip.constraint.slides) continue;
    if (places[clip.cable].has(clip.arc_length)) {
      std::ostringstream text;
      text << "clip '" << clip.name << "' slides and starts at " << clip.arc_length << " m of cable '"
           << harness.cables[clip.cable].name << "', where something else is; expected a place of its own";
      throw std::invalid_argument(text.str());
    }
    places[clip.cable].add(clip.arc_length);
  }
  return places;
}

std::vector<std::size_t> parentsFirst(const Topology& topology) {
  std::vector<std::size_t> order;
  std::vector<bool> placed(topology.stations.size(), false);
  while (order.size() < topology.stations.size()) {
    for (std::size_t i = 0; i < topology.stations.size(); ++i) {
      const auto& parent = topology.stations[i].parent;
      if (placed[i] || (parent && !placed[*parent])) continue;
      placed[i] = true;
      order.push_back(i);
    }
  }
  return order;
}

// Whether clips and joints are of the same kinds, one by one; there are as many in both.
bool sameKinds(const Harness& a, const Harness& b) {
  const auto same = [](const auto& x, const auto& y) {
    return std::equal(x.begin(), x.end(), y.begin(),
                      [](const ClipFreedom& f, const ClipFreedom& g) { return f.kind == g.kind; });
  };
  for (std::size_t i = 0; i < a.clips.size(); ++i) {
    if (a.clips[i].attached != b.clips[i].attached) return false;
    const ClipConstraint& p = a.clips[i].constraint;
    const ClipConstraint& q = b.clips[i].constraint;
    if (p.slides != q.slides || !same(p.translation, q.translation) || !same(p.rotation, q.rotation)) {
      return false;
    }
  }
  return std::equal(a.joints.begin(), a.joints.end(), b.joints.begin(),
                    [](const Joint& x, const Joint& y) { return x.type == y.type; });
}

// Arc lengths of stations while they are collected; fails when a station is claimed at two places.
class ArcLengths {
 public:
  ArcLengths(const Topology& topology, const Harness& harness)
      : topology_(topology), harness_(harness), values_(topology.stations.size(), NAN) {}

  void put(std::size_t station, std::size_t cable, double arc_length) {
    double& value = values_[station];
    consistent_ = consistent_ && topology_.stations[station].cable == cable;
    if (std::isnan(value)) value = arc_length;
    consistent_ = consistent_ && std::abs(value - arc_length) <= kSamePlace * harness_.cables[cable].length;
  }

  /// The stations that nothing but a break of the cable's properties can claim.
  void putBreaks(std::size_t cable) {
    std::vector<std::size_t> left;
    for (std::size_t station : topology_.cable_stations[cable]) {
      if (std::isnan(values_[station])) left.push_back(station);
    }
    const Cable& of = harness_.cables[cable];
    if (left.empty() && of.sections.size() < 2 && of.rest_curvature.size() < 2) return;
    std::size_t used = 0;
    for (double s : RodProfile(of).breaks()) {
      const auto& stations = topology_.cable_stations[cable];
      const bool taken = std::any_of(stations.begin(), stations.end(), [&](std::size_t station) {
        return std::abs(values_[station] - s) <= kSamePlace * of.length;
      });
      if (taken) continue;
      if (used == left.size()) {
        consistent_ = false;
        return;
      }
      values_[left[used++]] = s;
    }
    consistent_ = consistent_ && used == left.size();
  }

  std::optional<std::vector<double>> take() {
    for (std::size_t c = 0; c < topology_.cable_stations.size(); ++c) {
      const auto& stations = topology_.cable_stations[c];
      for (std::size_t i = 1; i < stations.size(); ++i) {
        const double step = values_[stations[i]] - values_[stations[i - 1]];
        consistent_ = consistent_ && step > kSamePlace * harness_.cables[c].length;
      }
    }
    if (!consistent_) return std::nullopt;
    return std::move(values_);
  }

 private:
  const Topology& topology_;
  const Harness& harness_;
  std::vector<double> values_;
  bool consistent_ = true;
};

}  // namespace

Topology makeTopology(const Harness& harness) {
  validate(harness);
  const std::vector<Places> places = collectPlaces(harness);
  Topology topology;
  topology.cable_stations.resize(harness.cables.size());
  topology.cable_spans.resize(harness.cables.size());
  for (std::size_t c = 0; c < harness.cables.size(); ++c) {
    for (double s : places[c].sorted()) {
      if (!topology.cable_stations[c].empty()) {
        topology.cable_spans[c].push_back(topology.spans.size());
        topology.spans.push_back({c, topology.stations.size() - 1, topology.stations.size()});
      }
      topology.cable_stations[c].push_back(topology.stations.size());
      Station station;
      station.cable = c;
      station.arc_length = s;
      topology.stations.push_back(station);
    }
  }
  for (std::size_t i = 0; i < harness.clips.size(); ++i) {
    if (!harness.clips[i].attached) {
      topology.clip_station.push_back(kNoStation);
      continue;
    }
    topology.clip_station.push_back(stationAt(topology, harness.clips[i].cable, harness.clips[i].arc_length));
    topology.stations[topology.clip_station.back()].clip = i;
  }
  for (std::size_t i = 0; i < harness.joints.size(); ++i) {
    const Joint& joint = harness.joints[i];
    topology.joint_parent.push_back(stationAt(topology, joint.parent, joint.parent_arc_length));
    topology.joint_child.push_back(stationAt(topology, joint.child, joint.child_arc_length));
    Station& child = topology.stations[topology.joint_child.back()];
    child.joint = i;
    child.parent = topology.joint_parent.back();
  }
  for (std::size_t i = 0; i < harness.loads.size(); ++i) {
    topology.stations[stationAt(topology, harness.loads[i].cable, harness.loads[i].arc_length)]
        .loads.push_back(i);
  }
  topology.order = parentsFirst(topology);
  return topology;
}

bool sameStructure(const Harness& a, const Topology& of_a, const Harness& b, const Topology& of_b) {
  const auto alike = [](const PartContact& s, const PartContact& t) {
    return s.cable == t.cable && s.surface == t.surface;
  };
  if (!std::equal(a.contacts.begin(), a.contacts.end(), b.contacts.begin(), b.contacts.end(), alike))
    return false;
  if (a.cables.size() != b.cables.size() || a.clips.size() != b.clips.size() ||
      a.joints.size() != b.joints.size() || of_a.stations.size() != of_b.stations.size()) {
    return false;
  }
  for (std::size_t i = 0; i < of_a.stations.size(); ++i) {
    const Station& s = of_a.stations[i];
    const Station& t = of_b.stations[i];
    if (s.cable != t.cable || s.clip != t.clip || s.joint != t.joint || s.parent != t.parent ||
        s.loads != t.loads) {
      return false;
    }
  }
  return sameKinds(a, b);
}

std::optional<std::vector<double>> stationArcLengths(const Harness& nominal, const Topology& topology,
                                                     const Harness& harness) {
  if (nominal.cables.size() != harness.cables.size() || nominal.clips.size() != harness.clips.size() ||
      nominal.joints.size() != harness.joints.size() || nominal.loads.size() != harness.loads.size() ||
      !sameKinds(nominal, harness)) {
    return std::nullopt;
  }
  ArcLengths found(topology, harness);
  for (std::size_t c = 0; c < harness.cables.size(); ++c) {
    found.put(topology.cable_stations[c].front(), c, 0.0);
    found.put(topology.cable_stations[c].back(), c, harness.cables[c].length);
  }
  for (std::size_t i = 0; i < harness.clips.size(); ++i) {
    const Clip& clip = harness.clips[i];
    if (clip.attached) found.put(topology.clip_station[i], clip.cable, clip.arc_length);
  }
  for (std::size_t i = 0; i < harness.joints.size(); ++i) {
    const Joint& joint = harness.joints[i];
    found.put(topology.joint_parent[i], joint.parent, joint.parent_arc_length);
    found.put(topology.joint_child[i], joint.child, joint.child_arc_length);
  }
  for (std::size_t i = 0; i < topology.stations.size(); ++i) {
    for (std::size_t load : topology.stations[i].loads) {
      found.put(i, harness.loads[load].cable, harness.loads[load].arc_length);
    }
  }
  for (std::size_t c = 0; c < harness.cables.size(); ++c) found.putBreaks(c);
  return found.take();
}

}  // namespace cable_variation
