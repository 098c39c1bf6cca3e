#pragma once

#include <string>
#include <string_view>

namespace cable_variation {

/// Bytes as text (RFC 4648, section 4): for files within files.
std::string base64(std::string_view bytes);

}  // namespace cable_variation
