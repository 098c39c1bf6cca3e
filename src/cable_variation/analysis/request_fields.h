#pragma once

#include <string>
#include <vector>

#include <cable_variation/scene/scene.h>

namespace cable_variation {

// What requests for envelopes and for simulations have in common. All throw std::invalid_argument that names
// the field, its value and what is expected, and NotFound for a name that is none.

[[noreturn]] void refuse(const std::string& field, double value, const std::string& expected);

/// Indices of `names`, or of all for ["*"]. @param or_else another way to ask, told where there are none
std::vector<std::size_t> variedVariables(const std::vector<std::string>& names, const Scene& scene,
                                         const std::string& or_else = "");

/// Indices of motions that can be played together.
std::vector<std::size_t> playedMotions(const std::vector<std::string>& names, const Scene& scene);

struct TimeSpan {
  double from = 0.0, to = 0.0;  ///< [s]
};
/// @param to 0: the end of the longest of `motions`, which are indices; negative: `from`
TimeSpan timesOf(const std::vector<std::size_t>& motions, double from, double to, const Scene& scene);

}  // namespace cable_variation
