#include <cable_variation/report/markup.h>

#include <algorithm>
#include <cmath>

#include <cable_variation/util/display_unit.h>
#include <cable_variation/util/number_text.h>
#include <cable_variation/util/utf8.h>

namespace cable_variation {

namespace {

/// What a character of markup is written as; null: it is none.
const char* entityOf(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return nullptr;
  }
}

}  // namespace

std::string escaped(const std::string& text) {
  constexpr char kReplacement[] = "\xEF\xBF\xBD";  // U+FFFD
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = utf8Length(text, at);
    const char c = text[at];
    const bool is_control = static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n';
    // U+FFFE and U+FFFF are no characters of XML either
    const bool is_none = length == 0 || is_control || text.compare(at, 3, "\xEF\xBF\xBE") == 0 ||
                         text.compare(at, 3, "\xEF\xBF\xBF") == 0;
    if (is_none) {
      result += kReplacement;
    } else if (const char* const entity = entityOf(c)) {
      result += entity;
    } else {
      result.append(text, at, length);
    }
    at += std::max<std::size_t>(length, 1);
  }
  return result;
}

std::string warningHtml(const std::string& text) {
  return "<p class=\"warning\"><strong>Warning:</strong> " + escaped(text) + "</p>\n";
}

std::string figure(double value, int digits) {
  if (std::isnan(value)) return "–";
  if (std::isinf(value)) return value > 0.0 ? "∞" : "−∞";
  // nothing that is calculated is known to less than this, whatever it is of
  constexpr double kLeast = 1e-15;
  std::string result = numberText(std::abs(value) < kLeast ? 0.0 : value, digits);
  // A true minus sign has the width of a digit.
  if (result[0] == '-') result.replace(0, 1, "−");
  return result;
}

std::string millimetres(double metres, int digits) {
  return figure(displayUnit("m").factor * metres, digits);
}

std::string percent(double share) { return figure(100.0 * share, 3) + " %"; }

std::string rejectText(double share) {
  constexpr double kNever = 1e-9, kVerySmall = 1e-4, kSmall = 1e-2;
  if (share > 0.0 && share < kNever) return "< 0.001 ppm";
  const std::string ppm = figure(1e6 * share, 3) + " ppm";
  if (share > 0.0 && share < kVerySmall) return ppm;
  return share > 0.0 && share < kSmall ? percent(share) + " (" + ppm + ")" : percent(share);
}

}  // namespace cable_variation
