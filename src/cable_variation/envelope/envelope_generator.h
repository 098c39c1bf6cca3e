#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <cable_variation/envelope/envelope.h>
#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/scene/scene.h>
#include <cable_variation/tolerances/varied_design.h>
#include <cable_variation/tracking/material_stretch.h>
#include <cable_variation/tracking/shape_follower.h>
#include <cable_variation/util/progress.h>

namespace cable_variation {

/// With a motion nothing else need vary.
struct EnvelopeOptions : VariedDesign {
  std::vector<std::size_t> cables;  ///< indices; empty: all
  double from = 0.0;                ///< of the motions [s]
  double to = -1.0;                 ///< likewise; negative: the end of the longest
  std::vector<std::string> frames;  ///< components to see the envelope from, beside the world
  std::vector<MaterialCut> cuts;    ///< where pieces are to end besides, see ClosestSolved::cuts()
  /// Share of production whose whole shape is to be held, in (0, 1), at rest; 0: all that the tolerances
  /// allow.
  double probability = 0.0;
  double margin = 1e-4;               ///< protrusion to stay below before inflation [m]
  bool conservative = true;           ///< inflate by twice what the last random shapes stuck out, or may
  std::size_t verification = 2000;    ///< independent random shapes for containment; 0 with a probability: as
                                      ///< many as it takes
  std::size_t tightness = 0;          ///< shapes for tightness; 0: not computed
  double voxel = 0.0;                 ///< for tightness [m]; 0: a sixth of the thinnest cable's radius
  std::size_t largest_solves = 3000;  ///< per phase; ending there is warned of
  /// That it may take, other than for its surface [B]: phases of a motion get longer where that is needed,
  /// and what cannot be done within it is refused.
  double memory_limit = 2e9;
  std::uint64_t seed = 1;   ///< of the random shapes
  std::size_t threads = 0;  ///< 0: as many as there are cores
};

/// Throws std::invalid_argument: nothing varies, an index out of range, a motion that is empty, margins or
/// counts that are none, a probability over a motion or without inflation, planFor(), what would take more
/// memory than allowed, with what it would take; as requireConverged() does: no equilibrium at the design
/// itself; NotConverged: of more of production than may be outside; Cancelled.
/// @param solver the design's shape to follow, best solved; else it is solved from nothing
/// @param observer told of the stages "shapes", "containment" and "tightness"; asked for an end: Cancelled
/// @param witness told of every harness solved that the envelope is to hold: all, for containment and
/// tightness too; with a probability of those for verification
Envelope generateEnvelope(const Scene& scene, const EnvelopeOptions& options, const EquilibriumSolver& solver,
                          const ProgressObserver& observer = {}, const SolvedWitness& witness = {});

/// A harness of the design within its tolerances, solved again: what an EnvelopeSample stands for.
struct SolvedSample {
  Harness harness;
  Equilibrium equilibrium;
  ComponentPoses components;  ///< of all, world
};
SolvedSample solveSample(const Scene& scene, const EnvelopeOptions& options, const Envelope& envelope,
                         const EnvelopeSample& sample, const EquilibriumSolver& solver);

}  // namespace cable_variation
