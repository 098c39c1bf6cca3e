#pragma once

#include <envelope/envelope_scenes.h>

namespace cable_variation::test {

/// The nominal design of a scene, solved, with the solver that stands at it.
struct SolvedDesign {
  Harness harness;
  ComponentPoses components;
  EquilibriumSolver solver;
  Equilibrium equilibrium;

  explicit SolvedDesign(const Scene& scene)
      : harness(harnessAt(scene, {})),
        components(componentPosesAt(scene, {})),
        solver(solverOf(scene)),
        equilibrium(solver.solve(harness)) {}
  MeasureEvaluator evaluator(const Scene& scene) const { return {scene, {harness, equilibrium, components}}; }
};

}  // namespace cable_variation::test
