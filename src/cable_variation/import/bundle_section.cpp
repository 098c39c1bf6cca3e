#include <cable_variation/import/bundle_section.h>

#include <algorithm>
#include <cmath>

namespace cable_variation {
namespace {

// As many wires of the rule's kind as fill its share of the circle with conductors.
std::vector<BundleWire> usualWires(double area, const BundleRule& rule, double& count) {
  BundleWire wire;
  const double conductors = rule.conductor_share * area;
  wire.conductor_area = std::min(rule.wire_area, conductors);
  count = conductors / wire.conductor_area;
  return {wire};
}

bool hasConductor(const std::vector<BundleWire>& wires) {
  return std::any_of(wires.begin(), wires.end(),
                     [](const BundleWire& wire) { return wire.conductor_area > 0.0; });
}

}  // namespace

BundleBounds bundleBounds(double radius, const std::vector<BundleWire>& wires, const BundleCover& cover,
                          const BundleRule& rule) {
  const double area = M_PI * radius * radius;
  double mass = 0.0;
  for (const BundleWire& wire : wires) mass += wire.mass_per_length;
  if (!(mass > 0.0)) mass = rule.density * area;
  double count = 1.0;  // of each wire
  const std::vector<BundleWire> stiff = hasConductor(wires) ? wires : usualWires(area, rule, count);

  double EA = 0.0, slipping_EI = 0.0, slipping_GJ = 0.0, sticking_EI = 0.0, sticking_GJ = 0.0;
  for (const BundleWire& wire : stiff) {
    const double A = wire.conductor_area, E = wire.modulus.value_or(rule.conductor_modulus);
    const double own = A * A / (4.0 * M_PI);
    const double diameter =
        wire.diameter > 0.0 ? wire.diameter : 2.0 * std::sqrt(A / (rule.conductor_share * M_PI));
    const double aside = std::max(0.0, radius * radius / 4.0 - diameter * diameter / 16.0);
    const double EI = wire.EI.value_or(rule.bending_modulus * own);
    const double GJ = wire.GJ.value_or(EI / (1.0 + rule.poisson_ratio));
    // sticking strands are no softer than slipping ones, whatever the wire was measured to be
    const double stuck = std::max(EI, E * own) + E * A * aside;
    EA += count * E * A;
    slipping_EI += count * EI;
    slipping_GJ += count * GJ;
    sticking_EI += count * stuck;
    sticking_GJ += count * std::max(GJ, stuck / (1.0 + rule.poisson_ratio));
  }
  BundleBounds bounds;
  Section& section = bounds.slipping;
  section.EA = EA + cover.EA;
  section.GA_y = section.GA_z = section.EA / (2.0 * (1.0 + rule.poisson_ratio));
  section.mass_per_length = mass + cover.mass_per_length;
  section.radius = radius;
  bounds.sticking = section;
  section.EI_y = section.EI_z = slipping_EI + cover.EI;
  section.GJ = slipping_GJ + cover.GJ;
  bounds.sticking.EI_y = bounds.sticking.EI_z = sticking_EI + cover.EI;
  bounds.sticking.GJ = sticking_GJ + cover.GJ;
  return bounds;
}

Section sectionBetween(const BundleBounds& bounds, double sticking) {
  Section section = bounds.slipping;
  const auto between = [&](double slipping, double stuck) {
    return (1.0 - sticking) * slipping + sticking * stuck;
  };
  section.EI_y = section.EI_z = between(bounds.slipping.EI_y, bounds.sticking.EI_y);
  section.GJ = between(bounds.slipping.GJ, bounds.sticking.GJ);
  return section;
}

}  // namespace cable_variation
