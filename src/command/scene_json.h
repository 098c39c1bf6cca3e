#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <cable_variation/geometry/mesh/box.h>
#include <cable_variation/measures/measure_evaluation.h>
#include <cable_variation/scene/scene.h>
#include <command/json.h>

namespace cable_variation_command {

// Fields and their names are those of the messages.

/// What all say of a measure: name, type, unit and limits.
Json measureJson(const cable_variation::Measure& measure);
/// As MeasureResult.
Json measureJson(const cable_variation::Measure& measure, const cable_variation::MeasureValue& value,
                 const cable_variation::Scene& scene);

/// As DesignVariableInfo, one per variable (index). @param values of the design, by name
Json variablesJson(const cable_variation::Scene& scene, const std::vector<std::size_t>& variables,
                   const cable_variation::DesignValues& values);

/// {low: {x, y, z}, high: {x, y, z}}
Json boxJson(const cable_variation::Box& box);

/// {file, line, message} each.
Json faultsJson(const std::vector<cable_variation::SceneFault>& faults);

}  // namespace cable_variation_command
