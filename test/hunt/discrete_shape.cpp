#include <hunt/discrete_shape.h>

#include <algorithm>

namespace cable_variation::hunt {

DiscreteShape onHalved(const DiscreteLayout& layout, const DiscreteShape& shape) {
  DiscreteShape finer;
  finer.stations = shape.stations;
  for (std::size_t i = 0; i < layout.pieces.size(); ++i) {
    const DiscretePiece& piece = layout.pieces[i];
    DiscreteShape::Piece nodes;
    for (std::size_t k = 0; k < piece.segments(); ++k) {
      const Eigen::Quaterniond& own = shape.pieces[i].segments[k];
      const bool first = k == 0, last = k + 1 == piece.segments();
      const Eigen::Quaterniond before =
          first ? shape.stations[piece.left].orientation : shape.pieces[i].segments[k - 1];
      const Eigen::Quaterniond after =
          last ? shape.stations[piece.right].orientation : shape.pieces[i].segments[k + 1];
      nodes.vertices.push_back(0.5 * (shape.vertex(piece, i, k) + shape.vertex(piece, i, k + 1)));
      if (!last) nodes.vertices.push_back(shape.vertex(piece, i, k + 1));
      // quarter points of the way between middles; half points where the neighbour is a station
      nodes.segments.push_back(own.slerp(first ? 0.5 : 0.25, before));
      nodes.segments.push_back(own.slerp(last ? 0.5 : 0.25, after));
      for (std::size_t half = 2 * k; half < 2 * k + 2; ++half) {
        nodes.force.push_back(nodes.segments[half].conjugate() * (own * shape.pieces[i].force[k]));
      }
    }
    finer.pieces.push_back(std::move(nodes));
  }
  return finer;
}

double largestDistance(const DiscreteShape& a, const DiscreteShape& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.stations.size(); ++i) {
    largest = std::max(largest, (a.stations[i].position - b.stations[i].position).norm());
  }
  for (std::size_t i = 0; i < a.pieces.size(); ++i) {
    for (std::size_t k = 0; k < a.pieces[i].vertices.size(); ++k) {
      largest = std::max(largest, (a.pieces[i].vertices[k] - b.pieces[i].vertices[k]).norm());
    }
  }
  return largest;
}

}  // namespace cable_variation::hunt
