#pragma once

#include <string>
#include <vector>

#include <cable_variation/CheckPath.h>

#include <cable_variation/path/path_check.h>

namespace cable_variation_ros {

/// What a request for a path means in a design.
struct PathRequest {
  cable_variation::ComponentPath path;
  double step = 0.0;          ///< [m]
  bool over_motions = false;  ///< recorded ones, else poses of a component or clip
  std::string about;          ///< of what goes where, for a person
  std::vector<std::string> warnings;
};

/// @param harness of the design, its clips where they are now
/// @param moved components in force that are not where the scene has them, placesOf()
/// @param on_tf those alone that tf has elsewhere
/// Throws std::invalid_argument and cable_variation::NotFound that name the field, the value and what was
/// expected.
PathRequest toPath(const cable_variation::CheckPathRequest& request, const cable_variation::Design& design,
                   const cable_variation::Harness& harness, const cable_variation::ComponentPoses& moved,
                   const cable_variation::ComponentPoses& on_tf);

}  // namespace cable_variation_ros
