#pragma once  // internal to equilibrium/

#include <vector>

#include <cable_variation/equilibrium/discretisation/configuration.h>

namespace cable_variation {

/// A piece of cable between two neighbouring clips that hold its position at a given arc length. Clips that
/// hold the position and let the cable slide may lie between.
struct HeldPiece {
  std::size_t cable = 0;
  std::size_t first = 0, last = 0;  ///< stations at its ends
  double distance = 0.0;            ///< from clip to clip, straight [m]
  double length = 0.0;              ///< undeformed [m]
};

/// All of a harness's, where its stations are in `configuration`.
std::vector<HeldPiece> heldPieces(const Harness& harness, const Topology& topology,
                                  const Configuration& configuration);

}  // namespace cable_variation
