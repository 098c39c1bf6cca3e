#pragma once

#include <string>

namespace cable_variation {

/// "2024-03-01 12:34:56 UTC"
std::string utcNow();

}  // namespace cable_variation
