#include <algorithm>
#include <stdexcept>

#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/math/so3.h>

namespace cable_variation {
namespace {

struct Piece {
  const ShapePoint& a;
  const ShapePoint& b;
  double t;  ///< 0 at a, 1 at b
};

Piece pieceAt(const CableShape& shape, double arc_length) {
  const auto& points = shape.points;
  if (points.size() < 2) throw std::invalid_argument("cable '" + shape.cable + "' has no solved shape");
  auto after = std::upper_bound(points.begin(), points.end(), arc_length,
                                [](double s, const ShapePoint& point) { return s < point.arc_length; });
  after = std::clamp(after, points.begin() + 1, points.end() - 1);
  // between the two points of a clip there is no length: take the piece before
  while (after->arc_length <= (after - 1)->arc_length) --after;
  const ShapePoint& a = *(after - 1);
  const ShapePoint& b = *after;
  return {a, b, std::clamp((arc_length - a.arc_length) / (b.arc_length - a.arc_length), 0.0, 1.0)};
}

// Cubic Hermite in the rotation vector from the piece's start.
Eigen::Quaterniond orientation(const Piece& piece) {
  const double h = piece.b.arc_length - piece.a.arc_length;
  const double t = piece.t;
  const double t2 = t * t, t3 = t2 * t;
  const Eigen::Vector3d turn = so3::log(piece.a.pose.orientation.conjugate() * piece.b.pose.orientation);
  const Eigen::Vector3d last = so3::rightJacobian(turn).partialPivLu().solve(piece.b.darboux);
  const Eigen::Vector3d rotation =
      h * (t3 - 2.0 * t2 + t) * piece.a.darboux + (3.0 * t2 - 2.0 * t3) * turn + h * (t3 - t2) * last;
  return (piece.a.pose.orientation * so3::exp(rotation)).normalized();
}

}  // namespace

CurvePiece curveBetween(const ShapePoint& a, const ShapePoint& b) {
  return {{a.pose.position, a.tangent, a.second_derivative},
          {b.pose.position, b.tangent, b.second_derivative},
          b.arc_length - a.arc_length};
}

Eigen::Vector3d CableShape::position(double arc_length) const {
  const Piece piece = pieceAt(*this, arc_length);
  return curveBetween(piece.a, piece.b).position(piece.t);
}

Pose CableShape::pose(double arc_length) const {
  const Piece piece = pieceAt(*this, arc_length);
  return {curveBetween(piece.a, piece.b).position(piece.t), orientation(piece)};
}

std::vector<Pose> CableShape::sample(std::size_t count) const {
  if (count < 2)
    throw std::invalid_argument("cable '" + cable + "': a sample of fewer than 2 poses was asked for");
  std::vector<Pose> poses;
  poses.reserve(count);
  const double first = points.empty() ? 0.0 : points.front().arc_length;
  const double last = points.empty() ? 0.0 : points.back().arc_length;
  for (std::size_t i = 0; i < count; ++i) {
    poses.push_back(pose(first + (last - first) * static_cast<double>(i) / static_cast<double>(count - 1)));
  }
  return poses;
}

}  // namespace cable_variation
