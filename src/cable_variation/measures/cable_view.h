#pragma once

#include <vector>

#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/equilibrium/sensitivity.h>
#include <cable_variation/geometry/tube_distance/centreline.h>
#include <cable_variation/rod/profile.h>

namespace cable_variation {

using Place = Centreline::Place;

/// How one cable changes with a variable: its points, and what it is made of.
struct CableRates {
  const std::vector<ShapePointRate>& points;
  const CableRate& cable;
};

/// First-order change at a place that keeps its share of its piece.
struct PlaceRate {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< [m]
  double arc_length = 0.0;                             ///< [m]
  double radius = 0.0;                                 ///< [m]
};

/// A solved cable as its measures look at it: the pieces between neighbouring
/// points (the two points at a clip or joint have none between them), what the rod
/// is at their ends, and the centreline made of them.
class CableView {
 public:
  /// Both must outlive the view. Throws std::invalid_argument for a shape of fewer than two points.
  CableView(const Cable& cable, const CableShape& shape);

  struct Piece {
    std::size_t point;  ///< index of the first of the piece's two points
    double length;      ///< [m]
    /// Properties at both ends, on the piece's side of a step.
    RodProperties start, end;
  };
  const std::vector<Piece>& pieces() const { return pieces_; }
  const Centreline& line() const { return line_; }
  const Cable& cable() const { return *cable_; }
  const ShapePoint& start(std::size_t piece) const { return shape_->points[pieces_[piece].point]; }
  const ShapePoint& end(std::size_t piece) const { return shape_->points[pieces_[piece].point + 1]; }
  const ShapePointRate& start(std::size_t piece, const CableRates& rates) const {
    return rates.points[pieces_[piece].point];
  }
  const ShapePointRate& end(std::size_t piece, const CableRates& rates) const {
    return rates.points[pieces_[piece].point + 1];
  }

  /// Where an arc length is [m, clamped]; at a clip or joint, the side s+ counts.
  Place at(double arc_length) const;
  double arcLength(const Place& place) const { return line_.arcLength(place); }
  bool isEnd(const Place& place) const;  ///< of the cable

  /// Of the curve of a piece: a curve itself, over the same t.
  CurvePiece curveRate(std::size_t piece, const CableRates& rates) const;
  PlaceRate rate(const Place& place, const CableRates& rates) const;
  double arcLengthRate(const Place& place, const CableRates& rates) const;
  /// How t changes at a place whose arc length changes by `arc_length_rate` instead.
  double shareRate(const Place& place, const CableRates& rates, double arc_length_rate) const;

 private:
  const Cable* cable_;
  const CableShape* shape_;
  std::vector<Piece> pieces_;
  Centreline line_;
};

/// Of all cables of a solved harness; both must outlive them.
std::vector<CableView> viewsOf(const Harness& harness, const Equilibrium& equilibrium);

/// The centreline of a shape; for a cable that must be kept, without its view.
Centreline centrelineOf(const Cable& cable, const CableShape& shape);

}  // namespace cable_variation
