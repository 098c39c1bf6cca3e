#include <cable_variation/report/csv.h>
#include <cable_variation/report/shape_file/cable_points.h>
#include <cable_variation/report/shape_file/shape_file.h>

namespace cable_variation {

namespace {

std::string columns(const Eigen::Vector3d& vector) {
  return "," + csv::number(vector.x()) + "," + csv::number(vector.y()) + "," + csv::number(vector.z());
}

}  // namespace

std::string shapeCsv(const SolvedScene& solved, const std::vector<std::size_t>& cables, double step) {
  std::string table =
      "cable,arc length [m],x [m],y [m],z [m],qw,qx,qy,qz,Fx [N],Fy [N],Fz [N],Mx [N m],My [N m],Mz [N m],"
      "curvature [1/m],radius [m]\r\n";
  for (const std::size_t cable : cables) {
    const std::string name = csv::text(solved.harness.cables[cable].name);
    for (const CablePoint& point : cablePoints(solved, cable, step)) {
      const Eigen::Quaterniond& turned = point.pose.orientation;
      table += name + "," + csv::number(point.arc_length) + columns(point.pose.position) + "," +
               csv::number(turned.w()) + columns(turned.vec()) + columns(point.force) +
               columns(point.moment) + "," + csv::number(point.curvature) + "," + csv::number(point.radius) +
               "\r\n";
    }
  }
  return table;
}

}  // namespace cable_variation
