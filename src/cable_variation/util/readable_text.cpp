#include <cable_variation/util/readable_text.h>

#include <algorithm>
#include <cstddef>

#include <cable_variation/util/utf8.h>

namespace cable_variation {
namespace {

unsigned char byteAt(const std::string& text, std::size_t at) { return static_cast<unsigned char>(text[at]); }

std::string escaped(const std::string& text) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string shown;
  for (std::size_t at = 0; at < text.size();) {
    const unsigned char byte = byteAt(text, at);
    const std::size_t length = byte < 0x20 || byte == 0x7f ? 0 : utf8Length(text, at);
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
  while (from > 0 && continuesUtf8(text, from)) --from;
  while (to < text.size() && continuesUtf8(text, to)) ++to;
  return text.substr(0, from) + " ... (" + std::to_string(to - from) + " bytes) ... " + text.substr(to);
}

}  // namespace cable_variation
