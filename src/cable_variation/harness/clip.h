#pragma once

#include <array>
#include <string>

#include <cable_variation/math/pose.h>

namespace cable_variation {

/// One degree of freedom of a cable's cross-section relative to a clip.
struct ClipFreedom {
  enum class Kind { locked, free, sprung };
  Kind kind = Kind::locked;
  double stiffness = 0.0;  ///< of a sprung one: [N/m] along an axis, [N m/rad] about one

  static ClipFreedom locked() { return {}; }
  static ClipFreedom free() { return {Kind::free, 0.0}; }
  static ClipFreedom sprung(double stiffness) { return {Kind::sprung, stiffness}; }
};

/// What a clip holds: three translations along and three rotations about the
/// axes of its frame (x along the cable), and whether the cable slides through.
/// Rotations are the components of the rotation vector log(R_clipᵀ R_section).
struct ClipConstraint {
  std::array<ClipFreedom, 3> translation;
  std::array<ClipFreedom, 3> rotation;
  bool slides = false;  ///< the arc length held is an unknown of the equilibrium

  bool holdsPosition() const;  ///< a translation at least is not free
  bool holdsRotation() const;  ///< a rotation at least is not free
  bool locksPosition() const;  ///< all translations are locked
};

enum class Axis { x, y, z };

/// Stiffness of a rubber grommet.
struct GrommetStiffness {
  double axial = 0.0;      ///< along x [N/m]
  double radial = 0.0;     ///< along y and z [N/m]
  double torsional = 0.0;  ///< about x [N m/rad]
  double conical = 0.0;    ///< about y and z [N m/rad]
};

/// The named presets, each built from the general form (method.md, section 2).
ClipConstraint fixedClip();                    ///< connector, clamp
ClipConstraint rollingClip();                  ///< taped P-clip: roll about x free
ClipConstraint pivotClip();                    ///< ball joint: rotations free
ClipConstraint hingeClip(Axis axis);           ///< rotation about one clip axis free
ClipConstraint slidingClip();                  ///< tight channel: fixed's locks, the cable slides
ClipConstraint slidingRollingClip();           ///< tube clip: slides and rolls
ClipConstraint eyeletClip();                   ///< loose ring: slides, rotations free
ClipConstraint guideClip(bool rolls = false);  ///< slot along x: the section moves in it
ClipConstraint planeClip(Axis normal);         ///< lies on a surface: one translation locked
ClipConstraint grommetClip(const GrommetStiffness& stiffness, bool slides = false);
ClipConstraint freeClip();  ///< a free end, to which a load may be given

/// A clip on a cable.
struct Clip {
  std::string name;
  std::string type;         ///< the preset's name as in a scene file, or "general"
  std::size_t cable = 0;    ///< index into Harness::cables
  double arc_length = 0.0;  ///< s_c [m]; of a sliding clip, where the search for it starts
  ClipConstraint constraint;
  Pose pose;             ///< the clip frame, x along the cable, in the world
  bool attached = true;  ///< closed; an open one holds nothing, the cable has no station there
};

}  // namespace cable_variation
