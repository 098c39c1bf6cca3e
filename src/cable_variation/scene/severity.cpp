#include <cable_variation/scene/severity.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <cable_variation/scene/measure_traits.h>

namespace cable_variation {

double severity(const Measure& measure, double nominal, double value) {
  if (measure.lower || measure.upper) {
    double beyond = -std::numeric_limits<double>::infinity();
    if (measure.lower) beyond = std::max(beyond, *measure.lower - value);
    if (measure.upper) beyond = std::max(beyond, value - *measure.upper);
    return beyond;
  }
  switch (traitsOf(measure.type).worse) {
    case MeasureTraits::Worse::smaller:
      return -value;
    case MeasureTraits::Worse::further_from_nominal:
      return std::abs(value - nominal);
    case MeasureTraits::Worse::larger:
      break;
  }
  return std::abs(value);
}

bool isWorse(const Measure& measure, double nominal, double value, double than) {
  const double bad = severity(measure, nominal, value);
  return bad > severity(measure, nominal, than) || (std::isnan(than) && !std::isnan(value));
}

}  // namespace cable_variation
