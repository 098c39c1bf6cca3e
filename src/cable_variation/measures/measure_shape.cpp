#include <cable_variation/measures/measure_shape.h>

#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include <cable_variation/measures/largest_over.h>

namespace cable_variation {

using Eigen::Vector3d;

MeasureValue positionValue(const MeasureContext& context, const Measure& measure) {
  const std::size_t cable = measure.cables.front();
  const NamedPlace named(context, cable, measure.arc_length.value_or(0.0));
  const Vector3d position = context.cables[cable].line().position(named.place);
  return measureAt(context, cable, named.place, measure.direction.dot(position));
}

double positionRate(const MeasureContext& context, const Measure& measure, const MeasureValue& value,
                    const MeasureRates& rates) {
  const CableView& view = context.cables[value.cable];
  const CableRates cable = rates.cable(value.cable);
  const NamedPlace named(context, value.cable, measure.arc_length.value_or(0.0));
  const Place& place = named.place;
  const Vector3d along = view.line().pieces[place.piece].curve.first(place.t);
  return measure.direction.dot(view.curveRate(place.piece, cable).position(place.t) +
                               named.shareRate(view, cable) * along);
}

MeasureValue bendRadiusValue(const MeasureContext& context, const Measure& measure) {
  MeasureValue tightest = largestOver(context, measure, [&](std::size_t cable) {
    return [&pieces = context.cables[cable].line().pieces](std::size_t piece, double t) {
      return pieces[piece].curve.curvature(t);
    };
  });
  const double curvature = tightest.value;
  // What bends a straight cable by less than some billionths of its length is rounding, and its radius
  // nothing.
  constexpr double kStraight = 1e-7;
  const double length = context.cables[tightest.cable].cable().length;
  tightest.value = 1.0 / curvature;
  if (!(curvature * length > kStraight)) {
    tightest.value = std::numeric_limits<double>::infinity();
    tightest.note = "straight everywhere";
    tightest.unique = true;
  }
  return tightest;
}

double bendRadiusRate(const MeasureContext& context, const MeasureValue& value, const MeasureRates& rates) {
  if (!std::isfinite(value.value)) return 0.0;
  const CableView& view = context.cables[value.cable];
  const Place& place = value.trace.place;
  const CurvePiece& curve = view.line().pieces[place.piece].curve;
  const CurvePiece rate = view.curveRate(place.piece, rates.cable(value.cable));
  // curvature |c' × c''| / |c'|³
  const Vector3d first = curve.first(place.t), second = curve.second(place.t);
  const Vector3d first_rate = rate.first(place.t), second_rate = rate.second(place.t);
  const Vector3d across = first.cross(second);
  const Vector3d across_rate = first_rate.cross(second) + first.cross(second_rate);
  const double relative =
      across.dot(across_rate) / across.squaredNorm() - 3.0 * first.dot(first_rate) / first.squaredNorm();
  return -relative * value.value;
}

}  // namespace cable_variation
