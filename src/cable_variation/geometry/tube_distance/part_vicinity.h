#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <cable_variation/geometry/mesh/triangle_tree.h>
#include <cable_variation/geometry/tube_distance/distance.h>

namespace cable_variation {

/// The triangles of a part that are near a cable: all that its distance can depend on while it does not move
/// far. Immutable; may be shared by threads.
class PartVicinity {
 public:
  /// @param pose of the part, world @param reach triangles up to this from the cable's surface [m]
  PartVicinity(const Centreline& cable, const DistancePart& part, const Pose& pose, double reach);

  /// No triangle that is missing is nearer to the surface of `cable`, the part being at `pose`, than this
  /// [m]: the reach, less how far the cable has gone, seen from the part, and grown. Negative: not known,
  /// which is so for a cable with another number of pieces.
  double completeWithin(const Centreline& cable, const Pose& pose) const;

  /// Whether no part of the cable was inside a solid of the part: then it is still outside while no triangle
  /// has come near, that is as far as completeWithin() tells, if none is here.
  bool outside() const { return outside_; }

  /// Of these triangles; none if there are none.
  const std::optional<TriangleTree>& tree() const { return tree_; }
  /// The place among all of the part's (DistancePart::Impl::tree) of each of these.
  const std::vector<std::uint32_t>& places() const { return places_; }

 private:
  struct Piece {
    std::array<Eigen::Vector3d, 6> control;  // in the part's frame [m]
    double start_radius = 0.0, end_radius = 0.0;
  };
  static Piece pieceOf(const Centreline::Piece& piece, const Pose& to_part);

  double reach_;
  bool outside_ = true;
  std::vector<Piece> pieces_;
  std::optional<TriangleTree> tree_;
  std::vector<std::uint32_t> places_;
};

}  // namespace cable_variation
