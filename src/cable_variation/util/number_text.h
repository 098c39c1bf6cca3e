#pragma once

#include <charconv>
#include <string>
#include <string_view>

namespace cable_variation {

/// Numbers as text and back, with a decimal point whatever the program's locale says. Standard libraries that
/// lack std::to_chars and std::from_chars of floating-point numbers (GCC's before version 11) do the same
/// more slowly.

/// A text that is read back as exactly the same number, of at most 17 digits; "inf", "-inf", "nan".
std::string numberText(double value);

/// The number rounded to so many significant digits, 1 at least, without trailing zeros: printf's %.*g.
std::string numberText(double value, int digits);

/// What std::from_chars does with its general format: reads the longest number that the text starts with,
/// rounded to the nearest double. No blank or '+' may stand before it. `ptr` is where the number ends; `ec`
/// is std::errc::invalid_argument if there is none (`ptr` is then the text's start), and
/// std::errc::result_out_of_range for one that is too large for a double or too small to be told from 0. In
/// both cases `value` stays as it was.
std::from_chars_result readNumber(std::string_view text, double& value);

}  // namespace cable_variation
