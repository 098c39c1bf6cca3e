#include <cable_variation/util/display_unit.h>

#include <cmath>

#include <cable_variation/util/number_text.h>
#include <cable_variation/util/quantity.h>
#include <cable_variation/util/unit.h>

namespace cable_variation {

DisplayUnit displayUnit(const std::string& si_unit) {
  if (si_unit == "m") return {"mm", 1e3};
  if (si_unit == "rad") return {"deg", 180.0 / M_PI};
  if (si_unit == "Pa") return {"MPa", 1e-6};
  if (si_unit == "1") return {"%", 1e2};
  return {si_unit, 1.0};
}

std::string displayNumber(double value, const std::string& si_unit, int digits) {
  if (std::isnan(value)) return "-";
  if (std::isinf(value)) return value > 0.0 ? "infinite" : "-infinite";
  const double shown = displayUnit(si_unit).factor * value;
  return shown == 0.0 ? "0" : numberText(shown, digits);
}

std::string displayValue(double value, const std::string& si_unit, int digits) {
  const std::string number = displayNumber(value, si_unit, digits);
  return std::isfinite(value) ? number + " " + displayUnit(si_unit).symbol : number;
}

double withoutRounding(double value, const std::string& si_unit) {
  constexpr double kLeast = 1e-9;
  const bool measured = si_unit == "m" || si_unit == "rad" || si_unit == "N" || si_unit == "N m" ||
                        si_unit == "Pa" || si_unit == "J" || si_unit == "N/m" || si_unit == "1";
  return measured && std::abs(value) < kLeast ? 0.0 : value;
}

double parseDisplayed(const std::string& text, const std::string& si_unit) {
  const DisplayUnit shown = displayUnit(si_unit);
  const std::string example = "3.5 " + shown.symbol;
  const Dimension dimension = si_unit == "1" ? Dimension() : parseUnit(si_unit).dimension;
  const Quantity quantity{"a value", si_unit.c_str(), example.c_str(), dimension};
  const QuantityText read = readQuantity(text, quantity);
  return read.has_unit ? read.value : read.value / shown.factor;
}

}  // namespace cable_variation
