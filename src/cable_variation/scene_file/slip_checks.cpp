#include <cable_variation/scene_file/slip_checks.h>

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include <cable_variation/harness/clip_preset.h>
#include <cable_variation/scene/harness_slips.h>
#include <cable_variation/scene/moving_components.h>

namespace cable_variation {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

constexpr double kMillimetre = 1e-3;
constexpr double kLargestPart = 10.0;      // [m]
constexpr double kSmallestPart = 1e-3;     // [m]
constexpr double kFarAway = 100.0;         // [m], and lengths of the longest cable
constexpr double kLeastGravity = 1.5;      // [m/s^2]; the moon has 1.6
constexpr double kMostGravity = 20.0;      // [m/s^2]
const Range kModulus{5e5, 1.2e12, false};  // [Pa], from soft silicone to diamond
const Range kDensity{20.0, 23e3, false};   // [kg/m^3], from foam to osmium

AlignedBox3d boxOf(const Visual& visual, const Pose& pose) {
  AlignedBox3d box;
  if (!visual.mesh) return box;
  for (const Vector3d& vertex : visual.mesh->vertices) box.extend(pose * (visual.pose * vertex));
  return box;
}

AlignedBox3d boxOf(const Component& component, const Pose& pose) {
  AlignedBox3d box;
  for (const Visual& visual : component.visuals) box.extend(boxOf(visual, pose));
  return box;
}

// What is wrong with a size; empty: nothing.
std::string odd(const Vector3d& size, bool scaled) {
  const double most = size.maxCoeff();
  const std::string measures = "it measures " + sizeText(size);
  if (most > kLargestPart) {
    return measures + ", more than " + shortNumber(kLargestPart) + " m; " +
           (scaled ? "is its scale right?" : "in mm? (then scale: 0.001)");
  }
  if (most < kSmallestPart) {
    return measures + ", less than 1 mm; " + (scaled ? "is its scale right?" : "in which unit is it?");
  }
  return "";
}

void checkSize(const YamlCursor& item, const Component& component) {
  const auto urdf = item.find("urdf");
  if (!urdf) {
    const std::string fault = odd(sizeOf(component), item.has("scale"));
    if (const auto mesh = item.find("mesh"); mesh && !fault.empty()) mesh->warn(fault);
    return;
  }
  bool told = false;
  for (const Visual& visual : component.visuals) {
    if (visual.mesh_resource.empty()) continue;
    const std::string fault =
        odd(boxOf(visual, Pose()).sizes(), visual.mesh_scale != Vector3d(Vector3d::Ones()));
    if (fault.empty()) continue;
    urdf->warn("link '" + visual.name + "': " + fault);
    told = true;
  }
  const std::string fault = told ? "" : odd(sizeOf(component), true);
  if (!fault.empty()) urdf->warn(fault);
}

// Whether it is where no cable could come to.
void checkPlace(const YamlCursor& item, const Component& component, const Scene& scene) {
  const auto pose = item.find("pose");
  if (!pose || component.visuals.empty() || scene.harness.clips.empty()) return;
  const AlignedBox3d box = boxOf(component, componentPose(scene, component.name));
  double nearest = std::numeric_limits<double>::infinity();
  for (const Clip& clip : scene.harness.clips) {
    if (isMounted(clip)) nearest = std::min(nearest, box.exteriorDistance(clip.pose.position));
  }
  if (std::isfinite(nearest) && nearest > kFarAway && nearest > kFarAway * longestCable(scene)) {
    pose->warn("it is " + shortNumber(nearest) + " m away from all clips; in mm?");
  }
}

void checkMaterial(const YamlCursor& material) {
  if (const auto modulus = material.find("young_modulus")) {
    const double value = modulus->number(quantity::pressure);
    if (!kModulus.holds(value)) {
      modulus->warn(modulus->foundAs(value, "Pa") + "; cables have " + kModulus.text("Pa") +
                    meant(*modulus, value, kModulus, {{"kPa", 1e3}, {"MPa", 1e6}, {"GPa", 1e9}}));
    }
  }
  if (const auto density = material.find("density")) {
    const double value = density->number(quantity::density);
    if (value > 0.0 && !kDensity.holds(value)) {
      density->warn(
          density->foundAs(value, "kg/m^3") + "; cables have " + kDensity.text("kg/m^3") +
          meant(*density, value, kDensity,
                {{"g/m^3", 1e-3}, {"g/cm^3", 1e3}, {"g/mm^3", 1e6}, {"kg/mm^3", 1e9}, {"t/mm^3", 1e12}}));
    }
  }
}

void checkMaterialOf(const YamlCursor& owner) {
  const auto section = owner.find("section");
  const auto material = section ? section->find("material") : section;
  if (material && material->isMap()) checkMaterial(*material);
}

}  // namespace

std::vector<YamlCursor> namedItems(const YamlCursor& root, const std::string& key, const std::string& kind) {
  const auto list = root.find(key);
  if (!list) return {};
  const std::vector<YamlCursor> unnamed = list->items();
  std::vector<YamlCursor> items;
  items.reserve(unnamed.size());
  for (const YamlCursor& item : unnamed) {
    items.push_back(item.labelled(kind + " '" + item.text("name") + "'"));
  }
  return items;
}

std::string meant(const YamlCursor& number, double value, const Range& plausible, const MeantUnits& units) {
  std::string list;
  for (const auto& [unit, factor] : units) {
    if (plausible.holds(value * factor)) list += (list.empty() ? "" : " or ") + std::string(unit);
  }
  return list.empty() || !number.isBareNumber() ? "; is that meant?" : "; in " + list + "?";
}

double longestCable(const Scene& scene) { return longestCable(scene.harness); }

Vector3d sizeOf(const Component& component) {
  const AlignedBox3d box = boxOf(component, Pose());
  return box.isEmpty() ? Vector3d::Zero() : Vector3d(box.sizes());
}

std::string sizeText(const Vector3d& size) {
  return shortNumber(size.x()) + " x " + shortNumber(size.y()) + " x " + shortNumber(size.z()) + " m";
}

void checkWorld(const YamlCursor& root, const Scene& scene) {
  const double gravity = scene.harness.gravity.norm();
  const Range plausible{kLeastGravity, kMostGravity, false};
  if (const auto given = root.find("gravity"); given && gravity > 0.0 && !plausible.holds(gravity)) {
    std::string meant_unit = "; is that meant?";
    if (plausible.holds(gravity * kMillimetre)) meant_unit = "; in mm/s^2?";
    if (plausible.holds(gravity * 9.81)) meant_unit = "; in g?";
    given->warn("it is " + shortNumber(gravity) + " m/s^2; expected 9.81 m/s^2 or so, or 0" + meant_unit);
  }
  const auto accuracy = root.find("accuracy");
  for (const Cable& cable : scene.harness.cables) {
    for (const SectionAt& knot : cable.sections) {
      if (!accuracy || scene.accuracy <= knot.section.radius) continue;
      accuracy->warn("it is " + shortNumber(scene.accuracy) + " m, more than the radius of cable '" +
                     cable.name + "', " + shortNumber(knot.section.radius) + " m; is that meant?");
      return;
    }
  }
}

void checkMaterials(const YamlCursor& root) {
  if (const auto materials = root.find("materials")) {
    for (const auto& [name, material] : materials->entries())
      checkMaterial(material.labelled("material '" + name + "'"));
  }
  for (const YamlCursor& cable : namedItems(root, "cables", "cable")) {
    checkMaterialOf(cable);
    if (const auto sections = cable.find("sections")) {
      for (const YamlCursor& section : sections->items()) checkMaterialOf(section);
    }
  }
}

void checkComponents(const YamlCursor& root, const Scene& scene) {
  const std::vector<YamlCursor> items = namedItems(root, "components", "component");
  std::size_t of = 0;
  for (const YamlCursor& item : items) {
    const std::vector<std::size_t> bodies = bodiesOf(scene, of);
    for (const std::size_t i : bodies) {
      if (scene.components[i].visuals.empty()) continue;
      checkSize(item, scene.components[i]);
      checkPlace(item, scene.components[i], scene);
    }
    of += bodies.size();  // a robot's links stand behind its root
  }
}

}  // namespace cable_variation
