#pragma once  // internal to scene_file/

#include <cable_variation/scene_file/read_context.h>

namespace cable_variation {

/// Of how many standard deviations a tolerance may be.
constexpr Range kSigmaRange{0.0, 100.0, true};

/// Reads a design variable's distribution over its tolerance [lower, upper],
/// deviations from nominal in the unit of `quantity`:
///   {type: normal | truncated_normal, sigma: 3}          standard deviations at the tolerance's limits
///   {type: uniform}
///   {type: triangular, mode: 0}                          a deviation within the tolerance
///   {type: trapezoidal, plateau: 0.5}                    its share of the width
///   {type: beta, alpha: 2, beta: 5}                      between the limits
///   {type: weibull, shape: 2, scale: 1 mm}               from the lower limit up; scale may be left out
///   {type: skew_normal, shape: 4, sigma: 3}
///   {type: discrete, values: [...], probabilities: [...]}  equally probable if left out
///   {type: empirical, file: ADDRESS, unit: mm}           one deviation per line; # starts a comment
void readDistribution(const YamlCursor& cursor, const Quantity& quantity, DesignVariable& variable,
                      const ReadContext& context);

}  // namespace cable_variation
