#include <algorithm>
#include <cmath>

#include <cable_variation/scene/harness_slips.h>
#include <cable_variation/scene_file/slip_checks.h>

namespace cable_variation {
namespace {

void checkThickness(const YamlCursor& item, const Cable& cable) {
  if (const std::string slip = thicknessSlip(cable); !slip.empty()) item.warn(slip);
  const std::string slip = restShapeSlip(cable);
  if (slip.empty()) return;
  const auto shape = item.find("rest_shape");
  (shape ? *shape : item).warn(slip);
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

void checkBending(const YamlCursor& stiffness, const std::string& key, double EA, double radius) {
  const auto given = stiffness.find(key);
  if (!given) return;
  const double value = given->number(quantity::bending_stiffness);
  const double most = mostBendingStiffness(EA, radius);
  if (value <= most) return;
  const Range plausible{0.0, most, true};
  given->warn(given->foundAs(value, "N m^2") + "; with EA and radius as they are expected " + "at most " +
              shortNumber(most) + " N m^2" + meant(*given, value, plausible, {{"N mm^2", 1e-6}}));
}

void checkStiffness(const YamlCursor& owner) {
  const auto stiffness = owner.find("stiffness");
  if (!stiffness) return;
  const double radius = stiffness->number("radius", quantity::length);
  const double EA = stiffness->number("EA", quantity::stretch_stiffness);
  const double area = roundArea(radius);
  const double second_moment = roundSecondMoment(radius);
  checkAgainst(*stiffness, "EA", quantity::stretch_stiffness, area, kPlausibleStretchModulus, "modulus", "Pa",
               {{"kN", 1e3}, {"MN", 1e6}});
  for (const char* key : {"EI", "EI_y", "EI_z", "GJ"}) {
    checkAgainst(*stiffness, key, quantity::bending_stiffness, second_moment, kPlausibleBendingModulus,
                 "modulus", "Pa", {{"N mm^2", 1e-6}});
    checkBending(*stiffness, key, EA, radius);
  }
  checkAgainst(*stiffness, "mass_per_length", quantity::mass_per_length, area, kPlausibleBulkDensity,
               "density", "kg/m^3", {{"g/m", 1e-3}, {"kg/mm", 1e3}});
}

// Clips, and points that the cable is to pass, that it cannot reach by far.
void checkReach(const YamlCursor& item, const std::vector<YamlCursor>& clips, const Harness& harness,
                std::size_t index) {
  const Cable& cable = harness.cables[index];
  for (const ClipSlip& slip : reachSlips(harness, index)) clips[slip.clip].warn(slip.text);
  const std::vector<std::size_t> held = placingClips(harness, index);
  const auto via = item.find("via");
  if (!via || held.empty()) return;
  for (std::size_t i = 0; i < cable.via.size(); ++i) {
    const Clip& first = harness.clips[held.front()];
    const double away = (cable.via[i] - first.pose.position).norm();
    if (away <= farthestReach(cable)) continue;
    via->items()[i].warn("the point is " + shortNumber(away) + " m from clip '" + first.name +
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
    const std::string fault =
        length ? lengthSlip(scene.harness, i, length->found(), length->isBareNumber()) : "";
    if (!fault.empty()) length->warn(fault);
    checkReach(items[i], clips, scene.harness, i);
  }
}

void checkForces(const YamlCursor& root, const Scene& scene) {
  for (const YamlCursor& clip : namedItems(root, "clips", "clip")) checkLoad(clip, scene);
  for (const YamlCursor& load : namedItems(root, "loads", "load")) checkLoad(load, scene);
}

}  // namespace cable_variation
