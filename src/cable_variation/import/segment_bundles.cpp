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

// Of a wire by itself; a density stands for a mass that is not known.
BundleWire bundleWire(const KblWirePart& part, const BundleRule& rule) {
  BundleWire wire;
  wire.conductor_area = part.conductor_area.value_or(0.0);
  wire.mass_per_length = part.mass_per_length.value_or(rule.density * wireArea(part, rule));
  return wire;
}

// A radius from what there is: the file's area, else the wires', else a thin wire's [m].
double radiusOf(const KblDocument& document, const KblSegment& segment, const std::set<std::size_t>& wires,
                const BundleRule& rule, ImportFindings& findings) {
  double area = 0.0;
  for (const std::size_t index : wires)
    area += wireArea(document.wire_parts[document.wires[index].part], rule);
  if (segment.area) {
    constexpr double kRounding = 1.001;
    if (area > kRounding * *segment.area) {
      findings.push_back({Kind::thin_cross_section, segment.id, segment.line,
                          "Segment '" + segment.id + "': its cross-section is " +
                              numberText(1e6 * *segment.area, 4) + " mm^2, and the wires through it have " +
                              numberText(1e6 * area, 4) + " mm^2; its diameter is taken as it is"});
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

std::vector<SegmentBundle> segmentBundles(const KblDocument& document, const BundleRule& rule,
                                          ImportFindings& findings) {
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
    const KblWirePart& part = document.wire_parts[wire.part];
    if (part.mass_per_length || !without_mass.insert(wire.part).second) continue;
    findings.push_back({Kind::wire_without_mass, part.id, 0,
                        "General_wire '" + part.id + "' (part " + part.part_number +
                            "): there is no Mass_information; the bundle rule's density is taken"});
  }
  std::set<std::size_t> light;
  std::vector<SegmentBundle> bundles;
  for (std::size_t i = 0; i < document.segments.size(); ++i) {
    const KblSegment& segment = document.segments[i];
    std::vector<BundleWire> wires;
    for (const std::size_t wire : wires_in[i])
      wires.push_back(bundleWire(document.wire_parts[document.wires[wire].part], rule));
    double protection = 0.0;
    for (const KblProtectionArea& area : segment.protections) {
      const KblProtection& cover = document.protections[area.protection];
      protection += std::abs(area.end - area.start) * cover.mass_per_length.value_or(0.0);
      if (cover.mass_per_length || !light.insert(area.protection).second) continue;
      findings.push_back({Kind::protection_without_mass, cover.id, 0,
                          "Wire_protection_occurrence '" + cover.id + "' (part " + cover.part_number +
                              "): there is no Mass_information; it weighs nothing"});
    }
    const double radius = radiusOf(document, segment, wires_in[i], rule, findings);
    bundles.push_back({bundleSection(radius, wires, protection, rule), wires.size()});
  }
  return bundles;
}

}  // namespace cable_variation
