#pragma once

#include <string>
#include <vector>

#include <cable_variation/Status.h>

#include <cable_variation/report/review.h>
#include <ros_interface/context/solver_context.h>
#include <ros_interface/node/output_directory.h>

namespace cable_variation_ros {

/// A review of the scene as this node has it, with the date of now and the scene's warnings; the analyses are
/// still to be put in. What is referred to must outlive it.
cable_variation::Review startReview(const std::string& title, const DesignOrigin& origin,
                                    const cable_variation::Scene& scene,
                                    const cable_variation::DesignValues& values,
                                    const cable_variation::SolvedScene& solved);

/// "engine_run and brake" of some motions.
std::string motionText(const cable_variation::Scene& scene, const std::vector<std::size_t>& motions);

/// Writes a file of an answer that has all else: one that cannot be written makes its status IO_ERROR, whose
/// message tells of each fault once.
/// @return the path; empty: it could not be written
std::string writeBeside(const OutputDirectory& output, const std::string& name, const std::string& extension,
                        const std::string& contents, cable_variation::Status& status);

}  // namespace cable_variation_ros
