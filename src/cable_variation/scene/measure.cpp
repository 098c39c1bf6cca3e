#include <cable_variation/scene/measure.h>

namespace cable_variation {

bool withinLimits(const Measure& measure, double value) {
  return (!measure.lower || value >= *measure.lower) && (!measure.upper || value <= *measure.upper);
}

bool beyondLimits(const Measure& measure, double value) {
  return (measure.lower && value < *measure.lower) || (measure.upper && value > *measure.upper);
}

}  // namespace cable_variation
