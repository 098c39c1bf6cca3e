#pragma once  // internal to import/

#include <map>
#include <string>

#include <cable_variation/import/import_mapping.h>
#include <cable_variation/scene_file/yaml_cursor.h>

namespace cable_variation {

// The parts of a mapping file that say how stiff bundles are. Faults are told by the cursor.

std::map<std::string, WireRule> readWireRules(const YamlCursor& map);
std::map<std::string, ProtectionRule> readProtectionRules(const YamlCursor& map);
/// The rule itself, and the range of its sticking.
void readBundleRule(const YamlCursor& map, ImportMapping& mapping);

}  // namespace cable_variation
