#include <algorithm>
#include <set>

#include <cable_variation/report/shape_file/cable_points.h>
#include <cable_variation/report/shape_file/shape_file.h>
#include <cable_variation/util/number_text.h>

namespace cable_variation {

namespace {

constexpr std::size_t kLongestName = 31;  // of release 12

std::string group(int code, const std::string& value) { return std::to_string(code) + "\n" + value + "\n"; }

/// In capitals, as release 12 compares names; unlike those that are there.
std::string layerName(const std::string& cable, std::set<std::string>& taken) {
  std::string name;
  for (const char c : cable.substr(0, kLongestName)) {
    const bool letter = (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
    const bool other = (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '$';
    name += letter ? static_cast<char>(c >= 'a' ? c - 'a' + 'A' : c) : other ? c : '_';
  }
  if (name.empty()) name = "_";
  std::string unlike = name;
  for (int i = 2; !taken.insert(unlike).second; ++i) {
    const std::string end = "_" + std::to_string(i);
    unlike = name.substr(0, std::min(name.size(), kLongestName - end.size())) + end;
  }
  return unlike;
}

std::string place(const Eigen::Vector3d& metres) {
  constexpr double kPerMillimetre = 1e3;
  std::string text;
  for (int k = 0; k < 3; ++k) text += group(10 * (k + 1), numberText(kPerMillimetre * metres[k]));
  return text;
}

/// What release 12 calls a 3D polyline: open, its vertices in space.
std::string polyline(const std::vector<CablePoint>& points, const std::string& layer) {
  std::string text = group(0, "POLYLINE") + group(8, layer) + group(66, "1") +
                     place(Eigen::Vector3d::Zero()) + group(70, "8");
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0 && points[i].arc_length == points[i - 1].arc_length) continue;
    text += group(0, "VERTEX") + group(8, layer) + place(points[i].pose.position) + group(70, "32");
  }
  return text + group(0, "SEQEND") + group(8, layer);
}

}  // namespace

std::string shapeDxf(const SolvedScene& solved, const std::vector<std::size_t>& cables, double step) {
  std::set<std::string> taken;
  std::string layers, entities;
  for (const std::size_t cable : cables) {
    const std::string layer = layerName(solved.harness.cables[cable].name, taken);
    layers += group(0, "LAYER") + group(2, layer) + group(70, "0") + group(62, "7") + group(6, "CONTINUOUS");
    entities += polyline(cablePoints(solved, cable, step), layer);
  }
  return group(0, "SECTION") + group(2, "HEADER") + group(9, "$ACADVER") + group(1, "AC1009") +
         group(0, "ENDSEC") + group(0, "SECTION") + group(2, "TABLES") + group(0, "TABLE") +
         group(2, "LAYER") + group(70, std::to_string(cables.size())) + layers + group(0, "ENDTAB") +
         group(0, "ENDSEC") + group(0, "SECTION") + group(2, "ENTITIES") + entities + group(0, "ENDSEC") +
         group(0, "EOF");
}

}  // namespace cable_variation
