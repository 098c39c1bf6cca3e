#include <cable_variation/import/kbl_quantity.h>

#include <cctype>
#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>

#include <cable_variation/util/text_tokens.h>
#include <cable_variation/util/unit.h>

namespace cable_variation {
namespace {

const std::map<std::string, double>& prefixes() {
  static const std::map<std::string, double> table{
      {"", 1.0},     {"nano", 1e-9}, {"micro", 1e-6}, {"milli", 1e-3}, {"centi", 1e-2}, {"deci", 1e-1},
      {"deca", 1e1}, {"hecto", 1e2}, {"kilo", 1e3},   {"mega", 1e6},   {"giga", 1e9}};
  return table;
}

// Units that are written as words, beside those that parseUnit() knows.
const std::map<std::string, Unit>& words() {
  static const std::map<std::string, Unit> table{
      {"metre", {1.0, {0, 1, 0, 0}}},
      {"meter", {1.0, {0, 1, 0, 0}}},
      {"millimetre", {1e-3, {0, 1, 0, 0}}},
      {"millimeter", {1e-3, {0, 1, 0, 0}}},
      {"gram", {1e-3, {1, 0, 0, 0}}},
      {"kilogram", {1.0, {1, 0, 0, 0}}},
      {"grampermetre", {1e-3, {1, -1, 0, 0}}},
      {"grampermeter", {1e-3, {1, -1, 0, 0}}},
      {"kilogrampermetre", {1.0, {1, -1, 0, 0}}},
      {"kilogrampermeter", {1.0, {1, -1, 0, 0}}},
      {"squaremillimetre", {1e-6, {0, 2, 0, 0}}},
      {"squaremillimeter", {1e-6, {0, 2, 0, 0}}},
  };
  return table;
}

// Lower case, letters alone.
std::string plainWord(const std::string& text) {
  std::string word;
  for (const char c : text) {
    if (std::isalpha(static_cast<unsigned char>(c)) != 0)
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return word;
}

// Of a name: a word, or symbols.
std::optional<Unit> namedUnit(const std::string& name) {
  if (const auto word = words().find(plainWord(name)); word != words().end()) return word->second;
  try {
    return parseUnit(plainSigns(name));
  } catch (const std::invalid_argument&) {
    return {};
  }
}

std::optional<Unit> unitOf(const XmlElement& element) {
  const std::string name = element.textOf("Unit_name");
  const std::string si_name = element.textOf("Si_unit_name");
  if (name.empty() && si_name.empty()) return {};
  auto unit = namedUnit(si_name.empty() ? name : si_name);
  const auto prefix = prefixes().find(plainWord(element.textOf("Si_prefix")));
  if (!unit || prefix == prefixes().end()) return {};
  unit->factor *= prefix->second;
  const std::string dimension = plainWord(element.textOf("Si_dimension"));
  const int power = dimension.empty() ? 1 : dimension == "square" ? 2 : dimension == "cubic" ? 3 : 0;
  if (power == 0) return {};
  unit->factor = std::pow(unit->factor, power);
  for (int* exponent : {&unit->dimension.kilogram, &unit->dimension.metre, &unit->dimension.second,
                        &unit->dimension.radian}) {
    *exponent *= power;
  }
  return unit;
}

std::string unitText(const XmlElement& unit) {
  std::string text;
  for (const char* part : {"Si_dimension", "Si_prefix", "Si_unit_name", "Unit_name"}) {
    const std::string word = unit.textOf(part);
    if (!word.empty()) text += (text.empty() ? "" : " ") + word;
  }
  return text;
}

constexpr Range kMasses{0.0, 1e3, true};  // [kg/m]

// What is done with a message on a unit of another dimension.
using UnitFault = std::function<void(const XmlElement& unit, const std::string& message)>;

std::optional<double> readQuantity(const XmlElement& value, const Quantity& quantity, const Range& range,
                                   const UnitFault& tell) {
  const auto number = value.require("Value_component");
  const auto unit_reference = value.require("Unit_component");
  if (!number || !unit_reference) return {};
  const double plain = number->number();
  const auto unit_element = unit_reference->target({"Unit"});
  if (!unit_element || std::isnan(plain)) return {};
  const auto unit = unitOf(*unit_element);
  if (!unit || !agree(unit->dimension, quantity.dimension)) {
    tell(*unit_reference, "the unit '" + unit_element->id() + "' is " + quoted(unitText(*unit_element)) +
                              "; expected that of " + quantity.name + ", such as " + quantity.unit);
    return {};
  }
  const double si = unit->factor * plain;
  if (!range.holds(si)) {
    number->fail("found " + shortNumber(plain) + " " + unitText(*unit_element) + "; expected " +
                 range.text(quantity.unit));
    return {};
  }
  return si;
}

}  // namespace

const Quantity kKblArea{"an area", "m^2", "12.6 mm^2", {0, 2, 0, 0}, "m^2, mm^2"};

std::optional<double> findKblQuantity(const XmlElement& owner, const std::string& name,
                                      const Quantity& quantity, const Range& range) {
  const auto value = owner.find(name);
  if (!value) return {};
  const UnitFault tell = [](const XmlElement& unit, const std::string& message) { unit.fail(message); };
  return readQuantity(*value, quantity, range, tell);
}

std::optional<double> findKblMassPerLength(const XmlElement& part, ImportFindings& findings) {
  const auto value = part.find("Mass_information");
  if (!value) return {};
  const UnitFault tell = [&](const XmlElement& unit, const std::string& message) {
    findings.push_back({ImportFinding::Kind::wrong_unit, part.id(), unit.line(),
                        unit.label() + ": " + message + "; this mass is not used"});
  };
  return readQuantity(*value, quantity::mass_per_length, kMasses, tell);
}

}  // namespace cable_variation
