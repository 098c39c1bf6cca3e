#pragma once  // internal to scene_file/

#include <map>
#include <string>

#include <cable_variation/rod/section.h>
#include <cable_variation/scene_file/yaml_cursor.h>

namespace cable_variation {

using Materials = std::map<std::string, Material>;

/// {young_modulus, poisson_ratio, density}
Material readMaterial(const YamlCursor& cursor);

/// The section of a map that has one of the keys
///   section: {type: solid, radius, material, shear_correction}
///            {type: hose, outer_radius | radius, inner_radius | wall, material, shear_correction}
///            {type: rectangle, width, height, material, shear_correction}
///   stiffness: {EA, GA | GA_y, GA_z, EI | EI_y, EI_z, GJ, mass_per_length, radius}
/// `material` is a name or a map. Nothing after a fault, or with a material that had one.
std::optional<Section> readSection(const YamlCursor& owner, const Materials& materials);

}  // namespace cable_variation
