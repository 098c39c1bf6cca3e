#pragma once

#include <limits>
#include <string>

namespace cable_variation {

/// Exponents of the base units kg, m, s and rad.
struct Dimension {
  int kilogram = 0;
  int metre = 0;
  int second = 0;
  int radian = 0;
};

/// A kind of quantity that a scene file asks for, and how to speak of it.
struct Quantity {
  const char* name;     ///< with its article: "a length"
  const char* unit;     ///< SI, of a bare number
  const char* example;  ///< "312 mm"
  Dimension dimension;
};

namespace quantity {
extern const Quantity number, length, angle, force, moment, acceleration, pressure, stress, density, energy,
    mass_per_length, stretch_stiffness, bending_stiffness, spring, torsion_spring, curvature;
}  // namespace quantity

/// Values that make physical sense.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;  ///< `low` itself is outside

  static Range any() { return {}; }
  static Range positive() { return {0.0, std::numeric_limits<double>::infinity(), true}; }
  static Range notNegative() { return {0.0, std::numeric_limits<double>::infinity(), false}; }

  bool holds(double value) const;
  /// "more than 0 m", "between 0 and 0.5"
  std::string text(const char* unit) const;
};

/// The SI value of a text such as "312 mm", "0.1 N mm/rad" or "4" (SI already).
/// Throws std::invalid_argument that says what is there and what was expected:
/// no number, not finite, an unknown unit, a unit of another dimension. Radians
/// may be left out or added where other units fix the dimension (N m, N m/rad).
double parseQuantity(const std::string& text, const Quantity& quantity);

/// `value` for a message: short, without a unit.
std::string shortNumber(double value);

}  // namespace cable_variation
