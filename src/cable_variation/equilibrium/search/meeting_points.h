#pragma once  // internal to equilibrium/

#include <optional>
#include <vector>

#include <cable_variation/equilibrium/discretisation/configuration.h>

namespace cable_variation {

/// Where to start with the places at which cables leave others: per station, set for a joint's station on its
/// parent [m, world] when it lies on a way from one clip to another. The points are those of strings that
/// pull on each other in proportion to their stretch, then moved until no piece of cable is drawn out beyond
/// its length. `configuration` says where the clips are and at which arc lengths they hold.
std::vector<std::optional<Eigen::Vector3d>> meetingPoints(const Harness& harness, const Topology& topology,
                                                          const Configuration& configuration);

}  // namespace cable_variation
