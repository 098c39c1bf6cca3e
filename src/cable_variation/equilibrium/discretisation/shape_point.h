#pragma once

#include <cable_variation/equilibrium/discretisation/end_motion.h>
#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/equilibrium/sensitivity.h>
#include <cable_variation/harness/harness_rate.h>
#include <cable_variation/rod/profile.h>

namespace cable_variation {

/// A section from its pose, and the force (world) and moment (section frame) there:
/// strains by the material law, φ'' by differentiating φ' = R Γ with the force balance.
ShapePoint shapePoint(double arc_length, const Pose& pose, const Vector6d& section_force,
                      const RodProperties& rod, const Eigen::Vector3d& gravity);

/// How properties at one arc length change when the cable does, and when another arc length is looked at.
RodProperties propertyRate(const RodProperties& rod, double arc_length, const CableRate& cable,
                           double arc_length_rate);

/// First-order change of `point`, from that of its motion (displacement in the world, rotation vector in the
/// section frame) and of its section force and moment (both in the world).
ShapePointRate shapePointRate(const ShapePoint& point, const Vector6d& motion, const Vector6d& force_rate,
                              double arc_length_rate, const RodProperties& rod, const RodProperties& rod_rate,
                              const Eigen::Vector3d& gravity);

}  // namespace cable_variation
