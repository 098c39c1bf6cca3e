#include <cable_variation/scene_file/cable_writer.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <cable_variation/scene_file/value_text.h>
#include <cable_variation/util/number_text.h>

namespace cable_variation {
namespace {

constexpr double kUnchanged = 1e-12;  // relative

bool isSame(double a, double b) { return std::abs(a - b) <= kUnchanged * std::abs(b); }

bool isSame(const Section& a, const Section& b) {
  return isSame(a.EA, b.EA) && isSame(a.GA_y, b.GA_y) && isSame(a.GA_z, b.GA_z) && isSame(a.GJ, b.GJ) &&
         isSame(a.EI_y, b.EI_y) && isSame(a.EI_z, b.EI_z) && isSame(a.mass_per_length, b.mass_per_length) &&
         isSame(a.radius, b.radius);
}

bool isSame(const std::vector<SectionAt>& a, const std::vector<SectionAt>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!isSame(a[i].arc_length, b[i].arc_length) || !isSame(a[i].section, b[i].section)) return false;
  }
  return true;
}

bool isSame(const std::vector<RestCurvatureAt>& a, const std::vector<RestCurvatureAt>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!isSame(a[i].arc_length, b[i].arc_length)) return false;
    if ((a[i].curvature - b[i].curvature).norm() > kUnchanged * b[i].curvature.norm()) return false;
  }
  return true;
}

std::string siText(double value) {
  constexpr int kDigits = 12;
  return numberText(value, kDigits);
}

std::string stiffnessText(const Section& section) {
  return "stiffness: {EA: " + siText(section.EA) + ", GA_y: " + siText(section.GA_y) +
         ", GA_z: " + siText(section.GA_z) + ", EI_y: " + siText(section.EI_y) +
         ", EI_z: " + siText(section.EI_z) + ", GJ: " + siText(section.GJ) +
         ", mass_per_length: " + siText(section.mass_per_length) + ", radius: " + lengthText(section.radius) +
         "}";
}

// Puts a number in the place of that of a key, if it is there.
void writeNumber(const YAML::Node& map, const char* key, double value, const Quantity& quantity,
                 YamlText& text) {
  const auto range = text.valueOf(map, key);
  if (!range) return;
  const bool alias = text.at(*range).front() == '*';
  text.replace(*range, alias ? siText(value) : valueLike(text.at(*range), value, quantity));
}

void scaleLength(const YAML::Node& map, const char* key, double factor, YamlText& text) {
  if (!text.valueOf(map, key)) return;
  writeNumber(map, key, factor * parseQuantity(map[key].Scalar(), quantity::length), quantity::length, text);
}

// A section that was given by its geometry, scaled as a whole: else only its stiffness is left to tell.
bool isSimilar(const Section& loaded, const Section& wanted) {
  const double factor = wanted.radius / loaded.radius, area = factor * factor, inertia = area * area;
  Section scaled = loaded;
  scaled.radius *= factor;
  for (double* each : {&scaled.EA, &scaled.GA_y, &scaled.GA_z, &scaled.mass_per_length}) *each *= area;
  for (double* each : {&scaled.GJ, &scaled.EI_y, &scaled.EI_z}) *each *= inertia;
  return isSame(scaled, wanted);
}

// @param owner has a `section` or a `stiffness`
void writeSection(const YAML::Node& owner, const Section& loaded, const Section& wanted, YamlText& text) {
  if (isSame(loaded, wanted)) return;
  if (const YAML::Node stiffness = owner["stiffness"]) {
    writeNumber(stiffness, "EA", wanted.EA, quantity::stretch_stiffness, text);
    writeNumber(stiffness, "EI", wanted.EI_y, quantity::bending_stiffness, text);
    writeNumber(stiffness, "EI_y", wanted.EI_y, quantity::bending_stiffness, text);
    writeNumber(stiffness, "EI_z", wanted.EI_z, quantity::bending_stiffness, text);
    writeNumber(stiffness, "GJ", wanted.GJ, quantity::bending_stiffness, text);
    writeNumber(stiffness, "mass_per_length", wanted.mass_per_length, quantity::mass_per_length, text);
    writeNumber(stiffness, "radius", wanted.radius, quantity::length, text);
  } else if (isSimilar(loaded, wanted)) {
    for (const char* key : {"radius", "outer_radius", "inner_radius", "wall", "width", "height"})
      scaleLength(owner["section"], key, wanted.radius / loaded.radius, text);
  } else if (const auto entry = text.entryOf(owner, "section")) {
    text.replace(*entry, stiffnessText(wanted));
  }
}

void writeSections(const YAML::Node& entry, const Cable& loaded, const Cable& wanted, YamlText& text) {
  const YAML::Node list = entry["sections"];
  if (!list) {
    writeSection(entry, loaded.sections.front().section, wanted.sections.front().section, text);
    return;
  }
  if (list.size() == wanted.sections.size() && loaded.sections.size() == wanted.sections.size()) {
    for (std::size_t i = 0; i < list.size(); ++i) {
      const double at = wanted.sections[i].arc_length;
      if (!isSame(loaded.sections[i].arc_length, at)) {
        if (const auto place = text.valueOf(list[i], "at")) text.replace(*place, lengthText(at));
      }
      writeSection(list[i], loaded.sections[i].section, wanted.sections[i].section, text);
    }
    return;
  }
  std::string by = "[";  // cut off
  for (const SectionAt& section : wanted.sections) {
    by += (by.size() > 1 ? ", " : "") + ("{at: " + lengthText(section.arc_length)) + ", " +
          stiffnessText(section.section) + "}";
  }
  if (const auto range = text.valueOf(entry, "sections")) text.replace(*range, by + "]");
}

std::string curvatureText(const std::vector<RestCurvatureAt>& rest) {
  std::string text;
  for (const RestCurvatureAt& each : rest) {
    const Eigen::Vector3d& k = each.curvature;
    text += (text.empty() ? "" : ", ") + ("{at: " + lengthText(each.arc_length)) + ", value: [" +
            siText(k.x()) + ", " + siText(k.y()) + ", " + siText(k.z()) + "]}";
  }
  return "{curvature: [" + text + "]}";
}

}  // namespace

void writeCable(const YAML::Node& entry, const Cable& loaded, const Cable& wanted, YamlText& text) {
  if (wanted.length != loaded.length) writeNumber(entry, "length", wanted.length, quantity::length, text);
  if (!isSame(loaded.sections, wanted.sections)) writeSections(entry, loaded, wanted, text);
  const YAML::Node shape = entry["rest_shape"];
  // points must make a curve of the cable's length
  const bool stale = shape && shape["points"] && wanted.length != loaded.length;
  if (!stale && isSame(loaded.rest_curvature, wanted.rest_curvature)) return;
  if (const auto range = text.valueOf(entry, "rest_shape"))
    text.replace(*range, curvatureText(wanted.rest_curvature));
}

std::string cableText(const Cable& cable) {
  if (cable.sections.size() != 1 || !cable.rest_curvature.empty() || !cable.via.empty() || cable.twist) {
    throw std::invalid_argument("cable '" + cable.name +
                                "' cannot be written; expected one section, and no rest shape or hints");
  }
  return "{name: " + cable.name + ", length: " + lengthText(cable.length) + ", " +
         stiffnessText(cable.sections.front().section) + "}";
}

}  // namespace cable_variation
