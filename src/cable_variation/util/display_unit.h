#pragma once

#include <string>

namespace cable_variation {

/// A unit that people read values in.
struct DisplayUnit {
  std::string symbol;   ///< "mm"
  double factor = 1.0;  ///< shown = factor × SI
};

/// What people read instead of an SI unit: mm for m, deg for rad, MPa for Pa, % for 1; else the unit itself.
DisplayUnit displayUnit(const std::string& si_unit);

/// The value in the unit shown, to `digits` significant digits, with the unit: "312 mm". A value that is not
/// finite is a word, "infinite" or "-", without a unit.
std::string displayValue(double value, const std::string& si_unit, int digits = 4);

/// The same without the unit.
std::string displayNumber(double value, const std::string& si_unit, int digits = 4);

/// The value, or 0 where it is less than anybody measures in its unit (a millionth of a millimetre, a
/// billionth of a radian, a newton, a pascal): what rounding leaves of 0.
double withoutRounding(double value, const std::string& si_unit);

/// The SI value of what a person has typed, in any unit of the SI unit's dimension; a bare number is in the
/// unit shown. Throws std::invalid_argument that says what is there and what was expected.
double parseDisplayed(const std::string& text, const std::string& si_unit);

}  // namespace cable_variation
