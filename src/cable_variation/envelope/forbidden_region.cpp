#include <cable_variation/envelope/forbidden_region.h>

#include <algorithm>
#include <stdexcept>

#include <cable_variation/geometry/body/body_distance.h>

namespace cable_variation {

ForbiddenRegion forbiddenRegion(const Scene& scene, const Envelope& envelope, const std::string& frame) {
  const auto seen =
      std::find_if(envelope.frames.begin(), envelope.frames.end(),
                   [&](const EnvelopeFrame& candidate) { return candidate.component == frame; });
  if (seen == envelope.frames.end()) {
    throw std::invalid_argument("forbidden region: the envelope is not seen from '" + frame + "'");
  }
  ForbiddenRegion region;
  region.frame = frame;
  region.inflation = envelope.inflation;
  region.probability = envelope.probability;
  region.shapes = envelope.containment.shapes;
  region.protrusion = envelope.containment.largest_protrusion;
  region.pieces.reserve(seen->pieces.size());
  for (const EnvelopePiece& piece : seen->pieces) {
    const EnvelopePhase& phase = envelope.phases.at(piece.phase);
    region.pieces.push_back({scene.harness.cables.at(piece.cable).name, piece.start, piece.end, phase.start,
                             phase.end, piece.branch, piece.body});
  }
  return region;
}

RegionClearance checkRegion(const ForbiddenRegion& region, const DistancePart& part, const Pose& pose) {
  std::vector<const RoundedHull*> bodies;
  bodies.reserve(region.pieces.size());
  for (const ForbiddenRegion::Piece& piece : region.pieces) bodies.push_back(&piece.body);
  const auto pair = distance(bodies, part, pose);
  if (!pair) throw std::invalid_argument("forbidden region: no pieces, expected at least one");
  RegionClearance clearance{pair->distance, pair->body, pair->on_body, pair->on_other, {}, pair->undecided};
  if (pair->distance <= 0.0) clearance.colliding = enteringTriangles(bodies, part, pose);
  return clearance;
}

}  // namespace cable_variation
