#pragma once

#include <vector>

#include <hunt/discrete_layout.h>

namespace cable_variation::hunt {

/// What the unknowns of the discrete rod move.
struct DiscreteShape {
  struct Station {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();  ///< from a clip, along its axes [m]
    Eigen::Vector3d theta = Eigen::Vector3d::Zero();  ///< rotation vector in a clip's frame, of length ≤ π
    double hinge = 0.0;                               ///< of a hinge joint's child [rad]
    double arc_length = 0.0;                          ///< [m]
  };
  struct Piece {
    std::vector<Eigen::Vector3d> vertices;     ///< between the piece's ends
    std::vector<Eigen::Quaterniond> segments;  ///< frames of the segments
    std::vector<Eigen::Vector3d> force;  ///< section force in each, segment frame: what Newton starts from
  };
  std::vector<Station> stations;
  std::vector<Piece> pieces;

  Eigen::Vector3d vertex(const DiscretePiece& piece, std::size_t index, std::size_t k) const {
    if (k == 0) return stations[piece.left].position;
    return k == piece.segments() ? stations[piece.right].position : pieces[index].vertices[k - 1];
  }
};

/// The same shape on halved(layout): vertices between by the mean, frames by the neighbours'.
DiscreteShape onHalved(const DiscreteLayout& layout, const DiscreteShape& shape);

/// Largest distance between vertices of the same index [m].
double largestDistance(const DiscreteShape& a, const DiscreteShape& b);

}  // namespace cable_variation::hunt
