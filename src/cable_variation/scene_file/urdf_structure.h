#pragma once  // internal to scene_file/

#include <string>
#include <vector>

namespace cable_variation {

/// A URDF made fit for the URDF parser, which follows a cycle of links for ever and takes
/// names for format strings. Appends to `faults`, with lines of the text, what is no XML or
/// nested too deep, and links and joints that make no tree; then the result is empty.
/// Else it is the same document with `mark` wherever a value had a %.
std::string checkedUrdf(const std::string& text, const std::string& mark, std::vector<std::string>& faults);

/// A character that a text does not hold, to stand for others in it.
std::string unusedCharacter(const std::string& text);

}  // namespace cable_variation
