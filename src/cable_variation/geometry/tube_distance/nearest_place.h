#pragma once

#include <array>
#include <vector>

#include <cable_variation/geometry/tube_distance/centreline.h>

namespace cable_variation {

/// Bézier points of a stretch t0 to t1 of a curve piece: it lies in their hull.
using ControlPoints = std::array<Eigen::Vector3d, 6>;

/// From position, first and second derivative over t at both ends of a stretch of the width `dt`.
struct PieceEnd {
  Eigen::Vector3d position, first, second;

  PieceEnd(const CurvePiece& curve, double t)
      : position(curve.position(t)), first(curve.first(t)), second(curve.second(t)) {}
};
ControlPoints controlPoints(const PieceEnd& start, const PieceEnd& end, double dt);

/// An upper bound of the second derivative over the stretch, in squared widths of it [m].
double secondDerivativeBound(const ControlPoints& points);

/// The place of a curve that is nearest to a point; with radii, the one at which
/// the distance minus the radius is smallest. Made once per curve, asked often.
class NearestPlace {
 public:
  /// Throws std::invalid_argument for a curve without pieces. @param with_radius else radii count as 0
  NearestPlace(const Centreline& curve, bool with_radius);

  struct Found {
    double distance = 0.0;     ///< at `place`, radius subtracted [m]
    double lower_bound = 0.0;  ///< of the smallest one; below `distance` by at most the tolerance [m]
    Centreline::Place place;
  };
  /// Over the whole curve. The bound is exact wherever the point is nearer than the centre of curvature.
  /// @param guess of the place, which makes the search faster
  Found find(const Eigen::Vector3d& point, const Centreline::Place& guess, double tolerance) const;

  /// The place that `from` slides to when it follows the point downhill; a local minimum.
  Centreline::Place slide(const Eigen::Vector3d& point, Centreline::Place from) const;

  const Centreline& curve() const { return curve_; }
  double radius(const Centreline::Place& at) const {
    return pieces_[at.piece].radius + at.t * pieces_[at.piece].radius_slope;
  }
  double radiusSlope(std::size_t piece) const { return pieces_[piece].radius_slope; }  ///< over t [m]
  double distance(const Eigen::Vector3d& point, const Centreline::Place& at) const {
    return (point - curve_.position(at)).norm() - radius(at);
  }

 private:
  struct Piece {
    Eigen::Vector3d centre;           ///< of a sphere that holds the piece
    double reach;                     ///< that sphere's radius, plus the piece's largest radius [m]
    double slowest, fastest, second;  ///< bounds of |∂/∂t| and |∂²/∂t²| [m]
    double radius, radius_slope;      ///< at t = 0, and over t [m]
  };
  void findOn(std::size_t piece, const Eigen::Vector3d& point, double t0, double t1, double tolerance,
              Found& found) const;

  const Centreline& curve_;
  std::vector<Piece> pieces_;
};

}  // namespace cable_variation
