#pragma once

#include <string>

#include <cable_variation/scene/scene_reader.h>

namespace cable_variation {

/// The local path of a package:// or file:// address. Throws
/// std::invalid_argument: another scheme, no such package, no such file.
std::string localPath(const std::string& address, const PackageFinder& find_package);

}  // namespace cable_variation
