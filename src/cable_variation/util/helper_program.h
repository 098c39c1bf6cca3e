#pragma once

#include <string>

namespace cable_variation {

/// The path of a program that comes with this library: in cable_variation/ beside the library's file, as
/// catkin puts the nodes, beside the program that runs, or where it was built. Throws FileError that
/// lists where it was looked for.
std::string helperProgram(const std::string& name);

/// Where such programs are built.
const char* helperBuildDirectory();

}  // namespace cable_variation
