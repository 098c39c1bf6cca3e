#pragma once

#include <cable_variation/SetDesign.h>

#include <cable_variation/scene/design.h>

namespace cable_variation_ros {

/// A design with the edits of a request. Throws cable_variation::NotFound and std::invalid_argument that name
/// the thing, the value and what was expected.
cable_variation::Design edited(cable_variation::Design design,
                               const cable_variation::SetDesignRequest& request);

}  // namespace cable_variation_ros
