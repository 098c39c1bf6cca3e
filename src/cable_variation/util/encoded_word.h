#pragma once

#include <string>
#include <string_view>

namespace cable_variation {

/// Any text as one word of letters, digits, _ - . and %: all else becomes %20 and the like; "%" alone is the
/// empty text.
std::string encodedWord(std::string_view text);

/// The text again; other characters stand for themselves. Throws std::invalid_argument that names the word
/// for a % without two hexadecimal digits.
std::string decodedWord(std::string_view word);

}  // namespace cable_variation
