#include <cable_variation/import/bundle_mapping.h>

#include <string>
#include <vector>

namespace cable_variation {
namespace {

const Quantity kArea{"an area", "m^2", "0.5 mm^2", {0, 2, 0, 0}, "m^2, mm^2"};

// What a supplier's table may say, each above 0.
struct TableKey {
  const char* name;
  const Quantity& quantity;
  std::optional<double>* to;
};

void readTable(const YamlCursor& item, const std::vector<TableKey>& keys) {
  std::vector<std::string> names;
  names.reserve(keys.size());
  for (const TableKey& key : keys) names.emplace_back(key.name);
  if (!item.checkKeys(names)) return;
  for (const TableKey& key : keys) {
    if (const auto given = item.find(key.name)) *key.to = given->number(key.quantity, Range::positive());
  }
}

void readStickingRange(const YamlCursor& map, ImportMapping& mapping) {
  const auto range = map.find("sticking_range");
  if (map.has("sticking_distribution")) {
    const std::vector<std::string> names{"triangular", "uniform", "truncated_normal"};
    mapping.sticking_distribution = names[map.choice("sticking_distribution", names)];
    if (!range) map.find("sticking_distribution")->fail("it goes with sticking_range");
  }
  if (!range) return;
  const std::vector<YamlCursor> ends = range->items(2);
  if (ends.size() != 2) return;
  const Range share{0.0, 1.0, false};
  const double low = ends[0].number(quantity::number, share), high = ends[1].number(quantity::number, share);
  const double nominal = mapping.bundle.sticking;
  if (!(low <= nominal && nominal <= high && low < high))
    range->fail("found " + shortNumber(low) + " to " + shortNumber(high) +
                "; expected a range around sticking, " + shortNumber(nominal));
  mapping.sticking_range = {low, high};
}

}  // namespace

std::map<std::string, WireRule> readWireRules(const YamlCursor& map) {
  std::map<std::string, WireRule> wires;
  if (!map.isMap()) {
    map.fail(map.found() + "; expected a map from part numbers to {conductor_area, diameter, ...}");
    return wires;
  }
  for (const auto& [name, value] : map.entries()) {
    WireRule& rule = wires[name];
    readTable(value.labelled("wire '" + name + "'"),
              {{"conductor_area", kArea, &rule.conductor_area},
               {"diameter", quantity::length, &rule.diameter},
               {"mass_per_length", quantity::mass_per_length, &rule.mass_per_length},
               {"modulus", quantity::pressure, &rule.modulus},
               {"EI", quantity::bending_stiffness, &rule.EI},
               {"GJ", quantity::bending_stiffness, &rule.GJ}});
  }
  return wires;
}

std::map<std::string, ProtectionRule> readProtectionRules(const YamlCursor& map) {
  std::map<std::string, ProtectionRule> protections;
  if (!map.isMap()) {
    map.fail(map.found() +
             "; expected a map from part numbers or types to {EI, GJ, thickness, modulus, ...}");
    return protections;
  }
  for (const auto& [name, value] : map.entries()) {
    const YamlCursor item = value.labelled("protection '" + name + "'");
    ProtectionRule& rule = protections[name];
    readTable(item, {{"mass_per_length", quantity::mass_per_length, &rule.mass_per_length},
                     {"EA", quantity::stretch_stiffness, &rule.EA},
                     {"EI", quantity::bending_stiffness, &rule.EI},
                     {"GJ", quantity::bending_stiffness, &rule.GJ},
                     {"thickness", quantity::length, &rule.thickness},
                     {"modulus", quantity::pressure, &rule.modulus}});
    if (rule.thickness.has_value() != rule.modulus.has_value())
      item.fail("expected both of thickness and modulus, or none");
    if (rule.thickness && (rule.EA || rule.EI || rule.GJ))
      item.fail("EA, EI or GJ are there beside thickness and modulus; expected the ones or the others");
  }
  return protections;
}

void readBundleRule(const YamlCursor& map, ImportMapping& mapping) {
  BundleRule& rule = mapping.bundle;
  constexpr double kNoArea = 0.0;
  if (!map.checkKeys({"conductor_modulus", "bending_modulus", "sticking", "sticking_range",
                      "sticking_distribution", "poisson_ratio", "density", "conductor_share", "wire_area"})) {
    return;
  }
  for (const auto& entry : map.entries()) mapping.given.insert("bundle." + entry.first);
  const Range share{0.0, 1.0, false};
  rule.conductor_modulus =
      map.number("conductor_modulus", quantity::pressure, Range::positive(), rule.conductor_modulus);
  rule.bending_modulus =
      map.number("bending_modulus", quantity::pressure, Range::positive(), rule.bending_modulus);
  rule.sticking = map.number("sticking", quantity::number, share, rule.sticking);
  rule.poisson_ratio = map.number("poisson_ratio", quantity::number, {-1.0, 0.5, true}, rule.poisson_ratio);
  rule.density = map.number("density", quantity::density, Range::positive(), rule.density);
  rule.conductor_share =
      map.number("conductor_share", quantity::number, {kNoArea, 1.0, true}, rule.conductor_share);
  rule.wire_area = map.number("wire_area", kArea, Range::positive(), rule.wire_area);
  readStickingRange(map, mapping);
}

}  // namespace cable_variation
