#include <cable_variation/scene/design_slips.h>

#include <algorithm>
#include <cmath>

#include <cable_variation/scene/harness_slips.h>

namespace cable_variation {
namespace {

struct Unit {
  const char* name;
  double factor;
};

// A figure of a section against what a round section of its radius could have.
std::string odd(const std::string& what, double value, const char* unit, double per, const Range& plausible,
                const Unit& meant) {
  if (value == 0.0 || !(per > 0.0) || plausible.holds(value / per)) return "";
  return what + " is " + shortNumber(value) + " " + unit + "; expected " +
         Range{plausible.low * per, plausible.high * per, false}.text(unit) + " at this radius; " +
         (plausible.holds(value * meant.factor / per) ? std::string("in ") + meant.name + "?"
                                                      : "is that meant?");
}

void addSection(const std::string& who, const Section& section, std::vector<std::string>& slips) {
  const double area = roundArea(section.radius), inertia = roundSecondMoment(section.radius);
  const double most = mostBendingStiffness(section.EA, section.radius);
  const Range bending{kPlausibleBendingModulus.low,
                      inertia > 0.0 ? std::min(kPlausibleBendingModulus.high, most / inertia) : 0.0, false};
  const Unit per_millimetre{"N mm^2", 1e-6};
  for (const std::string& slip : {odd("EA", section.EA, "N", area, kPlausibleStretchModulus, {"kN", 1e3}),
                                  odd("EI", section.EI_y, "N m^2", inertia, bending, per_millimetre),
                                  odd("GJ", section.GJ, "N m^2", inertia, bending, per_millimetre),
                                  odd("its mass per length", section.mass_per_length, "kg/m", area,
                                      kPlausibleBulkDensity, {"g/m", 1e-3})}) {
    if (!slip.empty()) slips.push_back(who + slip);
  }
}

void addCable(const Harness& harness, std::size_t index, std::vector<std::string>& slips) {
  const Cable& cable = harness.cables[index];
  const std::string who = "cable '" + cable.name + "': ";
  for (const std::string& slip :
       {thicknessSlip(cable), restShapeSlip(cable),
        lengthSlip(harness, index, "found '" + shortNumber(cable.length) + "'", true)}) {
    if (!slip.empty()) slips.push_back(who + slip);
  }
  addSection(who, cable.sections.front().section, slips);
  for (const ClipSlip& slip : reachSlips(harness, index)) {
    slips.push_back("clip '" + harness.clips[slip.clip].name + "': " + slip.text);
  }
}

}  // namespace

std::string turnSlip(double angle) {
  constexpr double kRounding = 1e-9;
  constexpr double kLeastWhole = 2.0;  // [rad]: nobody turns by a whole number of radians
  const double size = std::abs(angle);
  const double half_turns = size / M_PI;
  const bool whole = size >= kLeastWhole && std::abs(size - std::round(size)) < kRounding;
  const bool far = size > 2.0 * M_PI && std::abs(half_turns - std::round(half_turns)) > 0.01;
  if (!whole && !far) return "";
  return "it is " + shortNumber(angle) + " rad, which is " + shortNumber(angle * 180.0 / M_PI) +
         " deg; in deg?";
}

std::string shiftSlip(const Scene& scene, double distance) {
  const double longest = longestCable(scene.harness);
  if (!(std::abs(distance) > longest)) return "";
  return "it is " + shortNumber(distance) + " m, where the longest cable has " + shortNumber(longest) +
         " m; in mm?";
}

std::vector<std::string> slipsOf(const Design& design) {
  std::vector<std::string> slips;
  const Harness harness = harnessAt(design, {});
  for (std::size_t i = 0; i < harness.cables.size(); ++i) addCable(harness, i, slips);
  for (const DesignVariable& variable : design.scene.design_variables) {
    const auto shifted = design.shifted.find(variable.name);
    if (shifted == design.shifted.end()) continue;
    const std::string slip = variable.unit == "rad" ? turnSlip(shifted->second)
                             : variable.unit == "m" ? shiftSlip(design.scene, shifted->second)
                                                    : "";
    if (!slip.empty()) slips.push_back("design variable '" + variable.name + "': " + slip);
  }
  return slips;
}

std::vector<std::string> newSlips(const Design& before, const Design& edited) {
  const std::vector<std::string> old = slipsOf(before);
  std::vector<std::string> slips = slipsOf(edited);
  slips.erase(
      std::remove_if(slips.begin(), slips.end(),
                     [&](const std::string& s) { return std::find(old.begin(), old.end(), s) != old.end(); }),
      slips.end());
  return slips;
}

}  // namespace cable_variation
