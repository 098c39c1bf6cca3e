#pragma once  // internal to equilibrium/

#include <vector>

#include <cable_variation/equilibrium/discretisation/configuration.h>

namespace cable_variation {

/// A piece of cable between two neighbouring sections whose roll is held, by a clip or a joint: its ends
/// cannot let go of a turn.
struct TwistPiece {
  std::size_t cable = 0;
  std::size_t left = 0, right = 0;  ///< stations
  double twist = 0.0;               ///< about the tangent, beyond the rest torsion [rad]
  /// Whole turns more than asked for by Cable::twist, shared out by length; without that, than none.
  int surplus = 0;
};

/// All of a harness's, in `configuration`.
std::vector<TwistPiece> twistPieces(const Harness& harness, const Topology& topology,
                                    const Configuration& configuration);

/// The same centrelines with the surplus turns taken out, evenly along each piece.
Configuration withoutSurplus(const Harness& harness, const Topology& topology, const Grid& grid,
                             const Configuration& configuration, const std::vector<TwistPiece>& pieces);

/// The twist of a cable from its first held roll to its last, beyond the rest torsion [rad].
double twistOf(const std::vector<TwistPiece>& pieces, std::size_t cable);

}  // namespace cable_variation
