#include <cable_variation/util/readable_text.h>

#include <algorithm>
#include <cstddef>

namespace cable_variation {
namespace {

unsigned char byteAt(const std::string& text, std::size_t at) { return static_cast<unsigned char>(text[at]); }

bool continues(const std::string& text, std::size_t at) { return (byteAt(text, at) & 0xc0U) == 0x80U; }

// Bytes of the character of UTF-8 that starts there; 0: none does (RFC 3629, table of section 4).
std::size_t lengthOfCharacter(const std::string& text, std::size_t at) {
  const unsigned char first = byteAt(text, at);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xc2 && first < 0xe0   ? 2
                             : first >= 0xe0 && first < 0xf0 ? 3
                             : first >= 0xf0 && first < 0xf5 ? 4
                                                             : 0;
  if (length == 0 || at + length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if (!continues(text, at + i)) return 0;
  }
  const unsigned char second = byteAt(text, at + 1);
  const bool is_none = (first == 0xe0 && second < 0xa0) || (first == 0xed && second >= 0xa0) ||
                       (first == 0xf0 && second < 0x90) || (first == 0xf4 && second >= 0x90);
  return is_none ? 0 : length;
}

std::string escaped(const std::string& text) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string shown;
  for (std::size_t at = 0; at < text.size();) {
    const unsigned char byte = byteAt(text, at);
    const std::size_t length = byte < 0x20 || byte == 0x7f ? 0 : lengthOfCharacter(text, at);
    if (length > 0) {
      shown.append(text, at, length);
    } else {
      shown += {'\\', 'x', kDigits[byte >> 4U], kDigits[byte & 0xfU]};
    }
    at += std::max<std::size_t>(length, 1);
  }
  return shown;
}

}  // namespace

std::string readableText(const std::string& message) {
  constexpr std::size_t kMost = 2000, kEnd = 1000;  // bytes
  const std::string text = escaped(message);
  if (text.size() <= kMost) return text;
  std::size_t from = kMost - kEnd, to = text.size() - kEnd;  // between characters of UTF-8
  while (from > 0 && continues(text, from)) --from;
  while (to < text.size() && continues(text, to)) ++to;
  return text.substr(0, from) + " ... (" + std::to_string(to - from) + " bytes) ... " + text.substr(to);
}

}  // namespace cable_variation
