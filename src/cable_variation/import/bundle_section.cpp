#include <cable_variation/import/bundle_section.h>

#include <algorithm>
#include <cmath>

namespace cable_variation {

Section bundleSection(double radius, const std::vector<BundleWire>& wires, double protection,
                      const BundleRule& rule) {
  const double area = M_PI * radius * radius;
  double conductors = 0.0;  // Σ Aᵢ
  double squares = 0.0;     // Σ Aᵢ²
  double mass = 0.0;
  for (const BundleWire& wire : wires) {
    conductors += wire.conductor_area;
    squares += wire.conductor_area * wire.conductor_area;
    mass += wire.mass_per_length;
  }
  if (!(conductors > 0.0)) {
    conductors = rule.conductor_share * area;
    squares = conductors * std::min(conductors, rule.wire_area);
  }
  if (!(mass > 0.0)) mass = rule.density * area;
  Section section;
  section.EA = rule.conductor_modulus * conductors;
  section.GA_y = section.GA_z = section.EA / (2.0 * (1.0 + rule.poisson_ratio));
  const double slipping = rule.bending_modulus * squares / (4.0 * M_PI);
  const double sticking = rule.conductor_modulus * conductors * radius * radius / 4.0;
  section.EI_y = section.EI_z = (1.0 - rule.sticking) * slipping + rule.sticking * sticking;
  section.GJ = section.EI_y / (1.0 + rule.poisson_ratio);
  section.mass_per_length = mass + protection;
  section.radius = radius;
  return section;
}

}  // namespace cable_variation
