#include <cable_variation/geometry/body/placed_body.h>

#include <algorithm>
#include <cmath>

#include <cable_variation/math/linear_program.h>

namespace cable_variation {

using Eigen::Vector3d;

namespace {

Eigen::Array<double, 1, Eigen::Dynamic> heights(const ConvexHull::Planes& planes, const Vector3d& point) {
  return point.x() * planes.row(0).array() + point.y() * planes.row(1).array() +
         point.z() * planes.row(2).array() - planes.row(3).array();
}

}  // namespace

Vector3d centreOf(const ConvexHull& core) {
  Vector3d sum = Vector3d::Zero();
  for (const Vector3d& vertex : core.surface().vertices) sum += vertex;
  return sum / static_cast<double>(core.surface().vertices.size());
}

PlacedBody::PlacedBody(const RoundedHull& body, const Pose& pose)
    : core_(body.core.surface()),
      planes_(body.core.planes()),
      radius_(body.radius),
      centre_(pose * centreOf(body.core)) {
  const Eigen::Matrix3d turn = pose.orientation.toRotationMatrix();
  for (Vector3d& vertex : core_.vertices) {
    vertex = pose.position + turn * vertex;
    box_.add(vertex);
    reach_ = std::max(reach_, (vertex - centre_).norm());
  }
  planes_.topRows<3>() = turn * planes_.topRows<3>();
  planes_.row(3) += pose.position.transpose() * planes_.topRows<3>();
}

PlacedBody::Height PlacedBody::height(const Vector3d& point) const {
  Eigen::Index facet;
  const double highest = heights(planes_, point).maxCoeff(&facet);
  return {highest, point, static_cast<std::size_t>(facet)};
}

double PlacedBody::lowestPossible(const Box& box) const {
  const Eigen::Array3d half = 0.5 * (box.high - box.low);
  return (heights(planes_, (0.5 * (box.low + box.high)).matrix()) - half.x() * planes_.row(0).array().abs() -
          half.y() * planes_.row(1).array().abs() - half.z() * planes_.row(2).array().abs())
      .maxCoeff();
}

double PlacedBody::lowestPossible(const SurfaceTriangle& triangle) const {
  return heights(planes_, triangle.corners[0])
      .min(heights(planes_, triangle.corners[1]))
      .min(heights(planes_, triangle.corners[2]))
      .maxCoeff();
}

PlacedBody::Height PlacedBody::lowest(const SurfaceTriangle& triangle) const {
  // unknowns: shares u and v of two edges, and the height in sizes of the core
  const Vector3d &corner = triangle.corners[0], u = triangle.corners[1] - corner,
                 v = triangle.corners[2] - corner;
  const Eigen::Index facets = planes_.cols();
  HalfSpaces<3> rows(4, facets + 3);
  rows.row(0).head(facets) = u.transpose() * planes_.topRows<3>() / reach_;
  rows.row(1).head(facets) = v.transpose() * planes_.topRows<3>() / reach_;
  rows.row(2).head(facets).setConstant(-1.0);
  rows.row(3).head(facets) = -heights(planes_, corner) / reach_;
  rows.rightCols<3>() << -1.0, 0.0, 1.0, 0.0, -1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0;
  const double box = 2.0 + ((corner - centre_).norm() + u.norm() + v.norm()) / reach_;
  const Vector3d found = linearProgram<3>(Vector3d::UnitZ(), rows, box);
  double along_u = std::clamp(found.x(), 0.0, 1.0), along_v = std::clamp(found.y(), 0.0, 1.0);
  const double sum = std::max(1.0, along_u + along_v);
  along_u /= sum;
  along_v /= sum;
  return height(corner + along_u * u + along_v * v);
}

PlacedBody::Height PlacedBody::lowest(const PlacedBody& other) const {
  // unknowns: the place, from the other's centre, and the height, both in sizes of the larger core
  const double size = std::max(reach_, other.reach_);
  const Eigen::Index facets = planes_.cols(), others = other.planes_.cols();
  HalfSpaces<4> rows(5, facets + others);
  rows.topLeftCorner(3, facets) = planes_.topRows<3>();
  rows.row(3).head(facets).setConstant(-1.0);
  rows.row(4).head(facets) = -heights(planes_, other.centre_) / size;
  rows.topRightCorner(3, others) = other.planes_.topRows<3>();
  rows.row(3).tail(others).setZero();
  rows.row(4).tail(others) = -heights(other.planes_, other.centre_) / size;
  const double box = 2.0 + 2.0 * (centre_ - other.centre_).norm() / size;
  const Eigen::Vector4d found = linearProgram<4>(Eigen::Vector4d::UnitW(), rows, box);
  return height(other.centre_ + size * found.head<3>());
}

const TriangleTree& PlacedBody::facets() const {
  std::call_once(made_, [&] { facets_.emplace(core_); });
  return *facets_;
}

}  // namespace cable_variation
