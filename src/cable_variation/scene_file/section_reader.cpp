#include <cable_variation/scene_file/section_reader.h>

#include <cmath>
#include <stdexcept>
#include <tuple>

#include <cable_variation/util/name_list.h>

namespace cable_variation {
namespace {

Material readMaterialOf(const YamlCursor& section, const Materials& materials) {
  const auto value = section.require("material");
  if (!value) return {};
  if (value->isMap()) return readMaterial(*value);
  const std::string name = value->text();
  const auto material = materials.find(name);
  if (material != materials.end()) return material->second;
  std::vector<std::string> names;
  for (const auto& entry : materials) names.push_back(entry.first);
  if (!name.empty()) value->fail("there is no material '" + name + "'" + didYouMean(name, names));
  return {};
}

// Outer and inner radius [m] of a hose.
std::pair<double, double> readHoseRadii(const YamlCursor& section) {
  const double outer = section.number("outer_radius", quantity::length, Range::positive());
  const auto wall = section.find("wall");
  if (wall && section.has("inner_radius")) wall->fail("inner_radius is there too; expected one of them");
  Range within = Range::positive();
  if (outer > 0.0) within.high = outer;
  const double inner = wall ? outer - wall->number(quantity::length, within)
                            : section.number("inner_radius", quantity::length, within);
  if (inner == outer) section.fail("the hose has no wall; expected inner_radius < outer_radius");
  return {outer, inner};
}

bool isKnown(const Material& material) {
  return std::isfinite(material.young_modulus) && std::isfinite(material.poisson_ratio) &&
         std::isfinite(material.density);
}

std::optional<Section> readGeometricSection(const YamlCursor& section, const Materials& materials) {
  const auto type_value = section.isMap() ? section.require("type") : std::optional<YamlCursor>();
  if (!type_value) {
    if (!section.isMap()) section.checkKeys({"type", "material"});
    return {};
  }
  const std::size_t before = section.faults().count();
  const std::size_t type = type_value->choice({"solid", "hose", "rectangle"});
  if (section.faults().count() > before) return {};
  static const std::vector<std::vector<std::string>> keys{
      {"type", "material", "shear_correction", "radius"},
      {"type", "material", "shear_correction", "outer_radius", "inner_radius", "wall"},
      {"type", "material", "shear_correction", "width", "height"}};
  section.checkKeys(keys[type]);
  const Material material = readMaterialOf(section, materials);
  const double correction = section.number("shear_correction", quantity::number, {0.0, 1.0, true}, 1.0);
  double first = 0.0;
  double second = 0.0;
  if (type == 0) {
    first = section.number("radius", quantity::length, Range::positive());
  } else if (type == 1) {
    std::tie(first, second) = readHoseRadii(section);
  } else {
    first = section.number("width", quantity::length, Range::positive());
    second = section.number("height", quantity::length, Range::positive());
  }
  if (section.faults().count() > before || !isKnown(material)) return {};
  if (type == 0) return solidSection(first, material, correction);
  if (type == 1) return hoseSection(first, second, material, correction);
  return rectangleSection(first, second, material, correction);
}

// One value for both directions, or one for each.
std::pair<double, double> readPair(const YamlCursor& stiffness, const std::string& name,
                                   const Quantity& quantity) {
  if (stiffness.has(name + "_y") || stiffness.has(name + "_z")) {
    if (stiffness.has(name)) {
      stiffness.find(name)->fail("it is given per direction too; expected " + name + ", or " + name +
                                 "_y and " + name + "_z");
    }
    return {stiffness.number(name + "_y", quantity, Range::positive()),
            stiffness.number(name + "_z", quantity, Range::positive())};
  }
  const double both = stiffness.number(name, quantity, Range::positive());
  return {both, both};
}

std::optional<Section> readStiffness(const YamlCursor& stiffness) {
  Section section;
  const std::size_t before = stiffness.faults().count();
  if (!stiffness.checkKeys(
          {"EA", "GA", "GA_y", "GA_z", "EI", "EI_y", "EI_z", "GJ", "mass_per_length", "radius"})) {
    return {};
  }
  section.EA = stiffness.number("EA", quantity::stretch_stiffness, Range::positive());
  std::tie(section.GA_y, section.GA_z) = readPair(stiffness, "GA", quantity::stretch_stiffness);
  std::tie(section.EI_y, section.EI_z) = readPair(stiffness, "EI", quantity::bending_stiffness);
  section.GJ = stiffness.number("GJ", quantity::bending_stiffness, Range::positive());
  section.mass_per_length =
      stiffness.number("mass_per_length", quantity::mass_per_length, Range::notNegative());
  section.radius = stiffness.number("radius", quantity::length, Range::positive());
  if (stiffness.faults().count() > before) return {};
  return section;
}

}  // namespace

Material readMaterial(const YamlCursor& cursor) {
  Material material;
  if (!cursor.checkKeys({"young_modulus", "poisson_ratio", "density"})) return material;
  material.young_modulus = cursor.number("young_modulus", quantity::pressure, Range::positive());
  material.poisson_ratio = cursor.number("poisson_ratio", quantity::number, {-1.0, 0.5, true});
  material.density = cursor.number("density", quantity::density, Range::notNegative());
  return material;
}

std::optional<Section> readSection(const YamlCursor& owner, const Materials& materials) {
  const auto section = owner.find("section");
  const auto stiffness = owner.find("stiffness");
  if (section && stiffness) {
    stiffness->fail("'section' is there too; expected one of them");
    return {};
  }
  if (!section && !stiffness) {
    owner.fail("'section' or 'stiffness' is missing");
    return {};
  }
  try {
    const auto result = section ? readGeometricSection(*section, materials) : readStiffness(*stiffness);
    if (result) validate(*result);
    return result;
  } catch (const std::invalid_argument& error) {
    (section ? *section : *stiffness).fail(error.what());
    return {};
  }
}

}  // namespace cable_variation
