#pragma once

#include <cstddef>
#include <string>

namespace cable_variation {

/// Bytes of the character of UTF-8 that starts at `at`; 0: none does (RFC 3629, table of section 4).
std::size_t utf8Length(const std::string& text, std::size_t at);

/// Whether the byte at `at` is one within a character, not its first.
bool continuesUtf8(const std::string& text, std::size_t at);

}  // namespace cable_variation
