#include <cable_variation/geometry/tube_distance/centreline.h>

namespace cable_variation {

double Centreline::arcLength(const Place& place) const {
  const Piece& piece = pieces[place.piece];
  return piece.start + place.t * (piece.end - piece.start);
}

double Centreline::radius(const Place& place) const {
  const Piece& piece = pieces[place.piece];
  return piece.start_radius + place.t * (piece.end_radius - piece.start_radius);
}

}  // namespace cable_variation
