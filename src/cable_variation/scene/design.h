#pragma once

#include <string>

#include <cable_variation/scene/scene.h>

namespace cable_variation {

/// A scene as it is being designed: edited, with new nominal values.
struct Design {
  Scene scene;
  DesignValues shifted;  ///< nominal values other than 0 of variables that move clips, components, locators
};

/// The harness of the design with some variables at `values`, the others nominal
/// (as harnessAt, which says what it throws).
Harness harnessAt(const Design& design, const DesignValues& values, const ComponentPoses& moved = {});

// Edits. Each throws std::invalid_argument for an unknown name, and for a value, named
// with its bound, that leaves the physical; the design is then as it was.

/// The nominal value of a design variable, in its SI unit.
void setNominal(Design& design, const std::string& variable, double value);

/// The cable's undeformed length [m]; clips and joints follow as they do for a
/// design variable of the length.
void setCableLength(Design& design, const std::string& cable, double length);

/// Where along its cable a clip holds [m].
void setClipArcLength(Design& design, const std::string& clip, double arc_length);

/// The clip frame in its component's frame.
void setClipPose(Design& design, const std::string& clip, const Pose& pose);

/// Opens a clip, or closes it at the arc length that it has. Throws as well if a cable would be held by no
/// attached clip, or two clips by one section.
void setAttached(Design& design, const std::string& clip, bool attached);

/// Shifts the clip by `translation` [m] and turns it by the rotation vector
/// `rotation` [rad], both along its own axes.
void moveClip(Design& design, const std::string& clip, const Eigen::Vector3d& translation,
              const Eigen::Vector3d& rotation);

}  // namespace cable_variation
