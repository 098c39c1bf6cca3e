#pragma once

#include <limits>
#include <string>

#include <cable_variation/util/unit.h>

namespace cable_variation {

/// A kind of quantity that a scene file asks for, and how to speak of it.
struct Quantity {
  const char* name;     ///< with its article: "a length"
  const char* unit;     ///< SI, of a bare number
  const char* example;  ///< "312 mm"
  Dimension dimension;
  const char* units = "";  ///< usual ones, parted by ", "
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

/// A number as it stands in a text.
struct QuantityText {
  double value = 0.0;     ///< SI
  bool has_unit = false;  ///< else the number is taken to be SI already
};

/// The value of a text such as "312 mm", "0.1 Nmm/rad" or "4" (SI already).
/// Throws std::invalid_argument that says what is there and what was expected:
/// no number, not finite, an unknown unit, a unit of another dimension. Radians
/// may be left out or added where other units fix the dimension (N m, N m/rad).
QuantityText readQuantity(const std::string& text, const Quantity& quantity);

/// Its value alone.
double parseQuantity(const std::string& text, const Quantity& quantity);

/// `value` for a message: short, without a unit.
std::string shortNumber(double value);

}  // namespace cable_variation
