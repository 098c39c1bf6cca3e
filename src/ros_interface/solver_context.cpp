#include <ros_interface/solver_context.h>

#include <utility>

#include <ros_interface/request_status.h>

namespace cable_variation_ros {

using cable_variation::ComponentPoses;
using cable_variation::Design;
using cable_variation::DesignValues;
using cable_variation::Equilibrium;
using cable_variation::EquilibriumOptions;
using cable_variation::EquilibriumSolver;
using cable_variation::Harness;
using cable_variation::Scene;

SolverContext::SolverContext(Scene scene)
    : loaded_(std::move(scene)),
      design_{loaded_, {}},
      harness_(harnessAt(design_, {}, moved_)),
      solver_(newSolver(loaded_)),
      equilibrium_(solver_.solve(harness_)) {}

EquilibriumSolver SolverContext::newSolver(const Scene& scene) const {
  EquilibriumOptions options;
  options.accuracy = scene.accuracy;
  return EquilibriumSolver(options);
}

void SolverContext::notify() const {
  if (changed_) changed_();
}

void SolverContext::take(EquilibriumSolver solver, Design design, Harness harness, Equilibrium equilibrium) {
  requireConverged(equilibrium);
  solver_ = std::move(solver);
  design_ = std::move(design);
  harness_ = std::move(harness);
  equilibrium_ = std::move(equilibrium);
  notify();
}

void SolverContext::load(Scene scene) {
  Design design{std::move(scene), {}};
  Harness harness = harnessAt(design, {});
  EquilibriumSolver solver = newSolver(design.scene);
  Equilibrium equilibrium = solver.solve(harness);
  requireConverged(equilibrium);
  loaded_ = design.scene;
  moved_.clear();
  take(std::move(solver), std::move(design), std::move(harness), std::move(equilibrium));
}

void SolverContext::reset() {
  Design design{loaded_, {}};
  Harness harness = harnessAt(design, {}, moved_);
  EquilibriumSolver solver = newSolver(loaded_);
  Equilibrium equilibrium = solver.solve(harness);
  take(std::move(solver), std::move(design), std::move(harness), std::move(equilibrium));
}

void SolverContext::adopt(Design design) {
  Harness harness = harnessAt(design, {}, moved_);
  EquilibriumSolver solver = solver_;
  Equilibrium equilibrium = solver.update(harness);
  if (!equilibrium.converged()) equilibrium = solver.solve(harness);
  take(std::move(solver), std::move(design), std::move(harness), std::move(equilibrium));
}

void SolverContext::move(const ComponentPoses& moved) {
  Harness harness = harnessAt(design_, {}, moved);
  moved_ = moved;
  harness_ = std::move(harness);
  equilibrium_ = solver_.update(harness_);
  if (!equilibrium_.converged()) equilibrium_ = solver_.solve(harness_);
  notify();
}

SolverContext::Trial SolverContext::solve(const DesignValues& values, const ComponentPoses& moved,
                                          bool follow) const {
  Trial trial;
  trial.harness = harnessAt(design_, values, moved);
  EquilibriumSolver solver = follow ? solver_ : newSolver(design_.scene);
  trial.equilibrium = follow ? solver.update(trial.harness) : solver.solve(trial.harness);
  requireConverged(trial.equilibrium);
  return trial;
}

}  // namespace cable_variation_ros
