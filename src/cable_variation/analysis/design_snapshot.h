#pragma once

#include <string>
#include <vector>

#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/measures/component_parts.h>
#include <cable_variation/scene/design.h>
#include <cable_variation/tolerances/varied_design.h>

namespace cable_variation {

/// Where a design comes from, for a report on it.
struct DesignOrigin {
  std::string source_hash;           ///< SHA-256 of the scene's file when it was loaded; empty: not known
  std::vector<std::string> changes;  ///< what edits have changed since, see designChanges()
  std::string author;                ///< of reports; empty: not told
};

/// All that an analysis needs of a design that was solved: a copy, for work on another thread.
struct DesignSnapshot {
  Design design;
  ComponentPoses moved;      ///< components that are not where the scene has them
  EquilibriumSolver solver;  ///< follows the design's shape, if there is one
  ComponentParts parts;      ///< as far as they have been prepared
  std::size_t design_number = 0;
  DesignOrigin origin;
  ComponentPoses on_tf = {};  ///< of `moved`, those alone that tf has elsewhere
};

/// To the accuracy that a scene asks for; it has no shape to follow.
EquilibriumSolver newSolver(const Scene& scene);

/// The shape of a harness, solved from nothing. One without a cable, as of a scene of components alone, has
/// none, and its message says why; otherwise as EquilibriumSolver::solve().
Equilibrium shapeFromNothing(EquilibriumSolver& solver, const Harness& harness);

/// The snapshot for an analysis of `design`: over motions its edits of components' places are in its scene.
DesignSnapshot snapshotFor(const VariedDesign& design, DesignSnapshot snapshot);

/// A snapshot's solver at `design`, from the snapshot's shape where that can be followed. Throws as
/// requireConverged() if there is no equilibrium.
/// @param other it is not the snapshot's own design
EquilibriumSolver solverAt(const DesignSnapshot& snapshot, const VariedDesign& design, bool other);

}  // namespace cable_variation
