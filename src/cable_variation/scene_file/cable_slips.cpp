#include <algorithm>
#include <cmath>
#include <optional>

#include <cable_variation/scene_file/slip_checks.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;

constexpr double kPi = 3.14159265358979323846;
constexpr double kLongestSpan = 10.0;             // cable per distance of the clips that hold it
constexpr double kLongestBranch = 100.0;          // likewise, of clips on other cables
constexpr double kLongestBare = 10.0;             // [m], of a length without a unit that nothing explains
constexpr double kCoincident = 1e-6;              // [m], of clips that make a loop
const Range kStretchModulus{1e3, 1.2e12, false};  // EA per area [Pa]; little for coiled cords
const Range kBendingModulus{1e2, 1.2e12, false};  // EI per second moment; little where many wires slide
const Range kBulkDensity{5.0, 23e3, false};       // mass per length and area [kg/m^3]; little for thin hoses

struct Held {
  const Clip* clip;
  std::size_t index;
};

// Clips that hold a cable in a place, by arc length.
std::vector<Held> heldPlaces(const Harness& harness, std::size_t cable) {
  std::vector<Held> held;
  for (std::size_t i = 0; i < harness.clips.size(); ++i) {
    const Clip& clip = harness.clips[i];
    const auto& t = clip.constraint.translation;
    const bool placed = std::none_of(t.begin(), t.end(),
                                     [](const ClipFreedom& f) { return f.kind == ClipFreedom::Kind::free; });
    if (clip.cable == cable && placed) held.push_back({&clip, i});
  }
  std::stable_sort(held.begin(), held.end(),
                   [](const Held& a, const Held& b) { return a.clip->arc_length < b.clip->arc_length; });
  return held;
}

// Diagonal of the box about them: of two, their distance.
double spanOf(const std::vector<Held>& held) {
  Eigen::AlignedBox3d box;
  for (const Held& one : held) box.extend(one.clip->pose.position);
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

void checkThickness(const YamlCursor& item, const Cable& cable) {
  const double thickness = 2.0 * largestRadius(cable);
  if (thickness > cable.length) {
    item.warn("it is " + shortNumber(thickness) + " m thick and " + shortNumber(cable.length) +
              " m long; in mm, one of them?");
  }
  for (const RestCurvatureAt& knot : cable.rest_curvature) {
    const double bend = knot.curvature.tail<2>().norm();
    if (!(bend * smallestRadius(cable) > 1.0)) continue;
    const auto shape = item.find("rest_shape");
    (shape ? *shape : item)
        .warn("it bends to a radius of " + shortNumber(1.0 / bend) + " m at " + shortNumber(knot.arc_length) +
              " m, less than the cable's own of " + shortNumber(smallestRadius(cable)) + " m; in 1/m?");
    return;
  }
}

// A stiffness or mass against what a round section of the radius could have.
void checkAgainst(const YamlCursor& stiffness, const std::string& key, const Quantity& quantity, double per,
                  const Range& plausible, const char* what, const char* unit, const MeantUnits& units) {
  const auto given = stiffness.find(key);
  if (!given || !(per > 0.0)) return;
  const double value = given->number(quantity) / per;
  if (value == 0.0 || plausible.holds(value)) return;
  given->warn(given->found() + ", which at this radius is a " + what + " of " + shortNumber(value) + " " +
              unit + "; cables have " + plausible.text(unit) + meant(*given, value, plausible, units));
}

// EI and GJ against EA: stiffness in bending comes from what is within the radius.
void checkBending(const YamlCursor& stiffness, const std::string& key, double EA, double radius) {
  constexpr double kMost = 100.0;  // a solid round section has 1/4
  const auto given = stiffness.find(key);
  if (!given) return;
  const double value = given->number(quantity::bending_stiffness);
  const double most = kMost * EA * radius * radius;
  if (value <= most) return;
  const Range plausible{0.0, most, true};
  given->warn(given->found() + ", which is " + shortNumber(value) +
              " N m^2; with EA and radius as they are expected " + "at most " + shortNumber(most) + " N m^2" +
              meant(*given, value, plausible, {{"N mm^2", 1e-6}}));
}

void checkStiffness(const YamlCursor& owner) {
  const auto stiffness = owner.find("stiffness");
  if (!stiffness) return;
  const double radius = stiffness->number("radius", quantity::length);
  const double EA = stiffness->number("EA", quantity::stretch_stiffness);
  const double area = kPi * radius * radius;
  const double second_moment = 0.25 * area * radius * radius;
  checkAgainst(*stiffness, "EA", quantity::stretch_stiffness, area, kStretchModulus, "modulus", "Pa",
               {{"kN", 1e3}, {"MN", 1e6}});
  for (const char* key : {"EI", "EI_y", "EI_z", "GJ"}) {
    checkAgainst(*stiffness, key, quantity::bending_stiffness, second_moment, kBendingModulus, "modulus",
                 "Pa", {{"N mm^2", 1e-6}});
    checkBending(*stiffness, key, EA, radius);
  }
  checkAgainst(*stiffness, "mass_per_length", quantity::mass_per_length, area, kBulkDensity, "density",
               "kg/m^3", {{"g/m", 1e-3}, {"kg/mm", 1e3}});
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

// Whether a cable is much longer than what it has to reach.
std::string tooLong(const YamlCursor& length, const Harness& harness, std::size_t index) {
  const Cable& cable = harness.cables[index];
  const std::string meant_unit = length.isBareNumber() ? "; in mm?" : "; is that meant?";
  const std::vector<Held> own = heldPlaces(harness, index);
  const double span = spanOf(own);
  if (span > kCoincident) {
    const double between = own.back().clip->arc_length - own.front().clip->arc_length;
    if (between > kLongestSpan * span) {
      return shortNumber(between) + " m of it are between clips that are " + shortNumber(span) +
             " m apart; expected less than " + shortNumber(kLongestSpan) + " times as much" + meant_unit;
    }
    if (cable.length <= kLongestSpan * span) return "";
  }
  if (!length.isBareNumber()) return "";
  std::vector<Held> all;
  for (const std::size_t other : connected(harness, index)) {
    const std::vector<Held> held = heldPlaces(harness, other);
    all.insert(all.end(), held.begin(), held.end());
  }
  const double reach = spanOf(all);
  if (reach > kCoincident && cable.length > kLongestBranch * reach) {
    return length.found() + " without a unit, which is " + shortNumber(cable.length) +
           " m; the clips of its harness are " + shortNumber(reach) + " m apart" + meant_unit;
  }
  if (cable.length <= kLongestBare || (reach > kCoincident && cable.length <= kLongestSpan * reach))
    return "";
  return length.found() + " without a unit, which is " + shortNumber(cable.length) + " m" + meant_unit;
}

// Clips, and points that the cable is to pass, that it cannot reach by far.
void checkReach(const YamlCursor& item, const std::vector<YamlCursor>& clips, const Harness& harness,
                std::size_t index) {
  constexpr double kFar = 10.0;  // lengths of the cable
  const Cable& cable = harness.cables[index];
  const std::vector<Held> held = heldPlaces(harness, index);
  for (std::size_t i = 1; i < held.size(); ++i) {
    const double apart = (held[i].clip->pose.position - held[i - 1].clip->pose.position).norm();
    if (apart <= kFar * cable.length) continue;
    clips[held[i].index].warn("it is " + shortNumber(apart) + " m from clip '" + held[i - 1].clip->name +
                              "', which is on the same cable '" + cable.name + "' of " +
                              shortNumber(cable.length) + " m; in mm?");
  }
  const auto via = item.find("via");
  if (!via || held.empty()) return;
  for (std::size_t i = 0; i < cable.via.size(); ++i) {
    const double away = (cable.via[i] - held.front().clip->pose.position).norm();
    if (away <= kFar * cable.length) continue;
    via->items()[i].warn("the point is " + shortNumber(away) + " m from clip '" + held.front().clip->name +
                         "', and the cable is " + shortNumber(cable.length) + " m long; in mm?");
  }
}

void checkLoad(const YamlCursor& item, const Scene& scene) {
  const std::string name = item.text("cable");
  const auto& cables = scene.harness.cables;
  const auto cable =
      std::find_if(cables.begin(), cables.end(), [&](const Cable& c) { return c.name == name; });
  if (cable == cables.end()) return;
  const Section& section = cable->sections.front().section;
  if (const auto force = item.find("force")) {
    const double value = force->vector(quantity::force).norm();
    if (value > section.EA) {
      force->warn("it is " + shortNumber(value) + " N, which would stretch cable '" + name +
                  "' to more than twice its length (EA is " + shortNumber(section.EA) +
                  " N); is that meant?");
    }
  }
  if (const auto moment = item.find("moment")) {
    const double value = moment->vector(quantity::moment).norm();
    const double least = std::min(section.EI_y, section.EI_z) / section.radius;
    if (value > least) {
      moment->warn("it is " + shortNumber(value) + " N m, which would bend cable '" + name +
                   "' to less than its own radius, as from " + shortNumber(least) + " N m on; in N mm?");
    }
  }
}

}  // namespace

void checkCables(const YamlCursor& root, const Scene& scene) {
  const std::vector<YamlCursor> items = namedItems(root, "cables", "cable");
  for (std::size_t i = 0; i < items.size(); ++i) {
    checkThickness(items[i], scene.harness.cables[i]);
    checkStiffness(items[i]);
    if (const auto sections = items[i].find("sections")) {
      for (const YamlCursor& section : sections->items()) checkStiffness(section);
    }
  }
}

void checkRouting(const YamlCursor& root, const Scene& scene) {
  const std::vector<YamlCursor> items = namedItems(root, "cables", "cable");
  const std::vector<YamlCursor> clips = namedItems(root, "clips", "clip");
  for (std::size_t i = 0; i < items.size(); ++i) {
    const auto length = items[i].find("length");
    const std::string fault = length ? tooLong(*length, scene.harness, i) : "";
    if (!fault.empty()) length->warn(fault);
    checkReach(items[i], clips, scene.harness, i);
  }
}

void checkForces(const YamlCursor& root, const Scene& scene) {
  for (const YamlCursor& clip : namedItems(root, "clips", "clip")) checkLoad(clip, scene);
  for (const YamlCursor& load : namedItems(root, "loads", "load")) checkLoad(load, scene);
}

}  // namespace cable_variation
