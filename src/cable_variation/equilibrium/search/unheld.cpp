#include <cable_variation/equilibrium/search/unheld.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace cable_variation {
namespace {

bool letsGo(const ClipConstraint& constraint) {
  return constraint.slides ||
         std::any_of(constraint.translation.begin(), constraint.translation.end(),
                     [](const ClipFreedom& along) { return along.kind == ClipFreedom::Kind::free; });
}

// Per cable the first of those that joints make one with it.
std::vector<std::size_t> groupsOf(const Harness& harness) {
  std::vector<std::size_t> group(harness.cables.size());
  std::iota(group.begin(), group.end(), std::size_t{0});
  for (std::size_t round = 0; round < harness.joints.size(); ++round) {
    for (const Joint& joint : harness.joints)
      group[joint.parent] = group[joint.child] = std::min(group[joint.parent], group[joint.child]);
  }
  return group;
}

}  // namespace

std::string unheldCables(const Harness& harness) {
  const std::vector<std::size_t> groups = groupsOf(harness);
  std::string text;
  for (std::size_t group = 0; group < groups.size(); ++group) {
    if (groups[group] != group) continue;
    std::string clips;
    bool held = false;
    for (const Clip& clip : harness.clips) {
      if (!clip.attached || groups[clip.cable] != group || !clip.constraint.holdsPosition()) continue;
      held = held || !letsGo(clip.constraint);
      clips += (clips.empty() ? "'" : ", '") + clip.name +
               (clip.constraint.slides ? "' (slides)" : "' (lets go on)");
    }
    if (held) continue;
    std::string cables;
    for (std::size_t c = 0; c < groups.size(); ++c) {
      if (groups[c] == group) cables += (cables.empty() ? "'" : ", '") + harness.cables[c].name + "'";
    }
    text += (text.empty() ? "" : "; ") + ("nothing holds " + cables + " along its way: " + clips);
  }
  return text;
}

}  // namespace cable_variation
