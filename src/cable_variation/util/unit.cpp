#include <cable_variation/util/unit.h>

#include <cctype>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace cable_variation {
namespace {

constexpr double kGravity = 9.80665;   // [m/s^2], of weights as forces
constexpr double kPound = 0.45359237;  // [kg]
constexpr double kInch = 0.0254;       // [m]
constexpr Dimension kNone{}, kMetre{0, 1, 0, 0}, kRadian{0, 0, 0, 1}, kKilogram{1, 0, 0, 0},
    kSecond{0, 0, 1, 0}, kNewton{1, 1, -2, 0}, kPascal{1, -1, -2, 0}, kJoule{1, 2, -2, 0};

const std::map<std::string, Unit>& units() {
  static const std::map<std::string, Unit> table{
      {"m", {1.0, kMetre}},
      {"km", {1e3, kMetre}},
      {"dm", {1e-1, kMetre}},
      {"cm", {1e-2, kMetre}},
      {"mm", {1e-3, kMetre}},
      {"um", {1e-6, kMetre}},
      {"in", {kInch, kMetre}},
      {"inch", {kInch, kMetre}},
      {"ft", {12.0 * kInch, kMetre}},
      {"rad", {1.0, kRadian}},
      {"mrad", {1e-3, kRadian}},
      {"deg", {M_PI / 180.0, kRadian}},
      {"degree", {M_PI / 180.0, kRadian}},
      {"degrees", {M_PI / 180.0, kRadian}},
      {"rev", {2.0 * M_PI, kRadian}},
      {"turn", {2.0 * M_PI, kRadian}},
      {"turns", {2.0 * M_PI, kRadian}},
      {"t", {1e3, kKilogram}},
      {"kg", {1.0, kKilogram}},
      {"g", {1e-3, kKilogram}},
      {"mg", {1e-6, kKilogram}},
      {"lb", {kPound, kKilogram}},
      {"s", {1.0, kSecond}},
      {"ms", {1e-3, kSecond}},
      {"us", {1e-6, kSecond}},
      {"min", {60.0, kSecond}},
      {"N", {1.0, kNewton}},
      {"mN", {1e-3, kNewton}},
      {"cN", {1e-2, kNewton}},
      {"daN", {1e1, kNewton}},
      {"kN", {1e3, kNewton}},
      {"MN", {1e6, kNewton}},
      {"lbf", {kPound * kGravity, kNewton}},
      {"Pa", {1.0, kPascal}},
      {"kPa", {1e3, kPascal}},
      {"MPa", {1e6, kPascal}},
      {"GPa", {1e9, kPascal}},
      {"bar", {1e5, kPascal}},
      {"psi", {kPound * kGravity / (kInch * kInch), kPascal}},
      {"J", {1.0, kJoule}},
      {"mJ", {1e-3, kJoule}},
      {"kJ", {1e3, kJoule}},
      {"%", {1e-2, kNone}},
  };
  return table;
}

bool isNewton(const Dimension& d) {
  return d.kilogram == kNewton.kilogram && d.metre == kNewton.metre && d.second == kNewton.second;
}

bool isMetre(const Dimension& d) { return d.kilogram == 0 && d.metre == 1 && d.second == 0 && d.radian == 0; }

void multiply(Unit& product, const Unit& unit, int power) {
  product.factor *= std::pow(unit.factor, power);
  product.dimension.kilogram += power * unit.dimension.kilogram;
  product.dimension.metre += power * unit.dimension.metre;
  product.dimension.second += power * unit.dimension.second;
  product.dimension.radian += power * unit.dimension.radian;
}

/// Reads a product of units from left to right.
class UnitParser {
 public:
  explicit UnitParser(const std::string& text) : text_(text) {}

  Unit read() {
    const Unit unit = product();
    if (at_ < text_.size()) fail();
    return unit;
  }

 private:
  static constexpr int kDeepest = 8;  // brackets within brackets

  [[noreturn]] void fail() const { throw std::invalid_argument("'" + text_ + "' is no unit"); }

  char here() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  bool atDigit() const { return std::isdigit(static_cast<unsigned char>(here())) != 0; }
  bool atLetter() const { return std::isalpha(static_cast<unsigned char>(here())) != 0 || here() == '%'; }

  // N*m, and as it is written too: N.m, N-m.
  bool atTimes() const {
    const bool before_letter =
        at_ + 1 < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_ + 1])) != 0;
    return here() == '*' || (before_letter && (here() == '.' || here() == '-'));
  }

  // Up to the end or a closing bracket.
  Unit product() {
    Unit result;
    int sign = 1;
    bool wants_factor = false;  // after * or /
    for (bool first = true; at_ < text_.size() && here() != ')';) {
      if (here() == ' ') {
        ++at_;
        continue;
      }
      if (here() == '/' || atTimes()) {
        if (wants_factor || (first && here() != '/')) fail();
        sign = here() == '/' ? -1 : 1;
        wants_factor = true;
        ++at_;
      } else {
        factor(result, sign, first);
        sign = 1;
        wants_factor = false;
      }
      first = false;
    }
    if (wants_factor) fail();
    return result;
  }

  // A symbol or a bracket with its power, or the 1 of 1/m.
  void factor(Unit& result, int sign, bool first) {
    if (here() == '1' && first && sign > 0) {
      ++at_;
      const std::size_t next = text_.find_first_not_of(' ', at_);
      if (next == std::string::npos || text_[next] != '/') fail();
    } else if (here() == '(') {
      if (++depth_ > kDeepest) fail();
      ++at_;
      const Unit inner = product();
      if (here() != ')') fail();
      ++at_;
      --depth_;
      multiply(result, inner, sign * power());
    } else if (atLetter()) {
      const std::size_t start = at_;
      while (atLetter()) ++at_;
      symbol(text_.substr(start, at_ - start), sign, result);
    } else {
      fail();
    }
  }

  void symbol(const std::string& name, int sign, Unit& result) {
    const auto unit = units().find(name);
    if (unit != units().end()) {
      multiply(result, unit->second, sign * power());
      return;
    }
    for (std::size_t length = 1; length < name.size(); ++length) {  // a force by a length: Nm, kNmm
      const auto force = units().find(name.substr(0, length));
      const auto arm = units().find(name.substr(length));
      if (force == units().end() || arm == units().end()) continue;
      if (!isNewton(force->second.dimension) || !isMetre(arm->second.dimension)) continue;
      multiply(result, force->second, sign);
      multiply(result, arm->second, sign * power());
      return;
    }
    throw std::invalid_argument("unknown unit '" + name + "'");
  }

  int power() {
    const bool raised = here() == '^';
    if (raised) ++at_;
    const bool negative = here() == '-' && at_ + 1 < text_.size() &&
                          std::isdigit(static_cast<unsigned char>(text_[at_ + 1])) != 0;
    if (negative) ++at_;
    if (!atDigit()) {
      if (raised) fail();
      return 1;
    }
    const int digit = here() - '0';
    ++at_;
    if (atDigit()) fail();
    return negative ? -digit : digit;
  }

  const std::string& text_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

bool agree(const Dimension& a, const Dimension& b) {
  if (a.kilogram != b.kilogram || a.metre != b.metre || a.second != b.second) return false;
  const bool derived = a.kilogram != 0 || a.metre != 0 || a.second != 0;
  return derived || a.radian == b.radian;
}

std::string plainSigns(std::string text) {
  static const std::vector<std::pair<std::string, std::string>> signs{
      {"\u207b\u00b9", "^-1"}, {"\u207b\u00b2", "^-2"}, {"\u207b\u00b3", "^-3"},
      {"\u207b\u2074", "^-4"}, {"\u00b2", "^2"},        {"\u00b3", "^3"},
      {"\u2074", "^4"},        {"\u2212", "-"},         {"\u00b7", "*"},
      {"\u22c5", "*"},         {"\u2219", "*"},         {"\u00d7", "*"},
      {"\u2044", "/"},         {"\u2215", "/"},         {"\u00a0", " "},
      {"\u2009", " "},         {"\u202f", " "},         {"\t", " "},
      {"\u00b5", "u"},         {"\u03bc", "u"},         {"\u00b0", "deg"},
  };
  for (const auto& [sign, ascii] : signs) {
    for (std::size_t at = text.find(sign); at != std::string::npos; at = text.find(sign, at + ascii.size())) {
      text.replace(at, sign.size(), ascii);
    }
  }
  return text;
}

Unit parseUnit(const std::string& text) { return UnitParser(text).read(); }

std::vector<std::string> unitSymbols(const Dimension* dimension) {
  std::vector<std::string> symbols;
  for (const auto& [name, unit] : units()) {
    if (!dimension || agree(unit.dimension, *dimension)) symbols.push_back(name);
  }
  return symbols;
}

}  // namespace cable_variation
