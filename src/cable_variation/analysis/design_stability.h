#pragma once

#include <functional>
#include <string>
#include <vector>

#include <cable_variation/analysis/design_snapshot.h>
#include <cable_variation/analysis/requests.h>
#include <cable_variation/measures/measure_evaluation.h>
#include <cable_variation/scene/design.h>
#include <cable_variation/sensitivity/component_variation.h>
#include <cable_variation/sensitivity/stability_analysis.h>

namespace cable_variation {

/// What a request asks for. Throws NotFound for a name that is none, and std::invalid_argument that names the
/// field, its value and what is expected.
StabilityOptions toStabilityOptions(const StabilityRequest& request, const Scene& scene);

/// Of the design with `options.values`, to which its shape is followed where it can be. Completes
/// options.values with what is in force, and options.moved. Throws as requireConverged() if there is none.
/// @param in_force the design's own shape, which `solver` follows
/// @param prepared an evaluator of the scene, whatever its nominal shape, made of a solved one if need be
StabilityAnalysis analyseDesign(const Design& design, const ComponentPoses& moved,
                                const Equilibrium& in_force, EquilibriumSolver solver,
                                const std::function<const MeasureEvaluator&(const SolvedScene&)>& prepared,
                                StabilityOptions& options);

/// Of the components that vary by themselves.
std::vector<ComponentVariation> componentVariations(const Scene& scene, const StabilityOptions& options);

/// The page on an analysis of a snapshot's design. @param options as analyseDesign() has completed them
std::string stabilityPage(const DesignOrigin& origin, const Scene& scene, const StabilityAnalysis& analysis,
                          const StabilityOptions& options);

}  // namespace cable_variation
