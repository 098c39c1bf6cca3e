#pragma once

#include <string>

namespace cable_variation {

/// Writes a file that is there complete or not at all: to a temporary name beside it, then renamed. Throws
/// std::runtime_error that names the file and what the system says.
void writeFile(const std::string& path, const std::string& contents);

}  // namespace cable_variation
