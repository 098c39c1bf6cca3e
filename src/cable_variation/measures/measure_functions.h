#pragma once  // internal to measures/

#include <cable_variation/geometry/tube_distance/part_vicinity.h>
#include <cable_variation/measures/measure_context.h>

namespace cable_variation {

/// What an evaluator keeps ready for a measure; more than most look at.
struct MeasureAids {
  const std::vector<Centreline>& nominal;   ///< per cable, of the shape that others are compared with
  const std::vector<MeasuredBody>& bodies;  ///< of Measure::component
  const MeasureValue* near;                 ///< of a similar shape, or null
  const std::vector<PartVicinity>& part_vicinities;  ///< per body and cable of the measure, or none
};

/// How measures of a type are evaluated: see the headers measure_*.h of this room, a family each.
struct MeasureFunctions {
  Measure::Type type;
  MeasureValue (*value)(const MeasureContext&, const Measure&, const MeasureAids&);
  /// Zero for a type whose derivatives are the solver's (MeasureTraits::eigenvalue).
  RateOfMeasure (*rate)(const MeasureContext&, const Measure&, const MeasureValue&);
};

/// Those of a type, one row for each.
const MeasureFunctions& functionsOf(Measure::Type type);

}  // namespace cable_variation
