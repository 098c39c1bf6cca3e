#pragma once

#include <string>
#include <string_view>

namespace cable_variation {

/// SHA-256 of some bytes (FIPS 180-4) as 64 hexadecimal digits: what `sha256sum` says of a file of them.
std::string sha256(std::string_view bytes);

}  // namespace cable_variation
