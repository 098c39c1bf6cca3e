#include <cable_variation/util/quantity.h>

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <vector>

#include <cable_variation/util/name_list.h>

namespace cable_variation {
namespace quantity {
// clang-format off
const Quantity number{"a number", "", "0.25", {}, "%"};
const Quantity length{"a length", "m", "312 mm", {0, 1, 0, 0}, "m, cm, mm, um, in, ft"};
const Quantity angle{"an angle", "rad", "5 deg", {0, 0, 0, 1}, "rad, mrad, deg, turns"};
const Quantity force{"a force", "N", "10 N", {1, 1, -2, 0}, "N, kN, mN, lbf"};
const Quantity moment{"a moment", "N m", "0.1 N m", {1, 2, -2, 0}, "N m, N mm, kN m, mN m"};
const Quantity acceleration{"an acceleration", "m/s^2", "9.81 m/s^2", {0, 1, -2, 0}, "m/s^2, mm/s^2"};
const Quantity pressure{"a modulus", "Pa", "100 MPa", {1, -1, -2, 0}, "Pa, kPa, MPa, GPa, N/mm^2, bar, psi"};
const Quantity stress{"a stress", "Pa", "2 MPa", {1, -1, -2, 0}, "Pa, kPa, MPa, GPa, N/mm^2, bar, psi"};
const Quantity energy{"an energy", "J", "0.1 J", {1, 2, -2, 0}, "J, mJ, kJ, N m, N mm"};
const Quantity density{"a density", "kg/m^3", "1.2 g/cm^3", {1, -3, 0, 0}, "kg/m^3, g/cm^3, kg/dm^3, t/mm^3"};
const Quantity mass_per_length{"a mass per length", "kg/m", "240 g/m", {1, -1, 0, 0}, "kg/m, g/m, g/mm, kg/mm"};
const Quantity stretch_stiffness{"a stretch or shear stiffness", "N", "1200 N", {1, 1, -2, 0}, "N, kN, MN, lbf"};
const Quantity bending_stiffness{"a bending or torsion stiffness", "N m^2", "0.067 N m^2", {1, 3, -2, 0}, "N m^2, N mm^2, kN m^2, N m^2/rad"};
const Quantity spring{"a spring stiffness", "N/m", "5 N/mm", {1, 0, -2, 0}, "N/m, N/mm, kN/m"};
const Quantity torsion_spring{"a torsion spring stiffness", "N m/rad", "0.1 N m/rad", {1, 2, -2, -1}, "N m/rad, N mm/rad, N m/deg, N mm/deg"};
const Quantity curvature{"a curvature", "1/m", "4 1/m", {0, -1, 0, 0}, "1/m, 1/mm, rad/m, deg/m"};
// clang-format on
}  // namespace quantity

namespace {

// Length of the decimal number that `text` starts with; 0: none.
std::size_t numberLength(const std::string& text) {
  std::size_t at = 0;
  const auto digits = [&] {
    const std::size_t first = at;
    while (at < text.size() && std::isdigit(static_cast<unsigned char>(text[at]))) ++at;
    return at - first;
  };
  const auto sign = [&] {
    if (at < text.size() && (text[at] == '+' || text[at] == '-')) ++at;
  };
  sign();
  std::size_t mantissa = digits();
  if (at < text.size() && text[at] == '.') {
    ++at;
    mantissa += digits();
  }
  if (mantissa == 0) return 0;
  const std::size_t end = at;
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    ++at;
    sign();
    if (digits() == 0) return end;
  } else {
    return end;
  }
  return at;
}

std::vector<std::string> usualUnits(const Quantity& quantity) {
  std::vector<std::string> units;
  std::istringstream list(quantity.units);
  for (std::string unit; std::getline(list >> std::ws, unit, ',');) units.push_back(unit);
  return units;
}

// Without blanks and signs, in small letters.
std::string letters(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  return result;
}

// The unit as it may have been meant, and those that would do.
std::string meantUnit(const std::string& text, const Quantity& quantity) {
  const std::vector<std::string> usual = usualUnits(quantity);
  if (usual.empty()) return didYouMean(text, unitSymbols());
  std::string meant;
  for (const std::string& unit : usual) {
    if (letters(unit) == letters(text)) meant = "; did you mean '" + unit + "'?";
  }
  if (meant.empty()) meant = didYouMean(text, usual);
  if (meant.find("did you mean") == std::string::npos) meant.clear();
  return (meant.empty() ? ";" : meant) + " known: " + joined(usual);
}

// What may be wrong with a text that starts with a number and goes on like this.
std::string commaHint(const std::string& rest) {
  return !rest.empty() && rest.front() == ',' ? " (a number has a decimal point, and no comma)" : "";
}

}  // namespace

bool Range::holds(double value) const {
  return std::isfinite(value) && value <= high && (low_open ? value > low : value >= low);
}

std::string Range::text(const char* unit) const {
  const std::string suffix = *unit ? std::string(" ") + unit : "";
  if (std::isfinite(low) && std::isfinite(high)) {
    return (low_open ? "more than " + shortNumber(low) + " and at most "
                     : "between " + shortNumber(low) + " and ") +
           shortNumber(high) + suffix;
  }
  if (std::isfinite(low)) return (low_open ? "more than " : "at least ") + shortNumber(low) + suffix;
  if (std::isfinite(high)) return "at most " + shortNumber(high) + suffix;
  return "any finite value" + suffix;
}

QuantityText readQuantity(const std::string& text, const Quantity& quantity) {
  const std::string expected =
      std::string("; expected ") + quantity.name + ", e.g. '" + quantity.example + "'";
  const std::string ascii = plainSigns(text);
  const std::size_t digits = numberLength(ascii);
  if (digits == 0) throw std::invalid_argument("found '" + text + "'" + expected);

  std::istringstream stream(ascii.substr(0, digits));
  stream.imbue(std::locale::classic());
  double value = 0.0;
  if (!(stream >> value) || !std::isfinite(value)) {
    throw std::invalid_argument("'" + text + "' is not a finite number" + expected);
  }
  const std::size_t unit_start = ascii.find_first_not_of(' ', digits);
  if (unit_start == std::string::npos) return {value, false};

  const std::string symbol = ascii.substr(unit_start, ascii.find_last_not_of(' ') + 1 - unit_start);
  Unit unit;
  try {
    unit = parseUnit(symbol);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string(error.what()) + " in '" + text + "'" + commaHint(symbol) +
                                expected + meantUnit(symbol, quantity));
  }
  if (!agree(unit.dimension, quantity.dimension)) {
    throw std::invalid_argument("'" + text + "' has the wrong unit" + expected);
  }
  value *= unit.factor;
  if (!std::isfinite(value)) throw std::invalid_argument("'" + text + "' is not a finite number" + expected);
  return {value, true};
}

double parseQuantity(const std::string& text, const Quantity& quantity) {
  return readQuantity(text, quantity).value;
}

std::string shortNumber(double value) {
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream << value;
  return stream.str();
}

}  // namespace cable_variation
