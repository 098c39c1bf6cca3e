#pragma once  // internal to geometry/

#include <limits>
#include <optional>
#include <vector>

#include <cable_variation/geometry/tube_distance/distance_part.h>
#include <cable_variation/geometry/tube_distance/tube_section.h>

namespace cable_variation {

/// The place of a centreline that is deepest below the surface of a solid, its radius included.
struct Deepest {
  double value = 0.0;  ///< minus the depth, minus the radius [m]
  std::size_t section = 0;
  double u = 0.0;
  DistancePart::Impl::Nearest nearest;  ///< of the boundary
  DistancePart::Impl::Winding winding;  ///< of the part's open shell: there, or if that is clear at another
                                        ///< place inside, at that one
  double runner_up = std::numeric_limits<double>::infinity();
};

/// None if no place lies inside the solid. To 1e-9 m. Runner-up: the surface is as near in another direction,
/// or another place, more than two radii away, is as deep, both to `margin` [m].
std::optional<Deepest> deepest(const DistancePart::Impl& part, std::uint32_t solid,
                               const std::vector<TubeSection>& sections, double margin);

}  // namespace cable_variation
