#pragma once

// Harnesses that several tests share, and ways to build others in a line.

#include <cmath>
#include <string>

#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/math/so3.h>

namespace cable_variation::test {

inline Pose poseAt(double x, double y, double z, const Eigen::Vector3d& rotation = Eigen::Vector3d::Zero()) {
  return {Eigen::Vector3d(x, y, z), so3::exp(rotation)};
}

inline Cable uniformCable(double length, const Section& section, const std::string& name = "cable") {
  Cable cable;
  cable.name = name;
  cable.length = length;
  cable.sections = {{0.0, section}};
  return cable;
}

/// A round section by its stiffness.
inline Section roundSection(double EA, double GA, double GJ, double EI, double mass_per_length = 0.0,
                            double radius = 1e-3) {
  return {EA, GA, GA, GJ, EI, EI, mass_per_length, radius};
}

inline Clip clipOn(std::size_t cable, const std::string& name, double arc_length,
                   const ClipConstraint& constraint, const Pose& pose = {}) {
  return {name, "general", cable, arc_length, constraint, pose};
}

/// One cable, clamped at its start in the origin along x.
inline Harness cantilever(const Cable& cable, const Eigen::Vector3d& gravity = {0.0, 0.0, -9.81}) {
  Harness harness;
  harness.gravity = gravity;
  harness.cables = {cable};
  harness.clips = {clipOn(0, "A", 0.0, fixedClip())};
  return harness;
}

/// One cable, clamped at its start in the origin along x, and at its end in `end`.
inline Harness clamped(const Cable& cable, const Pose& end,
                       const Eigen::Vector3d& gravity = {0.0, 0.0, -9.81}) {
  Harness harness = cantilever(cable, gravity);
  harness.clips.push_back(clipOn(0, "B", cable.length, fixedClip(), end));
  return harness;
}

inline PointLoad loadAt(std::size_t cable, double arc_length, const Eigen::Vector3d& force,
                        const Eigen::Vector3d& moment = Eigen::Vector3d::Zero()) {
  return {"load", cable, arc_length, force, moment};
}

inline Section hoseOfCaseH() { return hoseSection(0.012, 0.009, {6e6, 0.45, 1200.0}); }
inline Section strandOfCaseW() { return solidSection(0.004, {1e8, 0.25, 2000.0}); }

/// A clamp whose tangent is `direction`, turned least from the x axis, then about the tangent.
inline Pose clampAlong(const Eigen::Vector3d& position, const Eigen::Vector3d& direction, double roll) {
  return {position, so3::smallestRotation(Eigen::Vector3d::UnitX(), direction.normalized()) *
                        so3::exp({roll, 0.0, 0.0})};
}

/// The hose of data/reference/case_H.csv, where shear and stretch matter.
inline Harness caseH() {
  return clamped(uniformCable(0.330, hoseOfCaseH(), "hose"),
                 clampAlong({0.20, 0.06, 0.08}, {0.2, 0.1, 1.0}, 20.0 * M_PI / 180.0));
}

/// The strand of data/reference/case_W.csv, which has two saddles beside its stable equilibrium.
inline Harness caseW() {
  return clamped(uniformCable(0.312, strandOfCaseW(), "strand"),
                 clampAlong({0.22, 0.08, -0.05}, {1.0, 0.3, 0.2}, 0.0));
}

/// The rotation, of length at most π, between two orientations [rad].
inline double angleBetween(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  return so3::log(a.conjugate() * b).norm();
}

inline Equilibrium solve(const Harness& harness, double accuracy = 1e-6) {
  EquilibriumOptions options;
  options.accuracy = accuracy;
  return EquilibriumSolver(options).solve(harness);
}

}  // namespace cable_variation::test
