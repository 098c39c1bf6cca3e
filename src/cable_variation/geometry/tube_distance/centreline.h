#pragma once

#include <vector>

#include <cable_variation/math/curve_piece.h>

namespace cable_variation {

/// A tube for distance queries: the curve of a cable, with its radius linear
/// along each piece. Neighbouring pieces share their ends.
struct Centreline {
  struct Piece {
    CurvePiece curve;
    double start = 0.0, end = 0.0;                ///< arc lengths [m]
    double start_radius = 0.0, end_radius = 0.0;  ///< [m]
  };
  std::vector<Piece> pieces;

  /// A place on the centreline.
  struct Place {
    std::size_t piece = 0;
    double t = 0.0;  ///< 0 at the piece's start, 1 at its end
  };
  Eigen::Vector3d position(const Place& place) const { return pieces[place.piece].curve.position(place.t); }
  double arcLength(const Place& place) const;
  double radius(const Place& place) const;
};

}  // namespace cable_variation
