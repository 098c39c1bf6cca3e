#include <cable_variation/measures/joint_between.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace cable_variation {

std::optional<JointBetween> jointBetween(const Harness& harness, std::size_t first, std::size_t second) {
  for (std::size_t i = 0; i < harness.joints.size(); ++i) {
    const Joint& joint = harness.joints[i];
    if (joint.parent == first && joint.child == second)
      return JointBetween{i, true, joint.parent_arc_length, joint.child_arc_length};
    if (joint.parent == second && joint.child == first)
      return JointBetween{i, false, joint.child_arc_length, joint.parent_arc_length};
  }
  return std::nullopt;
}

std::optional<JoinedAt> joinedAlong(const Harness& harness, std::size_t first, std::size_t second,
                                    double shortest_way) {
  // Dijkstra's way over joints, each passed from one of its cables to the other.
  struct Passed {
    double way = std::numeric_limits<double>::infinity();  // along the cables between [m]
    double on_first = 0.0, at = 0.0;                       // arc lengths where first is left, and here [m]
    std::size_t cable = 0;                                 // here
    bool done = false;
  };
  std::vector<Passed> passed(2 * harness.joints.size());
  const auto pass = [&](std::size_t cable, double at, double way, std::optional<double> on_first) {
    for (std::size_t i = 0; i < harness.joints.size(); ++i) {
      const Joint& joint = harness.joints[i];
      for (const bool from_parent : {true, false}) {
        if ((from_parent ? joint.parent : joint.child) != cable) continue;
        const double here = from_parent ? joint.parent_arc_length : joint.child_arc_length;
        const double longer = way + (on_first ? std::abs(here - at) : 0.0);
        Passed& known = passed[2 * i + (from_parent ? 1 : 0)];
        if (known.done || longer >= known.way) continue;
        known = {longer, on_first.value_or(here),
                 from_parent ? joint.child_arc_length : joint.parent_arc_length,
                 from_parent ? joint.child : joint.parent, false};
      }
    }
  };
  pass(first, 0.0, 0.0, std::nullopt);
  for (;;) {
    const auto next = std::min_element(passed.begin(), passed.end(), [](const Passed& a, const Passed& b) {
      return a.done != b.done ? b.done : a.way < b.way;
    });
    if (next == passed.end() || next->done || !(next->way < shortest_way)) return std::nullopt;
    if (next->cable == second) return JoinedAt{next->on_first, next->at, shortest_way - next->way};
    next->done = true;
    pass(next->cable, next->at, next->way, next->on_first);
  }
}

}  // namespace cable_variation
