#pragma once

#include <string>
#include <vector>

namespace cable_variation {

/// Exponents of the base units kg, m, s and rad.
struct Dimension {
  int kilogram = 0;
  int metre = 0;
  int second = 0;
  int radian = 0;
};

/// What one of a unit is in SI units.
struct Unit {
  double factor = 1.0;
  Dimension dimension;
};

/// Whether a unit of one dimension may stand for the other: radians may be left
/// out or added where other units fix the dimension (N m, N m/rad).
bool agree(const Dimension& a, const Dimension& b);

/// Typographic signs (mm², N·m, m⁻¹, µm, 90°, − for -, narrow blanks) written in ASCII.
std::string plainSigns(std::string text);

/// The unit that an ASCII text stands for: symbols with powers (mm^2, mm2, m^-1),
/// multiplied by a blank or a *, divided by a / (which divides by the next factor
/// alone), in brackets if wanted. A force and a length may be written as one word: Nm,
/// kNmm. Throws std::invalid_argument: "unknown unit 'NM'", "'m^' is no unit".
Unit parseUnit(const std::string& text);

/// Symbols of units of a dimension, by name; none: all there are.
std::vector<std::string> unitSymbols(const Dimension* dimension = nullptr);

}  // namespace cable_variation
