#include <cable_variation/measures/measure_route.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <cable_variation/measures/curve_difference.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;

/// A stretch of a cable between two arc lengths.
class Stretch {
 public:
  Stretch(const MeasureContext& context, const Measure& measure)
      : view_(context.cables[measure.cables.front()]),
        from_(context, measure.cables.front(), measure.from),
        to_(context, measure.cables.front(), measure.to) {
    // a place between two pieces is the one's end, and the other's start
    start_ = from_.place;
    if (start_.t >= 1.0 && start_.piece + 1 < view_.pieces().size()) start_ = {start_.piece + 1, 0.0};
    end_ = to_.place;
    if (end_.t <= 0.0 && end_.piece > start_.piece) end_ = {end_.piece - 1, 1.0};
  }

  Centreline line() const {
    Centreline line;
    for (std::size_t i = start_.piece; i <= end_.piece; ++i) {
      const auto [first, last] = shares(i);
      const Centreline::Piece& whole = view_.line().pieces[i];
      const double length = whole.end - whole.start;
      const auto end = [&](double t) {
        return CurvePiece::End{whole.curve.position(t), whole.curve.first(t) / length,
                               whole.curve.second(t) / (length * length)};
      };
      line.pieces.push_back({CurvePiece(end(first), end(last), (last - first) * length),
                             whole.start + first * length, whole.start + last * length, 0.0, 0.0});
    }
    return line;
  }

  /// A place of line() on the cable.
  Place onCable(const Place& place) const {
    const auto [first, last] = shares(start_.piece + place.piece);
    return {start_.piece + place.piece, first + place.t * (last - first)};
  }

  /// How the position changes at a place that is furthest or nearest: at the stretch's ends with the
  /// material, in between it does not matter how the place moves along.
  Vector3d shift(const Place& place, const CableRates& rates) const {
    if (same(place, start_)) return shiftOf(from_, start_, rates);
    if (same(place, end_)) return shiftOf(to_, end_, rates);
    return view_.curveRate(place.piece, rates).position(place.t);
  }

  double leaving(const CableRates& rates) const {
    return leavingRate(view_, rates, start_, end_, shiftOf(from_, start_, rates), shiftOf(to_, end_, rates),
                       0.0);
  }

 private:
  std::pair<double, double> shares(std::size_t piece) const {
    return {piece == start_.piece ? start_.t : 0.0, piece == end_.piece ? end_.t : 1.0};
  }

  static bool same(const Place& a, const Place& b) {
    constexpr double kRounding = 1e-12;
    return a.piece == b.piece && std::abs(a.t - b.t) < kRounding;
  }

  Vector3d shiftOf(const NamedPlace& named, const Place& place, const CableRates& rates) const {
    const Vector3d along = view_.line().pieces[place.piece].curve.first(place.t);
    const double share = named.at_end ? 0.0 : view_.shareRate(place, rates, 0.0);
    return view_.curveRate(place.piece, rates).position(place.t) + share * along;
  }

  const CableView& view_;
  NamedPlace from_, to_;
  Place start_, end_;
};

Centreline routeOf(const Measure& measure) {
  Centreline line;
  double reached = 0.0;
  for (std::size_t i = 0; i + 1 < measure.route.size(); ++i) {
    const Vector3d way = measure.route[i + 1] - measure.route[i];
    const double length = way.norm();
    const Vector3d along = way / length, straight = Vector3d::Zero();
    line.pieces.push_back(
        {CurvePiece({measure.route[i], along, straight}, {measure.route[i + 1], along, straight}, length),
         reached, reached + length, 0.0, 0.0});
    reached += length;
  }
  return line;
}

}  // namespace

MeasureValue routeDeviationValue(const MeasureContext& context, const Measure& measure) {
  const Stretch stretch(context, measure);
  const Centreline line = stretch.line(), route = routeOf(measure);
  const Hausdorff found = foundBy(curveHausdorff, line, route);
  const Place& on_line = found.on_first ? found.place : found.nearest;
  const Place& on_route = found.on_first ? found.nearest : found.place;
  MeasureValue value = measureAt(context, measure.cables.front(), stretch.onCable(on_line), found.distance);
  value.has_other = true;
  value.other = route.position(on_route);
  value.trace.other_place = on_route;
  value.trace.from_nominal = !found.on_first;
  const Vector3d away = value.point - value.other;
  if (away.norm() > 0.0) value.trace.direction = away.normalized();
  if (!found.unique) markAsShared(value, "as far from two places of the other curve");
  if (found.distance <= kSameShape) markAsShared(value, "on its route: any change leaves it");
  return value;
}

RateOfMeasure routeDeviationRate(const MeasureContext& context, const Measure& measure,
                                 const MeasureValue& value) {
  return [&value, stretch = Stretch(context, measure)](const MeasureRates& rates) {
    const CableRates cable = rates.cable(value.cable);
    if (value.value <= kSameShape) return stretch.leaving(cable);
    return value.trace.direction.dot(stretch.shift(value.trace.place, cable));
  };
}

}  // namespace cable_variation
