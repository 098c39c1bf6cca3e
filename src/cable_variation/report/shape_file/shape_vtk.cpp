#include <cable_variation/report/shape_file/cable_points.h>
#include <cable_variation/report/shape_file/shape_file.h>
#include <cable_variation/util/number_text.h>

namespace cable_variation {

namespace {

std::string row(const Eigen::Vector3d& vector) {
  return numberText(vector.x()) + " " + numberText(vector.y()) + " " + numberText(vector.z()) + "\n";
}

/// An array of a field, which readers take all of; of SCALARS and VECTORS many take the first only.
std::string array(const std::string& name, int components, const std::string& count, const char* type) {
  return name + " " + std::to_string(components) + " " + count + " " + type + "\n";
}

}  // namespace

std::string shapeVtk(const SolvedScene& solved, const std::vector<std::size_t>& cables, double step) {
  std::vector<CablePoint> all;
  std::string lines, indices;
  for (const std::size_t cable : cables) {
    const std::vector<CablePoint> points = cablePoints(solved, cable, step);
    lines += std::to_string(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) lines += " " + std::to_string(all.size() + i);
    lines += "\n";
    indices += std::to_string(cable) + "\n";
    all.insert(all.end(), points.begin(), points.end());
  }
  const std::string count = std::to_string(all.size()), cable_count = std::to_string(cables.size());
  std::string file = "# vtk DataFile Version 3.0\ncable shapes, SI units\nASCII\nDATASET POLYDATA\n";
  file += "POINTS " + count + " double\n";
  for (const CablePoint& point : all) file += row(point.pose.position);
  file += "LINES " + cable_count + " " + std::to_string(all.size() + cables.size()) + "\n" + lines;
  file +=
      "CELL_DATA " + cable_count + "\nFIELD FieldData 1\n" + array("cable", 1, cable_count, "int") + indices;
  file += "POINT_DATA " + count + "\nFIELD FieldData 6\n";
  const auto scalar = [&](const char* name, const auto& of) {
    file += array(name, 1, count, "double");
    for (const CablePoint& point : all) file += numberText(of(point)) + "\n";
  };
  scalar("arc_length", [](const CablePoint& point) { return point.arc_length; });
  scalar("radius", [](const CablePoint& point) { return point.radius; });
  scalar("curvature", [](const CablePoint& point) { return point.curvature; });
  scalar("tension", [](const CablePoint& point) {
    return point.force.dot(point.pose.orientation * Eigen::Vector3d::UnitX());
  });
  for (const auto& [name, vector] :
       {std::pair{"force", &CablePoint::force}, {"moment", &CablePoint::moment}}) {
    file += array(name, 3, count, "double");
    for (const CablePoint& point : all) file += row(point.*vector);
  }
  return file;
}

}  // namespace cable_variation
