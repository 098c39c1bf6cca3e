#include <cable_variation/scene/quantity.h>

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <locale>
#include <map>
#include <sstream>
#include <stdexcept>
#include <vector>

#include <cable_variation/scene/fault_list.h>

namespace cable_variation {
namespace quantity {
// clang-format off
const Quantity number{"a number", "", "0.25", {}};
const Quantity length{"a length", "m", "312 mm", {0, 1, 0, 0}};
const Quantity angle{"an angle", "rad", "5 deg", {0, 0, 0, 1}};
const Quantity force{"a force", "N", "10 N", {1, 1, -2, 0}};
const Quantity moment{"a moment", "N m", "0.1 N m", {1, 2, -2, 0}};
const Quantity acceleration{"an acceleration", "m/s^2", "9.81 m/s^2", {0, 1, -2, 0}};
const Quantity pressure{"a modulus", "Pa", "100 MPa", {1, -1, -2, 0}};
const Quantity stress{"a stress", "Pa", "2 MPa", {1, -1, -2, 0}};
const Quantity energy{"an energy", "J", "0.1 J", {1, 2, -2, 0}};
const Quantity density{"a density", "kg/m^3", "1.2 g/cm^3", {1, -3, 0, 0}};
const Quantity mass_per_length{"a mass per length", "kg/m", "240 g/m", {1, -1, 0, 0}};
const Quantity stretch_stiffness{"a stretch or shear stiffness", "N", "1200 N", {1, 1, -2, 0}};
const Quantity bending_stiffness{"a bending or torsion stiffness", "N m^2", "0.067 N m^2", {1, 3, -2, 0}};
const Quantity spring{"a spring stiffness", "N/m", "5 N/mm", {1, 0, -2, 0}};
const Quantity torsion_spring{"a torsion spring stiffness", "N m/rad", "0.1 N m/rad", {1, 2, -2, -1}};
const Quantity curvature{"a curvature", "1/m", "4 1/m", {0, -1, 0, 0}};
// clang-format on
}  // namespace quantity

namespace {

constexpr double kPi = 3.14159265358979323846;

struct Unit {
  double factor = 1.0;
  Dimension dimension;
};

const std::map<std::string, Unit>& units() {
  static const Dimension none{}, metre{0, 1, 0, 0}, radian{0, 0, 0, 1}, kilogram{1, 0, 0, 0},
      second{0, 0, 1, 0}, newton{1, 1, -2, 0}, pascal{1, -1, -2, 0}, joule{1, 2, -2, 0};
  static const std::map<std::string, Unit> table{
      {"m", {1.0, metre}},          {"mm", {1e-3, metre}},         {"cm", {1e-2, metre}},
      {"dm", {1e-1, metre}},        {"um", {1e-6, metre}},         {"in", {0.0254, metre}},
      {"rad", {1.0, radian}},       {"mrad", {1e-3, radian}},      {"deg", {kPi / 180.0, radian}},
      {"rev", {2.0 * kPi, radian}}, {"turn", {2.0 * kPi, radian}}, {"turns", {2.0 * kPi, radian}},
      {"kg", {1.0, kilogram}},      {"g", {1e-3, kilogram}},       {"s", {1.0, second}},
      {"ms", {1e-3, second}},       {"N", {1.0, newton}},          {"mN", {1e-3, newton}},
      {"kN", {1e3, newton}},        {"Pa", {1.0, pascal}},         {"kPa", {1e3, pascal}},
      {"MPa", {1e6, pascal}},       {"GPa", {1e9, pascal}},        {"J", {1.0, joule}},
      {"%", {1e-2, none}},
  };
  return table;
}

// Typographic signs, written in ASCII.
std::string plain(std::string text) {
  static const std::vector<std::pair<std::string, std::string>> signs{{"\u00b2", "^2"}, {"\u00b3", "^3"},
                                                                      {"\u00b7", " "},  {"\u00b5", "u"},
                                                                      {"\u03bc", "u"},  {"\u00b0", "deg"}};
  for (const auto& [sign, ascii] : signs) {
    for (std::size_t at = text.find(sign); at != std::string::npos; at = text.find(sign, at)) {
      text.replace(at, sign.size(), ascii);
    }
  }
  return text;
}

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

// A product of units with powers: "N mm/rad", "kg/m^3", "1/m".
Unit parseUnit(const std::string& text) {
  Unit product;
  int power_sign = 1;
  std::size_t at = 0;
  const auto letter = [&](std::size_t i) {
    return i < text.size() && (std::isalpha(static_cast<unsigned char>(text[i])) || text[i] == '%');
  };
  while (at < text.size()) {
    const char c = text[at];
    const std::size_t after_one = c == '1' && at == 0 ? text.find_first_not_of(' ', 1) : std::string::npos;
    const bool one_over = after_one != std::string::npos && text[after_one] == '/';
    if (c == ' ' || c == '*' || one_over) {
      ++at;
    } else if (c == '/') {
      power_sign = -1;
      ++at;
    } else if (letter(at)) {
      const std::size_t first = at;
      while (letter(at)) ++at;
      const std::string name = text.substr(first, at - first);
      const auto unit = units().find(name);
      if (unit == units().end()) {
        throw std::invalid_argument("unknown unit '" + name + "'");
      }
      int power = 1;
      const bool raised = at < text.size() && text[at] == '^';
      if (raised) ++at;
      const bool negative = at < text.size() && text[at] == '-';
      if (negative) ++at;
      if (at < text.size() && std::isdigit(static_cast<unsigned char>(text[at]))) {
        power = text[at++] - '0';
      } else if (raised || negative) {
        throw std::invalid_argument("'" + text + "' is no unit");
      }
      power *= power_sign * (negative ? -1 : 1);
      power_sign = 1;
      product.factor *= std::pow(unit->second.factor, power);
      const Dimension& d = unit->second.dimension;
      product.dimension.kilogram += power * d.kilogram;
      product.dimension.metre += power * d.metre;
      product.dimension.second += power * d.second;
      product.dimension.radian += power * d.radian;
    } else {
      throw std::invalid_argument("'" + text + "' is no unit");
    }
  }
  if (power_sign < 0) throw std::invalid_argument("'" + text + "' is no unit");
  return product;
}

bool agree(const Dimension& a, const Dimension& b) {
  if (a.kilogram != b.kilogram || a.metre != b.metre || a.second != b.second) return false;
  const bool derived = a.kilogram != 0 || a.metre != 0 || a.second != 0;
  return derived || a.radian == b.radian;
}

// The unit as it may have been meant: one that fits by itself, or any part of one.
std::string meantUnit(const std::string& text, const Dimension& dimension) {
  std::vector<std::string> fitting;
  std::vector<std::string> all;
  for (const auto& [name, unit] : units()) {
    all.push_back(name);
    if (agree(unit.dimension, dimension)) fitting.push_back(name);
  }
  std::string word = text;
  word.erase(std::min(word.find_first_of(" */^"), word.size()));
  return didYouMean(word, fitting.empty() ? all : fitting);
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

double parseQuantity(const std::string& text, const Quantity& quantity) {
  const std::string expected =
      std::string("; expected ") + quantity.name + ", e.g. '" + quantity.example + "'";
  const std::string ascii = plain(text);
  const std::size_t digits = numberLength(ascii);
  if (digits == 0) throw std::invalid_argument("found '" + text + "'" + expected);

  std::istringstream stream(ascii.substr(0, digits));
  stream.imbue(std::locale::classic());
  double value = 0.0;
  if (!(stream >> value) || !std::isfinite(value)) {
    throw std::invalid_argument("'" + text + "' is not a finite number" + expected);
  }
  const std::size_t unit_start = ascii.find_first_not_of(' ', digits);
  if (unit_start == std::string::npos) return value;

  Unit unit;
  try {
    unit = parseUnit(ascii.substr(unit_start));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string(error.what()) + " in '" + text + "'" + expected +
                                meantUnit(ascii.substr(unit_start), quantity.dimension));
  }
  if (!agree(unit.dimension, quantity.dimension)) {
    throw std::invalid_argument("'" + text + "' has the wrong unit" + expected);
  }
  return value * unit.factor;
}

std::string shortNumber(double value) {
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream << value;
  return stream.str();
}

}  // namespace cable_variation
