#include <cable_variation/import/segment_bundles.h>

#include <algorithm>
#include <cmath>
#include <set>

#include <cable_variation/util/number_text.h>

namespace cable_variation {
namespace {

using Kind = ImportFinding::Kind;

// The cross-section of a wire, its insulation included [m²].
double wireArea(const KblWirePart& part, const BundleRule& rule) {
  return part.outside_diameter ? M_PI / 4.0 * *part.outside_diameter * *part.outside_diameter
                               : part.conductor_area.value_or(0.0) / rule.conductor_share;
}

// As the file says, or the supplier's table where that is given.
KblWirePart tabled(KblWirePart part, const ImportMapping& mapping) {
  const auto rule = mapping.wires.find(part.part_number);
  if (rule == mapping.wires.end()) return part;
  if (rule->second.conductor_area) part.conductor_area = rule->second.conductor_area;
  if (rule->second.diameter) part.outside_diameter = rule->second.diameter;
  if (rule->second.mass_per_length) part.mass_per_length = rule->second.mass_per_length;
  return part;
}

// Of a wire by itself; a density stands for a mass that is not known.
BundleWire bundleWire(const KblWirePart& part, const ImportMapping& mapping) {
  BundleWire wire;
  wire.conductor_area = part.conductor_area.value_or(0.0);
  wire.mass_per_length =
      part.mass_per_length.value_or(mapping.bundle.density * wireArea(part, mapping.bundle));
  wire.diameter = part.outside_diameter.value_or(0.0);
  const auto rule = mapping.wires.find(part.part_number);
  if (rule == mapping.wires.end()) return wire;
  wire.modulus = rule->second.modulus;
  wire.EI = rule->second.EI;
  wire.GJ = rule->second.GJ;
  return wire;
}

// What tape or tube adds to a bundle of `radius` that it covers all along; a wall is a tube around it.
BundleCover coverOf(const KblProtection& protection, double radius, const ImportMapping& mapping) {
  BundleCover cover;
  cover.mass_per_length = protection.mass_per_length.value_or(0.0);
  const ProtectionRule* rule = mapping.ruleOf(protection);
  if (rule == nullptr) return cover;
  cover.mass_per_length = rule->mass_per_length.value_or(cover.mass_per_length);
  cover.EA = rule->EA.value_or(0.0);
  cover.EI = rule->EI.value_or(0.0);
  cover.GJ = rule->GJ.value_or(cover.EI / (1.0 + mapping.bundle.poisson_ratio));
  if (!rule->thickness) return cover;
  const double outer = radius + *rule->thickness;
  cover.EA = *rule->modulus * M_PI * (outer * outer - radius * radius);
  cover.EI = *rule->modulus * M_PI / 4.0 * (std::pow(outer, 4) - std::pow(radius, 4));
  cover.GJ = cover.EI / (1.0 + mapping.bundle.poisson_ratio);
  return cover;
}

// A radius from what there is: the file's area, else the wires', else a thin wire's [m].
double radiusOf(const std::vector<KblWirePart>& parts, const KblDocument& document, const KblSegment& segment,
                const std::set<std::size_t>& wires, const BundleRule& rule, ImportFindings& findings) {
  double area = 0.0;
  for (const std::size_t index : wires) area += wireArea(parts[document.wires[index].part], rule);
  if (segment.area) {
    constexpr double kRounding = 1.001;
    if (area > kRounding * *segment.area) {
      findings.push_back({Kind::thin_cross_section, segment.id, segment.line,
                          "Segment '" + segment.id + "': its cross-section is " +
                              numberText(1e6 * *segment.area, 4) + " mm^2, and the wires through it have " +
                              numberText(1e6 * area, 4) + " mm^2; its diameter is taken to be " +
                              numberText(2e3 * std::sqrt(area / M_PI), 4) + " mm, that of its wires"});
      return std::sqrt(area / M_PI);
    }
    return std::sqrt(*segment.area / M_PI);
  }
  const bool known = area > 0.0;
  if (!known) area = rule.wire_area / rule.conductor_share;
  const double radius = std::sqrt(area / M_PI);
  findings.push_back({Kind::no_cross_section, segment.id, segment.line,
                      "Segment '" + segment.id +
                          "': there is no Cross_section_area_information; its diameter is taken to be " +
                          numberText(2e3 * radius, 4) + " mm, that of " +
                          (known ? "its wires" : "one wire of the bundle rule")});
  return radius;
}

}  // namespace

std::vector<SegmentBundle> segmentBundles(const KblDocument& document, const ImportMapping& mapping,
                                          ImportFindings& findings) {
  std::vector<KblWirePart> parts;
  for (const KblWirePart& part : document.wire_parts) parts.push_back(tabled(part, mapping));
  std::vector<std::set<std::size_t>> wires_in(document.segments.size());
  std::vector<bool> routed(document.wires.size(), false);
  for (const KblRouting& routing : document.routings) {
    for (const std::size_t segment : routing.segments) {
      wires_in[segment].insert(routing.wire);
      routed[routing.wire] = true;
    }
  }
  std::set<std::size_t> without_mass;
  for (std::size_t i = 0; i < document.wires.size(); ++i) {
    const KblWire& wire = document.wires[i];
    if (!routed[i]) {
      findings.push_back(
          {Kind::wire_without_route, wire.id, 0,
           "General_wire_occurrence '" + wire.id + "': no Routing has segments for it; it counts nowhere"});
      continue;
    }
    const KblWirePart& part = parts[wire.part];
    if (part.mass_per_length || !without_mass.insert(wire.part).second) continue;
    findings.push_back({Kind::wire_without_mass, part.id, 0,
                        "General_wire '" + part.id + "' (part " + part.part_number +
                            "): there is no Mass_information; the bundle rule's density is taken"});
  }
  std::set<std::size_t> light;
  std::vector<SegmentBundle> bundles;
  for (std::size_t i = 0; i < document.segments.size(); ++i) {
    const KblSegment& segment = document.segments[i];
    const double radius = radiusOf(parts, document, segment, wires_in[i], mapping.bundle, findings);
    std::vector<BundleWire> wires;
    for (const std::size_t wire : wires_in[i])
      wires.push_back(bundleWire(parts[document.wires[wire].part], mapping));
    BundleCover covers;
    for (const KblProtectionArea& area : segment.protections) {
      const KblProtection& protection = document.protections[area.protection];
      const BundleCover cover = coverOf(protection, radius, mapping);
      const double share = std::abs(area.end - area.start);
      covers.mass_per_length += share * cover.mass_per_length;
      covers.EA += share * cover.EA;
      covers.EI += share * cover.EI;
      covers.GJ += share * cover.GJ;
      if (cover.mass_per_length > 0.0 || protection.mass_per_length || !light.insert(area.protection).second)
        continue;
      findings.push_back({Kind::protection_without_mass, protection.id, 0,
                          "Wire_protection_occurrence '" + protection.id + "' (part " +
                              protection.part_number + "): there is no Mass_information; it weighs nothing"});
    }
    const BundleBounds bounds = bundleBounds(radius, wires, covers, mapping.bundle);
    bundles.push_back({sectionBetween(bounds, mapping.bundle.sticking), bounds, wires.size()});
  }
  return bundles;
}

}  // namespace cable_variation
