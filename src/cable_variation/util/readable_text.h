#pragma once

#include <string>

namespace cable_variation {

/// A message that may quote all of a file, for a person: control characters and bytes that are no UTF-8 as
/// \xNN, so that it stays one line and nothing cuts it off, and what is long enough to hide the rest left out
/// of its middle.
std::string readableText(const std::string& message);

}  // namespace cable_variation
