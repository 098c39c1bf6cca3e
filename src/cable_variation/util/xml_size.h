#pragma once

#include <cstddef>
#include <string_view>

namespace cable_variation {

/// Counts what a parser of XML will make of a text, before one takes the memory for it: elements and
/// attributes, none too few. Throws std::invalid_argument with the bound if there are more than `most_parts`.
/// (How deep elements are nested is limited by tinyxml2 itself, and entities it does not follow.)
void requireXmlSize(std::string_view text, std::size_t most_parts);

}  // namespace cable_variation
