#pragma once

#include <string>

#include <cable_variation/analysis/output_directory.h>

namespace cable_variation {

/// Writes a file of an answer that has all else: one that cannot be written is told in `error`, each fault
/// once. A page comes before the table beside it: it keeps those of another analysis (keepOtherReport()).
/// @return the path; empty: it could not be written
std::string writeBeside(const OutputDirectory& output, const std::string& name, const std::string& extension,
                        const std::string& contents, std::string& error);

}  // namespace cable_variation
