#pragma once  // internal to geometry/

#include <string>

#include <cable_variation/util/input_limits.h>

namespace cable_variation {

/// Looks at a COLLADA document before an importer does that trusts it: arrays hold as many numbers as they
/// announce; accessors stay within their arrays; primitives hold as many indices as they announce, whole
/// numbers within what they index; nodes do not instance themselves, by way of others either, and all of them
/// together are not more than kMostNodes; references lead to what is there.
/// Throws std::invalid_argument with the line and what was expected.
/// @param most_parts elements and attributes
void checkCollada(const std::string& document, std::size_t most_parts = InputLimits().xml_parts);

}  // namespace cable_variation
