#include <cable_variation/measures/cable_view.h>

#include <algorithm>
#include <stdexcept>

namespace cable_variation {

CableView::CableView(const Cable& cable, const CableShape& shape) : cable_(&cable), shape_(&shape) {
  const RodProfile profile(cable);
  const auto& points = shape.points;
  pieces_.reserve(points.size());
  line_.pieces.reserve(points.size());
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double start = points[i].arc_length, length = points[i + 1].arc_length - start;
    if (!(length > 0.0)) continue;
    constexpr double kInside = 1e-9;  // of the length: the piece's side of a step
    pieces_.push_back(
        {i, length, profile.at(start + kInside * length), profile.at(start + (1.0 - kInside) * length)});
    line_.pieces.push_back({curveBetween(points[i], points[i + 1]), start, points[i + 1].arc_length,
                            pieces_.back().start.radius, pieces_.back().end.radius});
  }
  if (pieces_.empty()) throw std::invalid_argument("cable '" + cable.name + "' has no solved shape");
}

Place CableView::at(double arc_length) const {
  const auto after =
      std::upper_bound(line_.pieces.begin(), line_.pieces.end(), arc_length,
                       [](double s, const Centreline::Piece& piece) { return s < piece.start; });
  const std::size_t index =
      after == line_.pieces.begin() ? 0 : static_cast<std::size_t>(after - line_.pieces.begin()) - 1;
  const Centreline::Piece& piece = line_.pieces[index];
  return {index, std::clamp((arc_length - piece.start) / (piece.end - piece.start), 0.0, 1.0)};
}

bool CableView::isEnd(const Place& place) const {
  return (place.piece == 0 && place.t <= 0.0) || (place.piece + 1 == pieces_.size() && place.t >= 1.0);
}

CurvePiece CableView::curveRate(std::size_t piece, const CableRates& rates) const {
  const ShapePoint &a = start(piece), &b = end(piece);
  const ShapePointRate &da = start(piece, rates), &db = end(piece, rates);
  const double length = pieces_[piece].length;
  const double stretch = (db.arc_length - da.arc_length) / length;
  return {{da.position, da.tangent + stretch * a.tangent,
           da.second_derivative + 2.0 * stretch * a.second_derivative},
          {db.position, db.tangent + stretch * b.tangent,
           db.second_derivative + 2.0 * stretch * b.second_derivative},
          length};
}

PlaceRate CableView::rate(const Place& place, const CableRates& rates) const {
  PlaceRate rate;
  rate.position = curveRate(place.piece, rates).position(place.t);
  rate.arc_length = arcLengthRate(place, rates);
  const Centreline::Piece& piece = line_.pieces[place.piece];
  const double slope = (piece.end_radius - piece.start_radius) / pieces_[place.piece].length;
  rate.radius = rates.cable.radius * line_.radius(place) +
                slope * (rate.arc_length - rates.cable.knots * line_.arcLength(place));
  return rate;
}

double CableView::arcLengthRate(const Place& place, const CableRates& rates) const {
  const double a = start(place.piece, rates).arc_length, b = end(place.piece, rates).arc_length;
  return a + place.t * (b - a);
}

double CableView::shareRate(const Place& place, const CableRates& rates, double arc_length_rate) const {
  return (arc_length_rate - arcLengthRate(place, rates)) / pieces_[place.piece].length;
}

std::vector<CableView> viewsOf(const Harness& harness, const Equilibrium& equilibrium) {
  std::vector<CableView> views;
  views.reserve(harness.cables.size());
  for (std::size_t i = 0; i < harness.cables.size(); ++i)
    views.emplace_back(harness.cables[i], equilibrium.shapes.at(i));
  return views;
}

Centreline centrelineOf(const Cable& cable, const CableShape& shape) {
  return CableView(cable, shape).line();
}

}  // namespace cable_variation
