#pragma once

#include <array>
#include <cstddef>

#include <cable_variation/scene/measure.h>
#include <cable_variation/util/enum_rows.h>
#include <cable_variation/util/quantity.h>

namespace cable_variation {

/// What all measures of a type have in common. How each is read from a scene file stands in a table of
/// scene_file/measure_reader.cpp, how each is evaluated in measures/measure_functions.cpp: a new type is an
/// enumerator and a row of each, and does not compile without.
struct MeasureTraits {
  /// What it is of.
  enum class Subject {
    cables,   ///< Measure::cables, the value is that of the worst
    cable,    ///< the first of them, at a place or over a stretch of it
    clip,     ///< Measure::clip
    harness,  ///< all of it
  };
  /// Which of two values is worse where there are no limits: over several cables and sections, and over a
  /// motion.
  enum class Worse {
    smaller,
    larger,                ///< in magnitude
    further_from_nominal,  ///< from the design's value at the start of a motion
  };
  /// A limit without a unit that is implausible, of which the reader warns.
  enum class UnlikelyLimit {
    none,
    longer_than_cables,  ///< in mm?
    from_one,            ///< 1 or more: in %?
    below_a_kilopascal,  ///< in MPa?
  };

  Measure::Type type;
  const char* name;          ///< as in a scene file
  const Quantity* quantity;  ///< its dimension and SI unit
  Subject subject;
  Worse worse;
  UnlikelyLimit unlikely;
  bool clearance = false;     ///< room between bodies: negative is an overlap
  bool from_nominal = false;  ///< distance of shapes: needs the nominal one, is 0 there and one-sided
  bool eigenvalue = false;    ///< needs EquilibriumOptions::eigenvalue; its derivatives are the solver's
};

/// One row per type, in their order.
using MeasureTraitsTable = std::array<MeasureTraits, enumeratorCount<Measure::Type>()>;
const MeasureTraitsTable& measureTraits();

/// The row of a type. Throws std::out_of_range for a number that is none.
const MeasureTraits& traitsOf(Measure::Type type);

}  // namespace cable_variation
