#include <cable_variation/measures/measure_similarity.h>

#include <algorithm>
#include <cmath>

#include <cable_variation/geometry/tube_distance/hausdorff.h>
#include <cable_variation/measures/curve_difference.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;

constexpr double kFinest = 1e-9;  // [m]

double limitOfCurve(const CableView& view, const CableRates& rates, bool surface) {
  const std::size_t last = view.pieces().size() - 1;
  const double radius = surface ? view.rate({0, 0.0}, rates).radius : 0.0;  // the same all along
  return leavingRate(view, rates, {0, 0.0}, {last, 1.0}, view.start(0, rates).position,
                     view.end(last, rates).position, radius);
}

bool hasOneRadius(const Centreline& line) {
  const double radius = line.pieces.front().start_radius;
  return std::all_of(line.pieces.begin(), line.pieces.end(), [&](const Centreline::Piece& piece) {
    return piece.start_radius == radius && piece.end_radius == radius;
  });
}

// The centreline after a small step of the variable, to first order.
Centreline shifted(const CableView& view, const CableRates& rates, double step) {
  Centreline line;
  const auto curveEnd = [&](const ShapePoint& point, const ShapePointRate& rate) {
    return CurvePiece::End{point.pose.position + step * rate.position, point.tangent + step * rate.tangent,
                           point.second_derivative + step * rate.second_derivative};
  };
  for (std::size_t i = 0; i < view.pieces().size(); ++i) {
    const PlaceRate start = view.rate({i, 0.0}, rates), end = view.rate({i, 1.0}, rates);
    const Centreline::Piece& piece = view.line().pieces[i];
    const double from = piece.start + step * start.arc_length, to = piece.end + step * end.arc_length;
    line.pieces.push_back({CurvePiece(curveEnd(view.start(i), view.start(i, rates)),
                                      curveEnd(view.end(i), view.end(i, rates)), to - from),
                           from, to, piece.start_radius + step * start.radius,
                           piece.end_radius + step * end.radius});
  }
  return line;
}

// Of surfaces whose radius changes along the cable, the limit as the quotient for two small steps,
// extrapolated to none.
double limitOfSurface(const CableView& view, const CableRates& rates) {
  double fastest = 0.0;
  for (std::size_t i = 0; i < view.pieces().size(); ++i) {
    for (const double t : {0.0, 1.0}) {
      const PlaceRate rate = view.rate({i, t}, rates);
      fastest = std::max({fastest, rate.position.norm(), std::abs(rate.radius)});
    }
  }
  if (!(fastest > 0.0)) return 0.0;
  constexpr double kShift = 2e-5;  // [m] far above the accuracy of the distance, far below any bend
  const auto quotient = [&](double step) {
    return surfaceHausdorff(view.line(), shifted(view, rates, step), kFinest).distance / step;
  };
  const double step = kShift / fastest;
  return 2.0 * quotient(0.5 * step) - quotient(step);
}

double limitAtNominal(const MeasureContext& context, const Measure& measure, const MeasureRates& rates) {
  double largest = 0.0;
  for (const std::size_t index : measure.cables) {
    const CableView& view = context.cables[index];
    const CableRates cable = rates.cable(index);
    largest = std::max(largest, measure.surface && !hasOneRadius(view.line())
                                    ? limitOfSurface(view, cable)
                                    : limitOfCurve(view, cable, measure.surface));
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
        foundBy(measure.surface ? surfaceHausdorff : curveHausdorff, line, nominal.at(cable));
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

RateOfMeasure similarityRate(const MeasureContext& context, const Measure& measure,
                             const MeasureValue& value) {
  if (value.value <= kSameShape)
    return [&](const MeasureRates& rates) { return limitAtNominal(context, measure, rates); };
  return [&](const MeasureRates& rates) {
    const PlaceRate at = context.cables[value.cable].rate(value.trace.place, rates.cable(value.cable));
    const double radius = measure.surface ? (value.trace.from_nominal ? -at.radius : at.radius) : 0.0;
    return value.trace.direction.dot(at.position) + radius;
  };
}

}  // namespace cable_variation
