#pragma once  // internal to scene_file/

#include <string>

#include <yaml-cpp/yaml.h>

#include <cable_variation/rod/cable.h>
#include <cable_variation/scene_file/yaml_text.h>

namespace cable_variation {

/// Puts a cable's length, sections and rest shape into its entry of a scene file, as far as they have
/// changed. A section that was given by its geometry and has another stiffness than a larger or smaller one
/// becomes a `stiffness`; a list of which a shorter cable cuts off the end likewise. Rest shapes become
/// curvatures.
void writeCable(const YAML::Node& entry, const Cable& loaded, const Cable& wanted, YamlText& text);

/// A cable as an entry of its own, of one section given by its stiffness and straight when free of stress.
/// Throws std::invalid_argument for another one.
std::string cableText(const Cable& cable);

}  // namespace cable_variation
