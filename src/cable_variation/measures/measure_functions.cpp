#include <cable_variation/measures/measure_functions.h>

#include <array>
#include <limits>

#include <cable_variation/measures/measure_clip.h>
#include <cable_variation/measures/measure_contact.h>
#include <cable_variation/measures/measure_distance.h>
#include <cable_variation/measures/measure_route.h>
#include <cable_variation/measures/measure_shape.h>
#include <cable_variation/measures/measure_similarity.h>
#include <cable_variation/measures/measure_strength.h>
#include <cable_variation/util/enum_rows.h>

namespace cable_variation {
namespace {

using Type = Measure::Type;
using Context = const MeasureContext&;
using Of = const Measure&;
using Aids = const MeasureAids&;
using At = const MeasureValue&;
using Rates = const MeasureRates&;

// The functions of a family by the one signature: without what they do not look at.
template <MeasureValue (*value)(Context, Of)>
MeasureValue plainValue(Context context, Of measure, Aids) {
  return value(context, measure);
}

template <double (*rate)(Context, Of, At, Rates)>
RateOfMeasure plainRate(Context context, Of measure, At value) {
  return [&](Rates rates) { return rate(context, measure, value, rates); };
}

MeasureValue distanceValue(Context context, Of measure, Aids aids) {
  if (!measure.component) return cableDistanceValue(context, measure);
  return componentDistanceValue(context, measure, aids.bodies, aids.near, aids.part_vicinities);
}

RateOfMeasure distanceRate(Context context, Of measure, At value) {
  return measure.component ? plainRate<componentDistanceRate>(context, measure, value)
                           : plainRate<cableDistanceRate>(context, measure, value);
}

MeasureValue similarityTo(Context context, Of measure, Aids aids) {
  return similarityValue(context, measure, aids.nominal);
}

RateOfMeasure rateOfBendRadius(Context context, Of, At value) {
  return [&](Rates rates) { return bendRadiusRate(context, value, rates); };
}

RateOfMeasure rateOfTwist(Context context, Of measure, At) { return twistRate(context, measure); }

RateOfMeasure rateOfClipLoad(Context context, Of measure, At) {
  return [&](Rates rates) { return clipLoadRate(context, measure, rates); };
}

RateOfMeasure rateOfSlide(Context, Of measure, At) {
  return [&](Rates rates) { return slideRate(measure, rates); };
}

// A figure of the whole harness: it has no place.
template <double (*figure)(const Equilibrium&)>
MeasureValue figureOf(Context context, Of, Aids) {
  MeasureValue value;
  value.value = figure(context.at.equilibrium);
  return value;
}

double elasticEnergy(const Equilibrium& equilibrium) { return equilibrium.energy.elastic; }
double smallestEigenvalue(const Equilibrium& equilibrium) { return equilibrium.smallest_eigenvalue; }

RateOfMeasure rateOfEnergy(Context, Of, At) {
  return [](Rates rates) { return rates.equilibrium.elastic_energy; };
}

RateOfMeasure leftToTheSolver(Context, Of, At) {
  return [](Rates) { return 0.0; };
}

// Where contact ends is known to the places along the cable that are looked at, which leave it in steps.
RateOfMeasure notKnown(Context, Of, At) {
  return [](Rates) { return std::numeric_limits<double>::quiet_NaN(); };
}

constexpr std::array<MeasureFunctions, enumeratorCount<Type>()> kFunctions{{
    {Type::distance, distanceValue, distanceRate},
    {Type::similarity, similarityTo, similarityRate},
    {Type::position, plainValue<positionValue>, plainRate<positionRate>},
    {Type::bend_radius, plainValue<bendRadiusValue>, rateOfBendRadius},
    {Type::strain, plainValue<strengthValue>, strengthRate},
    {Type::stress, plainValue<strengthValue>, strengthRate},
    {Type::section_force, plainValue<sectionLoadValue>, sectionLoadRate},
    {Type::section_moment, plainValue<sectionLoadValue>, sectionLoadRate},
    {Type::twist, plainValue<twistValue>, rateOfTwist},
    {Type::clip_force, plainValue<clipLoadValue>, rateOfClipLoad},
    {Type::clip_moment, plainValue<clipLoadValue>, rateOfClipLoad},
    {Type::slide, plainValue<slideValue>, rateOfSlide},
    {Type::contact_force, plainValue<contactValue>, plainRate<contactForceRate>},
    {Type::contact_length, plainValue<contactValue>, notKnown},
    {Type::route_deviation, plainValue<routeDeviationValue>, routeDeviationRate},
    {Type::energy, figureOf<elasticEnergy>, rateOfEnergy},
    {Type::eigenvalue, figureOf<smallestEigenvalue>, leftToTheSolver},
}};
static_assert(hasRowOfEach(kFunctions, &MeasureFunctions::type),
              "a type of measure has no row, or is out of order");

}  // namespace

const MeasureFunctions& functionsOf(Measure::Type type) {
  return kFunctions.at(static_cast<std::size_t>(type));
}

}  // namespace cable_variation
