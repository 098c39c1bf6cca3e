#include <hunt/discrete_layout.h>

#include <algorithm>
#include <cmath>

#include <cable_variation/rod/profile.h>

namespace cable_variation::hunt {
namespace {

constexpr double kSamePlace = 1e-6;  // of the cable's length

void addStations(const Harness& harness, std::size_t cable, DiscreteLayout& layout) {
  const double length = harness.cables[cable].length;
  std::vector<double> at = {0.0, length};
  for (const Clip& clip : harness.clips) {
    if (clip.cable == cable) at.push_back(clip.arc_length);
  }
  for (const Joint& joint : harness.joints) {
    if (joint.parent == cable) at.push_back(joint.parent_arc_length);
    if (joint.child == cable) at.push_back(joint.child_arc_length);
  }
  for (const PointLoad& load : harness.loads) {
    if (load.cable == cable) at.push_back(load.arc_length);
  }
  std::sort(at.begin(), at.end());
  for (double s : at) {
    const bool first = layout.stations.empty() || layout.stations.back().cable != cable;
    if (!first && s - layout.stations.back().arc_length <= kSamePlace * length) continue;
    DiscreteStation station;
    station.cable = cable;
    station.arc_length = s;
    layout.stations.push_back(station);
  }
}

std::size_t stationAt(const DiscreteLayout& layout, std::size_t cable, double arc_length) {
  std::size_t best = layout.stations.size();
  for (std::size_t i = 0; i < layout.stations.size(); ++i) {
    if (layout.stations[i].cable != cable) continue;
    const auto distance = [&](std::size_t k) { return std::abs(layout.stations[k].arc_length - arc_length); };
    if (best == layout.stations.size() || distance(i) < distance(best)) best = i;
  }
  return best;
}

// How much denser the vertices are at a piece's ends: 0 evenly, towards 1 as the bending length gets short.
double gradingOf(const Harness& harness, const Cable& cable) {
  const Section& section = cable.sections.front().section;
  const double weight = section.mass_per_length * harness.gravity.norm() * cable.length;
  const double slenderness = weight * cable.length * cable.length / std::min(section.EI_y, section.EI_z);
  return std::clamp(0.3 * std::log10(std::max(1.0, slenderness / 100.0)), 0.0, 0.9);
}

std::vector<double> vertices(std::size_t segments, double grading) {
  std::vector<double> at;
  for (std::size_t i = 0; i <= segments; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(segments);
    at.push_back(t - grading * std::sin(2.0 * M_PI * t) / (2.0 * M_PI));
  }
  at.back() = 1.0;
  return at;
}

bool slidesAt(const Harness& harness, const DiscreteStation& station) {
  return std::any_of(harness.clips.begin(), harness.clips.end(), [&](const Clip& clip) {
    return clip.constraint.slides && clip.cable == station.cable &&
           std::abs(clip.arc_length - station.arc_length) <= kSamePlace * harness.cables[clip.cable].length;
  });
}

// Puts the nearest vertex where the cable's properties have a kink or step, unless the piece slides over it.
void meetKnots(const Harness& harness, DiscreteLayout& layout) {
  for (DiscretePiece& piece : layout.pieces) {
    const DiscreteStation &left = layout.stations[piece.left], &right = layout.stations[piece.right];
    if (slidesAt(harness, left) || slidesAt(harness, right)) continue;
    for (double s : RodProfile(harness.cables[piece.cable]).breaks()) {
      const double t = (s - left.arc_length) / (right.arc_length - left.arc_length);
      const auto after = std::upper_bound(piece.at.begin(), piece.at.end(), t);
      if (t <= 0.0 || t >= 1.0) continue;
      const auto nearest = t - *(after - 1) < *after - t ? after - 1 : after;
      if (nearest != piece.at.begin() && nearest + 1 != piece.at.end()) *nearest = t;
    }
  }
}

}  // namespace

DiscreteLayout layOut(const Harness& harness, std::size_t segments, std::size_t least) {
  DiscreteLayout layout;
  for (std::size_t c = 0; c < harness.cables.size(); ++c) addStations(harness, c, layout);
  for (std::size_t i = 0; i + 1 < layout.stations.size(); ++i) {
    const std::size_t cable = layout.stations[i].cable;
    if (layout.stations[i + 1].cable != cable) continue;
    const Cable& of = harness.cables[cable];
    const double share = (layout.stations[i + 1].arc_length - layout.stations[i].arc_length) / of.length;
    const double count = std::ceil(share * static_cast<double>(segments));
    layout.pieces.push_back(
        {cable, i, i + 1,
         vertices(std::max(least, static_cast<std::size_t>(count)), gradingOf(harness, of))});
  }
  meetKnots(harness, layout);
  for (std::size_t i = 0; i < harness.clips.size(); ++i) {
    layout.clip_station.push_back(stationAt(layout, harness.clips[i].cable, harness.clips[i].arc_length));
    layout.stations[layout.clip_station.back()].clip = i;
  }
  for (std::size_t i = 0; i < harness.joints.size(); ++i) {
    const Joint& joint = harness.joints[i];
    layout.joint_parent.push_back(stationAt(layout, joint.parent, joint.parent_arc_length));
    layout.joint_child.push_back(stationAt(layout, joint.child, joint.child_arc_length));
    layout.stations[layout.joint_child.back()].joint = i;
    layout.stations[layout.joint_child.back()].parent = layout.joint_parent.back();
  }
  for (std::size_t i = 0; i < harness.loads.size(); ++i) {
    const PointLoad& load = harness.loads[i];
    layout.stations[stationAt(layout, load.cable, load.arc_length)].loads.push_back(i);
  }
  std::vector<bool> placed(layout.stations.size(), false);
  while (layout.parents_first.size() < layout.stations.size()) {
    for (std::size_t i = 0; i < layout.stations.size(); ++i) {
      const DiscreteStation& station = layout.stations[i];
      if (placed[i] || (station.joint && !placed[station.parent])) continue;
      placed[i] = true;
      layout.parents_first.push_back(i);
    }
  }
  return layout;
}

DiscreteLayout halved(const DiscreteLayout& layout) {
  DiscreteLayout finer = layout;
  for (DiscretePiece& piece : finer.pieces) {
    std::vector<double> at = {0.0};
    for (std::size_t i = 0; i + 1 < piece.at.size(); ++i) {
      at.push_back(0.5 * (piece.at[i] + piece.at[i + 1]));
      at.push_back(piece.at[i + 1]);
    }
    piece.at = at;
  }
  return finer;
}

}  // namespace cable_variation::hunt
