#pragma once

#include <optional>
#include <vector>

#include <cable_variation/harness/harness.h>

namespace cable_variation::hunt {

/// Where something acts on a cable, or a cable ends: a rigid section with a pose of its own.
struct DiscreteStation {
  std::size_t cable = 0;
  double arc_length = 0.0;           ///< [m]; of a sliding clip, where it starts
  std::optional<std::size_t> clip;   ///< index into Harness::clips
  std::optional<std::size_t> joint;  ///< index into Harness::joints, whose child this is
  std::size_t parent = 0;            ///< station of the joint's parent
  std::vector<std::size_t> loads;    ///< indices into Harness::loads
};

/// The cable between two neighbouring stations, in segments.
struct DiscretePiece {
  std::size_t cable = 0, left = 0, right = 0;
  std::vector<double> at;  ///< of each vertex, 0 at the left station to 1 at the right one

  std::size_t segments() const { return at.size() - 1; }
};

struct DiscreteLayout {
  std::vector<DiscreteStation> stations;
  std::vector<DiscretePiece> pieces;
  std::vector<std::size_t> clip_station;   ///< one per clip
  std::vector<std::size_t> joint_parent;   ///< one per joint
  std::vector<std::size_t> joint_child;    ///< one per joint
  std::vector<std::size_t> parents_first;  ///< all stations, a joint's parent before its child
};

/// About `segments` segments on each cable, at least `least` on each piece, shorter towards a piece's ends
/// where the bending length √(EI/(wL)) is short against the cable.
DiscreteLayout layOut(const Harness& harness, std::size_t segments, std::size_t least = 4);

/// The same with each segment cut in two.
DiscreteLayout halved(const DiscreteLayout& layout);

}  // namespace cable_variation::hunt
