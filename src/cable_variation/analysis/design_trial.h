#pragma once

#include <functional>
#include <string>
#include <vector>

#include <cable_variation/analysis/design_snapshot.h>
#include <cable_variation/analysis/requests.h>
#include <cable_variation/measures/measure_evaluation.h>
#include <cable_variation/scene/design.h>

namespace cable_variation {

/// An equilibrium of a design with some variables off their nominal values.
struct DesignTrial {
  Harness harness;
  Equilibrium equilibrium;
  ComponentPoses components;  ///< all, world
};

/// Throws as requireConverged() if there is none.
/// @param moved as placesOf()
/// @param follow the solver whose shape is to be followed; nullptr: solved from nothing
DesignTrial solveTrial(const Design& design, const DesignValues& values, const ComponentPoses& moved,
                       const EquilibriumSolver* follow);

/// Where a motion has its component at a time [s], for solveTrial(). Throws NotFound for a name that is none,
/// and std::invalid_argument for a time out of the motion.
ComponentPoses placesDuring(const Design& design, const std::string& motion, double time);

/// Measures (indices) of a trial, similarity being that to the nominal shape of `evaluator`; without such a
/// shape it is not a number, and its note says so.
std::vector<MeasureValue> measureTrial(const Scene& scene, const MeasureEvaluator& evaluator,
                                       bool has_nominal, const SolvedScene& at,
                                       const std::vector<std::size_t>& measures);

/// The page on a trial as it was asked for. @param measured all measures of the scene
std::string equilibriumPage(const EquilibriumRequest& request, const DesignOrigin& origin,
                            const Design& design, const DesignValues& values, const DesignTrial& trial,
                            const std::vector<MeasureValue>& measured, const ComponentParts& parts);

}  // namespace cable_variation
