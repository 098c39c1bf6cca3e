#include <cable_variation/scene/harness_slips.h>

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace cable_variation {
namespace {

constexpr double kLongestSpan = 10.0;     // cable per distance of the clips that hold it
constexpr double kLongestBranch = 100.0;  // likewise, of clips on other cables
constexpr double kLongestBare = 10.0;     // [m], of a length without a unit that nothing explains
constexpr double kCoincident = 1e-6;      // [m], of clips that make a loop

// Diagonal of the box about clips: of two, their distance.
double spanOf(const Harness& harness, const std::vector<std::size_t>& clips) {
  Eigen::AlignedBox3d box;
  for (const std::size_t clip : clips) box.extend(harness.clips[clip].pose.position);
  return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

double smallestRadius(const Cable& cable) {
  double radius = cable.sections.front().section.radius;
  for (const SectionAt& knot : cable.sections) radius = std::min(radius, knot.section.radius);
  return radius;
}

double largestRadius(const Cable& cable) {
  double radius = 0.0;
  for (const SectionAt& knot : cable.sections) radius = std::max(radius, knot.section.radius);
  return radius;
}

// The cables that hang together with one, itself included.
std::vector<std::size_t> connected(const Harness& harness, std::size_t cable) {
  std::vector<std::size_t> group{cable};
  const auto has = [&](std::size_t one) { return std::find(group.begin(), group.end(), one) != group.end(); };
  for (bool grows = true; grows;) {
    grows = false;
    for (const Joint& joint : harness.joints) {
      if (has(joint.parent) == has(joint.child)) continue;
      group.push_back(has(joint.parent) ? joint.child : joint.parent);
      grows = true;
    }
  }
  return group;
}

}  // namespace

const Range kPlausibleStretchModulus{1e3, 1.2e12, false};
const Range kPlausibleBendingModulus{1e2, 1.2e12, false};
const Range kPlausibleBulkDensity{5.0, 23e3, false};

double longestCable(const Harness& harness) {
  double longest = 0.0;
  for (const Cable& cable : harness.cables) longest = std::max(longest, cable.length);
  return longest;
}

double roundArea(double radius) { return M_PI * radius * radius; }
double roundSecondMoment(double radius) { return 0.25 * roundArea(radius) * radius * radius; }

double mostBendingStiffness(double EA, double radius) {
  constexpr double kMost = 100.0;  // a solid round section has 1/4
  return kMost * EA * radius * radius;
}

std::string thicknessSlip(const Cable& cable) {
  const double thickness = 2.0 * largestRadius(cable);
  if (!(thickness > cable.length)) return "";
  return "it is " + shortNumber(thickness) + " m thick and " + shortNumber(cable.length) +
         " m long; in mm, one of them?";
}

std::string restShapeSlip(const Cable& cable) {
  for (const RestCurvatureAt& knot : cable.rest_curvature) {
    const double bend = knot.curvature.tail<2>().norm();
    if (!(bend * smallestRadius(cable) > 1.0)) continue;
    return "it bends to a radius of " + shortNumber(1.0 / bend) + " m at " + shortNumber(knot.arc_length) +
           " m, less than the cable's own of " + shortNumber(smallestRadius(cable)) + " m; in 1/m?";
  }
  return "";
}

std::string lengthSlip(const Harness& harness, std::size_t index, const std::string& found, bool bare) {
  const Cable& cable = harness.cables[index];
  const std::string meant_unit = bare ? "; in mm?" : "; is that meant?";
  const std::vector<std::size_t> own = placingClips(harness, index);
  const double span = spanOf(harness, own);
  if (span > kCoincident) {
    const double between = harness.clips[own.back()].arc_length - harness.clips[own.front()].arc_length;
    if (between > kLongestSpan * span) {
      return shortNumber(between) + " m of it are between clips that are " + shortNumber(span) +
             " m apart; expected less than " + shortNumber(kLongestSpan) + " times as much" + meant_unit;
    }
    if (cable.length <= kLongestSpan * span) return "";
  }
  if (!bare) return "";
  std::vector<std::size_t> all;
  for (const std::size_t other : connected(harness, index)) {
    const std::vector<std::size_t> held = placingClips(harness, other);
    all.insert(all.end(), held.begin(), held.end());
  }
  const double reach = spanOf(harness, all);
  if (reach > kCoincident && cable.length > kLongestBranch * reach) {
    return found + " without a unit, which is " + shortNumber(cable.length) +
           " m; the clips of its harness are " + shortNumber(reach) + " m apart" + meant_unit;
  }
  if (cable.length <= kLongestBare || (reach > kCoincident && cable.length <= kLongestSpan * reach)) {
    return "";
  }
  return found + " without a unit, which is " + shortNumber(cable.length) + " m" + meant_unit;
}

double farthestReach(const Cable& cable) { return 10.0 * cable.length; }

std::vector<ClipSlip> reachSlips(const Harness& harness, std::size_t index) {
  const Cable& cable = harness.cables[index];
  const std::vector<std::size_t> held = placingClips(harness, index);
  std::vector<ClipSlip> slips;
  for (std::size_t i = 1; i < held.size(); ++i) {
    const Clip& before = harness.clips[held[i - 1]];
    const double apart = (harness.clips[held[i]].pose.position - before.pose.position).norm();
    if (apart <= farthestReach(cable)) continue;
    slips.push_back({held[i], "it is " + shortNumber(apart) + " m from clip '" + before.name +
                                  "', which is on the same cable '" + cable.name + "' of " +
                                  shortNumber(cable.length) + " m; in mm?"});
  }
  return slips;
}

std::vector<std::size_t> placingClips(const Harness& harness, std::size_t cable) {
  std::vector<std::size_t> held;
  for (std::size_t i = 0; i < harness.clips.size(); ++i) {
    const Clip& clip = harness.clips[i];
    const auto& t = clip.constraint.translation;
    const bool placed = std::none_of(t.begin(), t.end(),
                                     [](const ClipFreedom& f) { return f.kind == ClipFreedom::Kind::free; });
    if (clip.attached && clip.cable == cable && placed) held.push_back(i);
  }
  std::stable_sort(held.begin(), held.end(), [&](std::size_t a, std::size_t b) {
    return harness.clips[a].arc_length < harness.clips[b].arc_length;
  });
  return held;
}

}  // namespace cable_variation
