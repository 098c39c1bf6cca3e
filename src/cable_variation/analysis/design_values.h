#pragma once

#include <string>
#include <vector>

#include <cable_variation/scene/scene.h>

namespace cable_variation {

/// The design values of a request. Throws NotFound for a name that
/// is no design variable, and std::invalid_argument for lists of different
/// lengths, a name given twice, a value that is not finite, or one beyond 10 km or a hundred turns.
DesignValues toDesignValues(const Scene& scene, const std::vector<std::string>& variables,
                            const std::vector<double>& values);

}  // namespace cable_variation
