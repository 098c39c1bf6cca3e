#pragma once  // internal to path/

#include <cstddef>
#include <vector>

#include <cable_variation/path/component_path.h>

namespace cable_variation {

/// When to look at the cables along a path: at its ends, where clips open and close, and so often that no
/// clip and no component that the path moves goes further than `step` [m] in between, turning counted with a
/// lever of 50 mm.
/// @param also times to be among them if they are within the path [s]
/// @param most as many at most; more are std::invalid_argument
std::vector<double> pathTimes(const Design& design, const ComponentPath& path, double step,
                              const std::vector<double>& also, std::size_t most);

}  // namespace cable_variation
