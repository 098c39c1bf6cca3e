#pragma once

#include <string>
#include <utility>
#include <vector>

#include <cable_variation/analysis/design_snapshot.h>
#include <cable_variation/analysis/simulation_task.h>

namespace cable_variation {

/// What decides each bit of a simulation's samples, by name: build and machine, scene and files, options.
using SimulationIdentity = std::vector<std::pair<std::string, std::string>>;

/// All but which samples are asked for, where these do not depend on their number.
SimulationIdentity identityOf(const SimulationTask& task, const DesignSnapshot& snapshot);

/// What differs, "seed: 2 here, 1 there"; empty: nothing.
/// @param first,second whose they are, "in a.blocks"
std::string differenceOf(const SimulationIdentity& one, const std::string& first,
                         const SimulationIdentity& other, const std::string& second);

/// As lines NAME=VALUE, and back. Throws std::invalid_argument: a line that is none.
std::string toText(const SimulationIdentity& identity);
SimulationIdentity identityFrom(const std::string& text);

/// A request as such lines, and back, so that it can be made again from a file.
/// Throws std::invalid_argument that names what is none.
SimulationIdentity requestLines(const SimulationRequest& request);
SimulationRequest requestFrom(const SimulationIdentity& lines);

}  // namespace cable_variation
