#pragma once

// Scenes whose envelopes have closed forms, and ways to look at an envelope.

#include <algorithm>
#include <cmath>
#include <limits>

#include <cable_variation/envelope/envelope_generator.h>

#include <measures/solved_scene.h>

namespace cable_variation::test {

/// Stiff enough for a free cable without weight to move as a rigid body.
inline Section rodOfRadius(double radius) { return roundSection(1e4, 4e3, 0.1, 0.1, 0.0, radius); }

/// A straight cable along x from the origin, without weight, held at its start only: it follows its clip.
inline Scene freeRod(double length, double radius) {
  Scene scene = sceneOf(cantilever(uniformCable(length, rodOfRadius(radius)), Eigen::Vector3d::Zero()));
  scene.accuracy = 1e-5;
  return scene;
}

inline void addVariable(Scene& scene, const std::string& name, const DesignTarget& target, double lower,
                        double upper) {
  DesignVariable made = variable(name, target);
  made.lower = lower;
  made.upper = upper;
  made.distribution_parameters["sigma"] = 3.0;
  scene.design_variables.push_back(made);
}

/// A strip between two clamps, bowed to one side; when one clamp is turned far enough it snaps to the other.
inline Scene bowedStrip() {
  Section strip = roundSection(1e4, 4e3, 1.0, 1.0, 0.0, 0.002);
  strip.EI_z = 0.01;
  Cable cable = uniformCable(0.30, strip);
  cable.via = {{0.13, 0.08, 0.0}};
  Scene scene = sceneOf(clamped(cable, poseAt(0.26, 0.0, 0.0), Eigen::Vector3d::Zero()));
  addVariable(scene, "turn", ClipRotation{0, Axis::z}, -80.0 * M_PI / 180.0, 5.0 * M_PI / 180.0);
  return scene;
}

inline EquilibriumSolver solverOf(const Scene& scene) {
  EquilibriumOptions options;
  options.accuracy = scene.accuracy;
  return EquilibriumSolver(options);
}

/// The signed distance of a point from the union of the pieces, or a bound of it inside [m].
inline double outside(const std::vector<EnvelopePiece>& pieces, const Eigen::Vector3d& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const EnvelopePiece& piece : pieces) {
    least = std::min(least, piece.body.core.closest(point).distance - piece.body.radius);
  }
  return least;
}

}  // namespace cable_variation::test
