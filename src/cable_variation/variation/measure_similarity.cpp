#include <cable_variation/variation/measure_similarity.h>

#include <cmath>

#include <cable_variation/geometry/hausdorff.h>
#include <cable_variation/math/extremum.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;

constexpr double kNominal = 1e-9;  // [m] shapes closer than that are the nominal one: rounding of a re-solve

// How fast a place of the curve, or of the surface around it, leaves the nominal one.
double leavingRate(const CableView& view, const Place& place, const Vector3d& shift, double radius_rate,
                   bool surface) {
  if (view.isEnd(place)) return shift.norm() + (surface ? std::abs(radius_rate) : 0.0);
  const Centreline::Piece& piece = view.line().pieces[place.piece];
  const Vector3d first = piece.curve.first(place.t);
  const double speed = first.norm();
  const double along = shift.dot(first) / speed;
  const double across = (shift - along / speed * first).norm();
  if (!surface) return across;
  // normals of a surface whose radius changes along the curve lean by that slope
  const double lean = (piece.end_radius - piece.start_radius) / speed;
  return std::sqrt(std::max(0.0, 1.0 - lean * lean)) * across + std::abs(radius_rate - lean * along);
}

double limitAtNominal(const MeasureContext& context, const Measure& measure, const MeasureRates& rates) {
  double largest = 0.0;
  for (const std::size_t index : measure.cables) {
    const CableView& view = context.cables[index];
    const CableRates cable = rates.cable(index);
    std::vector<CurvePiece> shifts;
    shifts.reserve(view.pieces().size());
    for (std::size_t i = 0; i < view.pieces().size(); ++i) shifts.push_back(view.curveRate(i, cable));
    const auto leaving = [&](std::size_t piece, double t) {
      const Place place{piece, t};
      const double radius = measure.surface ? view.rate(place, cable).radius : 0.0;
      return leavingRate(view, place, shifts[piece].position(t), radius, measure.surface);
    };
    constexpr double kAccuracy = 1e-4;  // of t: the maximum itself is then right to about 1e-8
    largest = std::max(largest, largestAlong<4>(view.pieces().size(), leaving, kAccuracy).value);
  }
  return largest;
}

}  // namespace

MeasureValue similarityValue(const MeasureContext& context, const Measure& measure,
                             const std::vector<Centreline>& nominal) {
  MeasureValue largest;
  largest.value = -1.0;
  for (const std::size_t cable : measure.cables) {
    const Centreline& line = context.cables[cable].line();
    const Hausdorff found =
        measure.surface ? surfaceHausdorff(line, nominal.at(cable)) : curveHausdorff(line, nominal.at(cable));
    if (found.distance <= largest.value) continue;
    const Place& place = found.on_first ? found.place : found.nearest;
    const Place& other = found.on_first ? found.nearest : found.place;
    largest = measureAt(context, cable, place, found.distance);
    largest.trace.other_place = other;
    largest.trace.from_nominal = !found.on_first;
    const Vector3d away = line.position(place) - nominal[cable].position(other);
    if (away.norm() > 0.0) largest.trace.direction = away.normalized();
    // the points of the surfaces that are furthest apart, on the side of the one that sticks out
    const Vector3d outward = found.on_first ? largest.trace.direction : Vector3d(-largest.trace.direction);
    largest.point += line.radius(place) * outward;
    largest.has_other = true;
    largest.other = nominal[cable].position(other) + nominal[cable].radius(other) * outward;
  }
  return largest;
}

double similarityRate(const MeasureContext& context, const Measure& measure, const MeasureValue& value,
                      const MeasureRates& rates) {
  if (value.value <= kNominal) return limitAtNominal(context, measure, rates);
  const PlaceRate at = context.cables[value.cable].rate(value.trace.place, rates.cable(value.cable));
  const double radius = measure.surface ? (value.trace.from_nominal ? -at.radius : at.radius) : 0.0;
  return value.trace.direction.dot(at.position) + radius;
}

}  // namespace cable_variation
