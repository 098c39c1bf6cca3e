#pragma once

#include <string>

#include <cable_variation/scene/scene.h>

namespace cable_variation {

/// A scene as it is being designed: edited, with new nominal values.
struct Design {
  Scene scene;
  DesignValues shifted;  ///< nominal values other than 0 of variables that move clips, components, locators
  ComponentPoses shifts =
      {};  ///< of components that an edit has put elsewhere, each in its frame as the scene has it
};

/// Where components are that are not where the scene has them: as `moved` tells (tf, a motion), and shifted
/// by the design on top of that; what rides on one comes along. The other functions take this as their
/// `moved`.
ComponentPoses placesOf(const Design& design, const ComponentPoses& moved);

/// The harness of the design with some variables at `values`, the others nominal
/// (as harnessAt, which says what it throws).
Harness harnessAt(const Design& design, const DesignValues& values, const ComponentPoses& moved = {});

/// The same design with the edits of components' places in the poses and motions of its scene, and no shifts:
/// for what plays motions by itself. Motions and tf of the scene as it was do not fit it.
Design withShiftsInScene(Design design);

/// A scene of its own that is what the design is: its nominal values and edits are in the poses, lengths and
/// sections, and no variable is off its nominal value.
Scene sceneOf(const Design& design);

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

/// The pose of a component in its parent's frame. Where tf or a motion has it elsewhere, it is off that place
/// by as much; what rides on it comes along.
void setComponentPose(Design& design, const std::string& component, const Pose& pose);

/// One more clip, with a name that no other has. `clip.type` names a preset that is mounted and takes no
/// parameter but by choice, which sets clip.constraint; `mount` says where clip.pose is.
void addClip(Design& design, Clip clip, const ClipMount& mount);

/// Takes away a clip that addClip() has added, of which nothing else can be. Throws for any that a design
/// variable or a measure is of.
void removeClip(Design& design, const std::string& clip);

/// Puts the clip frame there in the world, with components where placesOf() has them.
void placeClip(Design& design, const std::string& clip, const Pose& pose, const ComponentPoses& moved);

/// Likewise a component's frame. @param moved as placesOf() takes it
void placeComponent(Design& design, const std::string& component, const Pose& pose,
                    const ComponentPoses& moved);

/// Shifts the clip by `translation` [m] and turns it by the rotation vector
/// `rotation` [rad], both along its own axes.
void moveClip(Design& design, const std::string& clip, const Eigen::Vector3d& translation,
              const Eigen::Vector3d& rotation);

}  // namespace cable_variation
