#include <cable_variation/equilibrium/discretisation/held_piece.h>

#include <optional>

namespace cable_variation {

std::vector<HeldPiece> heldPieces(const Harness& harness, const Topology& topology,
                                  const Configuration& configuration) {
  std::vector<HeldPiece> pieces;
  for (std::size_t c = 0; c < harness.cables.size(); ++c) {
    std::optional<std::size_t> start;
    double distance = 0.0;
    Eigen::Vector3d before = Eigen::Vector3d::Zero();
    for (const std::size_t index : topology.cable_stations[c]) {
      const Station& station = topology.stations[index];
      if (!station.clip) continue;
      const ClipConstraint& constraint = harness.clips[*station.clip].constraint;
      if (!constraint.locksPosition()) continue;
      const Eigen::Vector3d& here = configuration.stations[index].pose.position;
      if (start) distance += (here - before).norm();
      before = here;
      if (constraint.slides) continue;
      if (start) {
        const double length = station.arc_length - topology.stations[*start].arc_length;
        pieces.push_back({c, *start, index, distance, length});
      }
      start = index;
      distance = 0.0;
    }
  }
  return pieces;
}

}  // namespace cable_variation
