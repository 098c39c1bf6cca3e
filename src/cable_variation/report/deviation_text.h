#pragma once  // internal to report/

#include <string>
#include <vector>

#include <Eigen/Core>

#include <cable_variation/scene/scene.h>

namespace cable_variation {

/// "wh_start_ry +4.8 deg, length −1.2 mm": deviations from the design, the largest shares of their tolerances
/// first, and those of less than 2 % left out; "nothing off the design" if none is left.
/// @param variables indices @param deviations one each [its unit]
std::string deviationText(const Scene& scene, const std::vector<std::size_t>& variables,
                          const Eigen::VectorXd& deviations);

}  // namespace cable_variation
