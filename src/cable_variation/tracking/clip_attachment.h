#pragma once

#include <vector>

#include <cable_variation/tracking/clip_follower.h>

namespace cable_variation {

/// How a section lies to the clip that is to take hold of it.
struct AttachmentGap {
  double arc_length = 0.0;  ///< of the section [m]
  double distance = 0.0;    ///< from where the clip would have it, along the axes that it holds [m]
  double angle = 0.0;       ///< likewise, about the axes that it holds [rad]
};

/// The gap between a clip and the section of `shape` at `arc_length` [m].
AttachmentGap gapAt(const Clip& clip, const CableShape& shape, double arc_length);

/// The section of `shape` that is closest to the clip, by AttachmentGap::distance, further than `margin` [m]
/// from both ends of the cable.
AttachmentGap closestSection(const Clip& clip, const CableShape& shape, double margin = 0.0);

/// What became of a shape when clips were opened and closed.
struct AttachedClips {
  FollowedClips followed;        ///< the equilibrium, and the jump while closing clips pulled the cables in
  double distance = 0.0;         ///< that the centrelines went, at most [m]
  std::size_t cable = 0;         ///< that went furthest
  double arc_length = 0.0;       ///< there [m]
  double energy_before = 0.0;    ///< total, with the clips as they were [J]
  double energy_released = 0.0;  ///< by which letting go lowered it, springs of opened clips included [J]
};

/// Opens and closes clips. A clip that closes first takes the section where it is, which changes nothing,
/// then draws it to where it is to be, which is followed as followClips() does; clips that are opened let go
/// at once, and the cables come to rest from the shape that they had.
/// @param solver has the equilibrium `before` of `from`; afterwards that of `to`, if there is one
/// @param to differs from `from` in Clip::attached, and Clip::arc_length of those that close
/// Throws std::invalid_argument as validate().
AttachedClips followAttachment(EquilibriumSolver& solver, const Harness& from, const Equilibrium& before,
                               const Harness& to);

}  // namespace cable_variation
