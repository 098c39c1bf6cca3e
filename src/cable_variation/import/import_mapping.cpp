#include <cable_variation/import/import_mapping.h>

#include <stdexcept>
#include <vector>

#include <yaml-cpp/yaml.h>

#include <cable_variation/harness/clip_preset.h>
#include <cable_variation/import/bundle_mapping.h>
#include <cable_variation/scene_file/scene_reader.h>
#include <cable_variation/scene_file/yaml_cursor.h>
#include <cable_variation/scene_file/yaml_document.h>
#include <cable_variation/util/name_list.h>

namespace cable_variation {
namespace {

const std::vector<std::string>& clipParameters() {
  static const std::vector<std::string> keys{"axis",        "normal",   "rolls", "stiffness",
                                             "translation", "rotation", "slides"};
  return keys;
}

// The further keys of a clip in one line, and what it holds: as of a scene with one such clip.
void readClip(const YamlCursor& rule, const YAML::Node& node, const std::string& type, PartRule& to) {
  std::string more;
  for (const std::string& key : clipParameters()) {
    if (!rule.has(key)) continue;
    if (!node.IsDefined() || !node[key]) {
      rule.fail("'" + key + "' is merged in by <<; expected it to stand here");
      return;
    }
    YAML::Emitter text;
    text << YAML::Flow << node[key];
    more += ", " + key + ": " + text.c_str();
  }
  const std::string scene =
      "cables: [{name: cable, length: 1, stiffness: {EA: 1e4, GA: 1e4, EI: 0.01, GJ: 0.01, "
      "mass_per_length: 0.1, radius: 0.005}}]\n"
      "clips:\n"
      "  - {name: end, type: fixed, cable: cable, at: start, pose: {position: [0, 0, 0]}}\n"
      "  - {name: clip, cable: cable, at: 0.5, pose: {position: [0.5, 0, 0]}, type: " +
      type + more + "}\n";
  try {
    const Scene read = readSceneText(scene, "", [](const std::string&) { return std::string(); });
    to.constraint = read.harness.clips.back().constraint;
  } catch (const SceneError& error) {
    for (const SceneFault& fault : error.faults()) rule.fail(fault.message);
    return;
  }
  to.clip = type;
  to.more = more.empty() ? more : more.substr(2);
}

PartRule readRule(const YamlCursor& cursor, const YAML::Node& node) {
  PartRule rule;
  std::vector<std::string> keys{"clip", "tolerance"};
  keys.insert(keys.end(), clipParameters().begin(), clipParameters().end());
  if (!cursor.checkKeys(keys)) return rule;
  std::vector<std::string> names{"none"};
  for (const ClipPresetTraits& traits : clipPresets()) {
    if (traits.mounted) names.emplace_back(traits.name);
  }
  const std::size_t before = cursor.faults().count();
  const std::size_t choice = cursor.choice("clip", names);
  if (cursor.has("tolerance")) rule.tolerance = cursor.text("tolerance");
  if (cursor.faults().count() > before) return rule;
  if (choice > 0) readClip(cursor, node, names[choice], rule);
  return rule;
}

std::map<std::string, PartRule> readRules(const YamlCursor& map, const YAML::Node& node, const char* what) {
  std::map<std::string, PartRule> rules;
  if (!map.isMap()) {
    map.fail(map.found() + "; expected a map from " + what + " to {clip, tolerance}");
    return rules;
  }
  for (const auto& [name, value] : map.entries())
    rules[name] = readRule(value.labelled(std::string(what) + " '" + name + "'"),
                           node.IsDefined() && node.IsMap() ? node[name] : YAML::Node());
  return rules;
}

std::map<std::string, ToleranceClass> readTolerances(const YamlCursor& map) {
  std::map<std::string, ToleranceClass> classes;
  if (!map.isMap()) {
    map.fail(map.found() + "; expected a map from names to {translate, rotate, arc_length, length, sigma}");
    return classes;
  }
  for (const auto& [name, value] : map.entries()) {
    const YamlCursor item = value.labelled("tolerance '" + name + "'");
    ToleranceClass& one = classes[name];
    if (!item.checkKeys({"translate", "rotate", "arc_length", "length", "sigma"})) continue;
    const auto read = [&](const char* key, const Quantity& quantity, std::optional<double>& to) {
      if (const auto given = item.find(key)) to = given->number(quantity, Range::positive());
    };
    read("translate", quantity::length, one.translate);
    read("rotate", quantity::angle, one.rotate);
    read("arc_length", quantity::length, one.arc_length);
    read("length", quantity::length, one.length);
    one.sigma = item.number("sigma", quantity::number, Range::positive(), one.sigma);
  }
  return classes;
}

void checkTolerance(const YamlCursor& root, const std::string& who, const std::string& name,
                    const ImportMapping& mapping) {
  if (name.empty() || mapping.tolerances.count(name) > 0) return;
  std::vector<std::string> names;
  for (const auto& entry : mapping.tolerances) names.push_back(entry.first);
  root.fail(who + ": there is no tolerance '" + name + "'" + didYouMean(name, names));
}

void readMapping(const YamlCursor& root, const YAML::Node& node, ImportMapping& mapping) {
  if (!root.checkKeys({"parts", "types", "tolerances", "cable_tolerance", "wires", "protections", "bundle",
                       "length", "rest_shape", "least_bend", "via_spacing", "route_limit", "accuracy"})) {
    return;
  }
  for (const auto& entry : root.entries()) mapping.given.insert(entry.first);
  if (const auto map = root.find("tolerances")) mapping.tolerances = readTolerances(*map);
  if (const auto map = root.find("parts")) mapping.parts = readRules(*map, node["parts"], "part");
  if (const auto map = root.find("types")) mapping.types = readRules(*map, node["types"], "type");
  if (const auto map = root.find("wires")) mapping.wires = readWireRules(*map);
  if (const auto map = root.find("protections")) mapping.protections = readProtectionRules(*map);
  if (const auto map = root.find("bundle")) readBundleRule(*map, mapping);
  if (root.has("length")) {
    mapping.length = root.choice("length", {"virtual", "physical"}) == 0 ? LengthSource::virtual_length
                                                                         : LengthSource::physical_length;
  }
  if (root.has("rest_shape")) {
    mapping.rest_shape = root.choice("rest_shape", {"straight", "curve"}) == 0 ? ImportedRestShape::straight
                                                                               : ImportedRestShape::curve;
  }
  const Range spacing{1e-3, 10.0, false};
  const Range accuracy{1e-6, 1e-2, false};  // as in a scene
  const Range bend{0.5, 100.0, false};
  mapping.least_bend = root.number("least_bend", quantity::number, bend, mapping.least_bend);
  mapping.via_spacing = root.number("via_spacing", quantity::length, spacing, mapping.via_spacing);
  if (const auto limit = root.find("route_limit"))
    mapping.route_limit = limit->number(quantity::length, Range::positive());
  mapping.accuracy = root.number("accuracy", quantity::length, accuracy, mapping.accuracy);
  if (const auto name = root.find("cable_tolerance")) {
    mapping.cable_tolerance = name->text();
    checkTolerance(*name, "cables", mapping.cable_tolerance, mapping);
  }
  for (const auto& [key, rules] :
       {std::pair<const char*, const std::map<std::string, PartRule>&>("parts", mapping.parts),
        {"types", mapping.types}}) {
    if (const auto map = root.find(key)) {
      for (const auto& [name, rule] : rules) {
        const auto item = map->find(name);
        checkTolerance(item ? *item : *map, name, rule.tolerance, mapping);
      }
    }
  }
}

}  // namespace

const PartRule* ImportMapping::ruleOf(const KblOccurrence& part) const {
  if (const auto rule = parts.find(part.part_number); rule != parts.end()) return &rule->second;
  for (const std::string& type : {part.type, part.element}) {
    if (const auto rule = types.find(type); !type.empty() && rule != types.end()) return &rule->second;
  }
  return nullptr;
}

const ProtectionRule* ImportMapping::ruleOf(const KblProtection& protection) const {
  for (const std::string& name : {protection.part_number, protection.type}) {
    if (const auto rule = protections.find(name); !name.empty() && rule != protections.end())
      return &rule->second;
  }
  return nullptr;
}

ImportMapping readImportMappingText(const std::string& text, const std::string& source) {
  FaultList faults(source);
  ImportMapping mapping;
  try {
    const YAML::Node root = readYamlDocument(text, faults);
    if (root.IsMap()) {
      readMapping(YamlCursor(root, root.Mark().line + 1, "", faults), root, mapping);
    } else if (faults.count() == 0 && !root.IsNull()) {
      faults.add(1, "the file is no mapping; expected a map with parts, types, bundle");
    }
  } catch (const FaultList::Full&) {
  }
  if (faults.count() > 0) throw SceneError(faults.sorted());
  return mapping;
}

ImportMapping readImportMapping(const std::string& path) {
  std::string text;
  try {
    text = readSceneFile(path);
  } catch (const std::invalid_argument& error) {
    throw SceneError({{path, 0, std::string("the file ") + error.what()}});
  }
  return readImportMappingText(text, path);
}

}  // namespace cable_variation
