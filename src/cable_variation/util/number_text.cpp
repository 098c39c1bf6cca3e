#include <cable_variation/util/number_text.h>

#ifndef __cpp_lib_to_chars
#include <clocale>
#include <cmath>
#include <cstdlib>
#include <locale>
#include <memory>
#include <sstream>
#include <type_traits>

#include <locale.h>
#include <stdlib.h>
#endif

namespace cable_variation {

#ifdef __cpp_lib_to_chars

std::string numberText(double value) {
  char buffer[32];  // 24 are needed: "-1.2345678901234567e-308"
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

std::string numberText(double value, int digits) {
  std::string text(static_cast<std::size_t>(digits) + 16, '\0');
  char* const first = text.data();
  const char* last = std::to_chars(first, first + text.size(), value, std::chars_format::general, digits).ptr;
  text.resize(static_cast<std::size_t>(last - first));
  return text;
}

std::from_chars_result readNumber(std::string_view text, double& value) {
  return std::from_chars(text.data(), text.data() + text.size(), value);
}

#else

namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }

std::size_t digitsFrom(std::string_view text, std::size_t at) {
  while (at < text.size() && isDigit(text[at])) ++at;
  return at;
}

// Whether `text` goes on with a word in small or capital letters.
bool hasWord(std::string_view text, std::size_t at, std::string_view word) {
  if (text.size() - at < word.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i) {
    if ((text[at + i] | 0x20) != word[i]) return false;
  }
  return true;
}

// Behind nan: its payload in brackets, if it is whole.
std::size_t afterPayload(std::string_view text, std::size_t at) {
  if (at == text.size() || text[at] != '(') return at;
  for (std::size_t i = at + 1; i < text.size(); ++i) {
    if (text[i] == ')') return i + 1;
    const bool letter = (text[i] | 0x20) >= 'a' && (text[i] | 0x20) <= 'z';
    if (!letter && !isDigit(text[i]) && text[i] != '_') return at;
  }
  return at;
}

// Length of the number that a text starts with; 0: it starts with none.
std::size_t numberLength(std::string_view text) {
  const std::size_t start = !text.empty() && text.front() == '-' ? 1 : 0;
  if (hasWord(text, start, "infinity")) return start + 8;
  if (hasWord(text, start, "inf")) return start + 3;
  if (hasWord(text, start, "nan")) return afterPayload(text, start + 3);

  std::size_t end = digitsFrom(text, start);
  std::size_t digits = end - start;
  if (end < text.size() && text[end] == '.') {
    const std::size_t fraction = end + 1;
    const std::size_t fraction_end = digitsFrom(text, fraction);
    digits += fraction_end - fraction;
    end = fraction_end;
  }
  if (digits == 0) return 0;
  if (end < text.size() && (text[end] | 0x20) == 'e') {
    std::size_t exponent = end + 1;
    if (exponent < text.size() && (text[exponent] == '-' || text[exponent] == '+')) ++exponent;
    const std::size_t exponent_end = digitsFrom(text, exponent);
    if (exponent_end > exponent) end = exponent_end;
  }
  return end;
}

// strtod as it is in every locale; `text` is a whole number by numberLength.
double valueOf(const std::string& text) {
  const std::unique_ptr<std::remove_pointer_t<locale_t>, decltype(&freelocale)> plain(
      newlocale(LC_ALL_MASK, "C", nullptr), &freelocale);
  return strtod_l(text.c_str(), nullptr, plain.get());
}

bool isZero(std::string_view text) {
  for (const char c : text) {
    if ((c | 0x20) == 'e') break;
    if (c >= '1' && c <= '9') return false;
  }
  return true;
}

}  // namespace

std::string numberText(double value, int digits) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(digits);
  text << value;
  return text.str();
}

std::string numberText(double value) {
  for (int digits = 15; digits < 17; ++digits) {
    const std::string text = numberText(value, digits);
    if (valueOf(text) == value) return text;
  }
  return numberText(value, 17);
}

std::from_chars_result readNumber(std::string_view text, double& value) {
  const std::size_t length = numberLength(text);
  if (length == 0) return {text.data(), std::errc::invalid_argument};
  const std::string number(text.substr(0, length));
  const char* const end = text.data() + length;
  const double read = valueOf(number);
  const bool spelt_out =
      (number.back() | 0x20) > 'e' || number.back() == ')';  // inf, infinity, nan, nan(...)
  if (!spelt_out && (std::isinf(read) || (read == 0.0 && !isZero(number)))) {
    return {end, std::errc::result_out_of_range};
  }
  value = read;
  return {end, std::errc()};
}

#endif

}  // namespace cable_variation
