#include <cable_variation/variation/measure_similarity.h>

#include <algorithm>
#include <cmath>

#include <cable_variation/geometry/hausdorff.h>
#include <cable_variation/math/extremum.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;

constexpr double kAccuracy = 1e-9;  // [m] small shifts, of which derivatives are the limits, count too
constexpr double kNominal = 1e-9;   // [m] shapes closer than that are the nominal one: rounding of a re-solve

// How fast a place of the curve, or of the surface around it, leaves the nominal one.
double leavingRate(const CableView& view, const Place& place, const Vector3d& shift, double radius_rate,
                   bool surface) {
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

// The same at an end, or where the tangent has a kink, at a clip whose force jumps. `arms`: unit directions
// in which the curve goes on. The nominal curve is left by the shifted point, or it by the shifted curve.
double leavingRateAtCorner(const std::vector<Vector3d>& arms, const Vector3d& shift, double radius_rate) {
  const auto distanceTo = [&](const Vector3d& point) {
    double smallest = point.norm();
    for (const Vector3d& arm : arms) {
      const double along = point.dot(arm);
      if (along > 0.0) smallest = std::min(smallest, (point - along * arm).norm());
    }
    return smallest;
  };
  return std::max(distanceTo(shift) + radius_rate, distanceTo(-shift) - radius_rate);
}

double limitAtNominal(const MeasureContext& context, const Measure& measure, const MeasureRates& rates) {
  double largest = 0.0;
  for (const std::size_t index : measure.cables) {
    const CableView& view = context.cables[index];
    const CableRates cable = rates.cable(index);
    const std::size_t pieces = view.pieces().size();
    std::vector<CurvePiece> shifts;
    shifts.reserve(pieces);
    for (std::size_t i = 0; i < pieces; ++i) shifts.push_back(view.curveRate(i, cable));
    const auto radiusRate = [&](const Place& place) {
      return measure.surface ? view.rate(place, cable).radius : 0.0;
    };
    const auto leaving = [&](std::size_t piece, double t) {
      const Place place{piece, t};
      return leavingRate(view, place, shifts[piece].position(t), radiusRate(place), measure.surface);
    };
    constexpr double kShare = 1e-4;  // of t: the maximum itself is then right to about 1e-8
    largest = std::max(largest, largestAlong<4>(pieces, leaving, kShare).value);

    for (std::size_t i = 0; i <= pieces; ++i) {
      // two points at one arc length, or an end
      if (i > 0 && i < pieces && view.pieces()[i - 1].point + 1 == view.pieces()[i].point) continue;
      // where the radius steps, the thicker part's surface ends as at an end
      const double before = i > 0 ? view.line().pieces[i - 1].end_radius : 0.0;
      const double after = i < pieces ? view.line().pieces[i].start_radius : 0.0;
      const bool step = measure.surface && i > 0 && i < pieces && before != after;
      std::vector<Vector3d> arms;
      if (i > 0 && !(step && before < after)) arms.push_back(-view.end(i - 1).tangent.normalized());
      if (i < pieces && !(step && after < before)) arms.push_back(view.start(i).tangent.normalized());
      const Place place = i == pieces || (step && after < before) ? Place{i - 1, 1.0} : Place{i, 0.0};
      const Vector3d shift = shifts[place.piece].position(place.t);
      largest = std::max(largest, leavingRateAtCorner(arms, shift, radiusRate(place)));
    }
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
    const Hausdorff found = measure.surface ? surfaceHausdorff(line, nominal.at(cable), kAccuracy)
                                            : curveHausdorff(line, nominal.at(cable), kAccuracy);
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
    if (!found.unique) markAsShared(largest, "as far from two places of the other shape");
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
