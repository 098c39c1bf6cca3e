#pragma once

// Scenes around the harnesses of equilibrium/cases.h, and their equilibria, kept together.

#include <memory>
#include <string>
#include <vector>

#include <cable_variation/geometry/body/primitives.h>
#include <cable_variation/measures/measure_evaluation.h>

#include <equilibrium/cases.h>

namespace cable_variation::test {

inline Component boxPart(const std::string& name, const Eigen::Vector3d& size, const Pose& pose) {
  Component part;
  part.name = name;
  part.pose = pose;
  Visual visual;
  visual.name = name;
  visual.mesh = std::make_shared<const TriangleMesh>(boxMesh(size));
  part.visuals = {visual};
  return part;
}

/// The harness as a scene whose clips are mounted on the world.
inline Scene sceneOf(const Harness& harness) {
  Scene scene;
  scene.harness = harness;
  for (const Clip& clip : harness.clips) scene.clip_mounts.push_back({"world", clip.pose});
  return scene;
}

inline DesignVariable variable(const std::string& name, const DesignTarget& target, double nominal = 0.0) {
  DesignVariable made;
  made.name = name;
  made.target = target;
  made.nominal = nominal;
  return made;
}

inline Measure measure(Measure::Type type, const std::string& name, std::vector<std::size_t> cables = {0}) {
  Measure made;
  made.name = name;
  made.type = type;
  made.cables = std::move(cables);
  return made;
}

/// A design of the scene at rest.
struct Solved {
  Harness harness;
  Equilibrium equilibrium;
  ComponentPoses components;

  SolvedScene view() const { return {harness, equilibrium, components}; }
};

/// An accuracy of a metre: the grid stays the one it starts with, so that differences see one discrete
/// system.
inline EquilibriumOptions fixedGridOptions() {
  EquilibriumOptions options;
  options.accuracy = 1.0;
  return options;
}

inline Solved solveAt(const Scene& scene, const DesignValues& values, EquilibriumSolver& solver) {
  Solved solved{harnessAt(scene, values), {}, componentPosesAt(scene, values)};
  solved.equilibrium = solver.update(solved.harness);
  return solved;
}

inline std::vector<std::size_t> allOf(std::size_t count) {
  std::vector<std::size_t> indices(count);
  for (std::size_t i = 0; i < count; ++i) indices[i] = i;
  return indices;
}

}  // namespace cable_variation::test
