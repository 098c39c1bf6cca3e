#pragma once

#include <string>
#include <vector>

#include <cable_variation/harness/harness.h>
#include <hunt/draw.h>

namespace cable_variation::hunt {

/// A round bundle, hose or wire of 0.5 to 8 mm radius that bends as measured bundles do: up to a hundred
/// times softer than a solid of the same material.
Section bundleSection(Draw& draw);
/// A metal wire of `radius` [m].
Section wireSection(Draw& draw, double radius);
/// A section by its stiffness, round.
Section stiffnessSection(double EA, double EI, double GJ, double mass_per_length, double radius);

Cable makeCable(const std::string& name, double length, const Section& section);

/// A smooth random framed curve of the cable's length, from the origin along x, whose chords are shortened as
/// by slack: where a person might have put the cable's clips.
class Route {
 public:
  /// @param bend mean turn of the tangent over the length [rad]  @param tightness chord against arc, at most
  /// 1
  Route(Draw& draw, double length, double bend, double tightness);
  /// Same, from `start`.
  Route(Draw& draw, double length, double bend, double tightness, const Pose& start);
  Pose at(double arc_length) const;

 private:
  double length_, tightness_;
  std::vector<Pose> poses_;
};

/// `pose` turned at random by up to `angle` [rad].
Pose disturbed(Draw& draw, const Pose& pose, double angle);

Clip makeClip(const std::string& name, std::size_t cable, double arc_length, const std::string& type,
              const ClipConstraint& constraint, const Pose& pose);

/// A clip that cables have along their way: fixed, rolling, pivot, hinge, sliding (if wanted), eyelet, guide,
/// plane, grommet, or a general one with springs of the cable's own order of stiffness.
Clip randomClip(Draw& draw, const std::string& name, std::size_t cable, double arc_length, const Cable& of,
                const Pose& pose, bool may_slide);

/// Down, or in a random direction, or none.
Eigen::Vector3d randomGravity(Draw& draw);

}  // namespace cable_variation::hunt
