#include <cable_variation/report/csv.h>

#include <cmath>
#include <cstdio>

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
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.17g", value);
  return buffer;
}

std::string number(const std::optional<double>& value) { return value ? number(*value) : ""; }

}  // namespace cable_variation::csv
