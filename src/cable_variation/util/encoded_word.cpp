#include <cable_variation/util/encoded_word.h>

#include <charconv>
#include <stdexcept>
#include <system_error>

#include <cable_variation/util/text_tokens.h>

namespace cable_variation {
namespace {

bool isPlain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
         c == '.';
}

}  // namespace

std::string encodedWord(std::string_view text) {
  constexpr char kDigits[] = "0123456789ABCDEF";
  if (text.empty()) return "%";
  std::string word;
  for (const char c : text) {
    if (isPlain(c)) {
      word += c;
    } else {
      const auto byte = static_cast<unsigned char>(c);
      word += {'%', kDigits[byte / 16], kDigits[byte % 16]};
    }
  }
  return word;
}

std::string decodedWord(std::string_view word) {
  if (word == "%") return "";
  std::string text;
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (word[i] != '%') {
      text += word[i];
      continue;
    }
    unsigned char byte = 0;
    const std::string_view digits = word.substr(i + 1, 2);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), byte, 16);
    if (error != std::errc() || digits.size() != 2 || end != digits.data() + 2)
      throw std::invalid_argument("name " + quoted(word) + ": expected %XX");
    text += static_cast<char>(byte);
    i += 2;
  }
  return text;
}

}  // namespace cable_variation
