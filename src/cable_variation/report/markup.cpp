#include <cable_variation/report/markup.h>

#include <cmath>

#include <cable_variation/util/number_text.h>

namespace cable_variation {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      case '\t':
      case '\n':
        result += c;
        break;
      default:
        if (static_cast<unsigned char>(c) < 0x20) {
          result += "\xEF\xBF\xBD";
        } else {
          result += c;
        }
    }
  }
  return result;
}

std::string warningHtml(const std::string& text) {
  return "<p class=\"warning\"><strong>Warning:</strong> " + escaped(text) + "</p>\n";
}

std::string figure(double value, int digits) {
  if (std::isnan(value)) return "–";
  if (std::isinf(value)) return value > 0.0 ? "∞" : "−∞";
  std::string result = numberText(value == 0.0 ? 0.0 : value, digits);
  // A true minus sign has the width of a digit.
  if (result[0] == '-') result.replace(0, 1, "−");
  return result;
}

std::string percent(double share) { return figure(100.0 * share, 3) + " %"; }

ShownUnit shownUnit(const std::string& si_unit) {
  if (si_unit == "m") return {"mm", 1e3};
  if (si_unit == "rad") return {"°", 180.0 / M_PI};
  if (si_unit == "1") return {"", 1.0};
  return {si_unit, 1.0};
}

}  // namespace cable_variation
