#include <cable_variation/report/csv.h>

#include <cmath>

#include <cable_variation/util/number_text.h>

namespace cable_variation::csv {

std::string text(const std::string& content) {
  std::string result = "\"";
  for (const char c : content) {
    if (c == '"') result += '"';
    result += c;
  }
  return result + "\"";
}

std::string number(double value) {
  if (std::isnan(value)) return "nan";
  return numberText(value);
}

std::string number(const std::optional<double>& value) { return value ? number(*value) : ""; }

}  // namespace cable_variation::csv
