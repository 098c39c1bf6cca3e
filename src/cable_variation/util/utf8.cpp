#include <cable_variation/util/utf8.h>

namespace cable_variation {

namespace {

unsigned char byteAt(const std::string& text, std::size_t at) { return static_cast<unsigned char>(text[at]); }

}  // namespace

bool continuesUtf8(const std::string& text, std::size_t at) { return (byteAt(text, at) & 0xc0U) == 0x80U; }

std::size_t utf8Length(const std::string& text, std::size_t at) {
  const unsigned char first = byteAt(text, at);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xc2 && first < 0xe0   ? 2
                             : first >= 0xe0 && first < 0xf0 ? 3
                             : first >= 0xf0 && first < 0xf5 ? 4
                                                             : 0;
  if (length == 0 || at + length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if (!continuesUtf8(text, at + i)) return 0;
  }
  const unsigned char second = byteAt(text, at + 1);
  const bool is_none = (first == 0xe0 && second < 0xa0) || (first == 0xed && second >= 0xa0) ||
                       (first == 0xf0 && second < 0x90) || (first == 0xf4 && second >= 0x90);
  return is_none ? 0 : length;
}

}  // namespace cable_variation
