#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include <cable_variation/harness/clip.h>
#include <cable_variation/util/enum_rows.h>

namespace cable_variation {

/// The kinds of clips, each a name for what a ClipConstraint holds: the solver knows the constraint alone.
/// A new one is an enumerator, a row of clip_preset.cpp and one of ros_interface/markers/clip_markers.cpp
/// with how it is drawn, and does not compile without; one that takes something new, a row of
/// scene_file/clip_reader.cpp too.
enum class ClipPreset {
  fixed,
  rolling,
  pivot,
  hinge,
  sliding,
  sliding_rolling,
  eyelet,
  guide,
  plane,
  grommet,
  general,  ///< as its constraint says
  free      ///< no clip: a cable's end, or another place of it, to which a load may be given
};

/// What a clip may be told beside its place and its mount: members of ClipParameters.
enum class ClipParameter { axis, normal, rolls, stiffness, translation, rotation, slides };

/// Those that its preset does not take keep their defaults.
struct ClipParameters {
  Axis axis = Axis::x;    ///< that the cable turns about
  Axis normal = Axis::x;  ///< of the plane it lies on
  bool rolls = false;     ///< about x
  GrommetStiffness stiffness;
  std::array<ClipFreedom, 3> translation, rotation;
  bool slides = false;
};

struct ClipPresetTraits {
  ClipPreset preset;
  const char* name;                                        ///< Clip::type, as in a scene file
  bool mounted;                                            ///< on a component; else it is where its cable is
  std::array<std::optional<ClipParameter>, 3> parameters;  ///< in the order they are read
  ClipConstraint (*constraint)(const ClipParameters&);
};

/// One row per preset, in their order.
using ClipPresetTable = std::array<ClipPresetTraits, enumeratorCount<ClipPreset>()>;
const ClipPresetTable& clipPresets();

/// The row of a preset. Throws std::out_of_range for a number that is none.
const ClipPresetTraits& traitsOf(ClipPreset preset);

/// Whether a clip can be added of which no more is told than its place: it is mounted, and takes nothing that
/// it could not do without.
bool canBeAdded(const ClipPresetTraits& traits);

/// The preset that a clip's type names; any other name, as harnesses made by a program may have, is general.
ClipPreset presetOf(const Clip& clip);

/// Whether a clip is on a component; else it is a free place of its cable.
bool isMounted(const Clip& clip);

}  // namespace cable_variation
