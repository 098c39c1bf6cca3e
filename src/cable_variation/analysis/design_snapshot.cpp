#include <cable_variation/analysis/design_snapshot.h>

#include <utility>

#include <cable_variation/equilibrium/require_converged.h>

namespace cable_variation {

EquilibriumSolver newSolver(const Scene& scene) {
  EquilibriumOptions options;
  options.accuracy = scene.accuracy;
  return EquilibriumSolver(options);
}

DesignSnapshot snapshotFor(const VariedDesign& design, DesignSnapshot snapshot) {
  if (!design.motions.empty()) snapshot.design = withShiftsInScene(std::move(snapshot.design));
  return snapshot;
}

EquilibriumSolver solverAt(const DesignSnapshot& snapshot, const VariedDesign& design, bool other) {
  EquilibriumSolver solver = snapshot.solver;
  if (!other) return solver;
  const Harness harness = harnessAt(snapshot.design.scene, design.values, design.moved);
  Equilibrium equilibrium = solver.update(harness);
  if (!equilibrium.converged()) equilibrium = solver.solve(harness);
  requireConverged(equilibrium);
  return solver;
}

Equilibrium shapeFromNothing(EquilibriumSolver& solver, const Harness& harness) {
  if (!harness.cables.empty()) return solver.solve(harness);
  Equilibrium none;
  none.message = "the scene has no cable";
  return none;
}

}  // namespace cable_variation
