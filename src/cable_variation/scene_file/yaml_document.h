#pragma once

#include <string>

#include <yaml-cpp/yaml.h>

#include <cable_variation/scene_file/fault_list.h>

namespace cable_variation {

/// The one document of a YAML text in UTF-8, with or without a byte order mark. Anchors and aliases
/// are followed. Null after a fault, each of which is told with its line: what is no YAML, an open quote, a
/// second document, an alias within its own anchor, more nesting or more values (counting what aliases stand
/// for) than any scene has.
YAML::Node readYamlDocument(const std::string& text, FaultList& faults);

}  // namespace cable_variation
