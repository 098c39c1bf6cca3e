#pragma once

#include <string>

#include <cable_variation/Status.h>

#include <cable_variation/analysis/output_directory.h>

namespace cable_variation_ros {

/// Writes a file of an answer that has all else: one that cannot be written makes its status IO_ERROR, whose
/// message tells of each fault once.
/// @return the path; empty: it could not be written
std::string writeBeside(const cable_variation::OutputDirectory& output, const std::string& name,
                        const std::string& extension, const std::string& contents,
                        cable_variation::Status& status);

}  // namespace cable_variation_ros
