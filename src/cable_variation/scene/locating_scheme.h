#pragma once

#include <array>
#include <utility>
#include <vector>

#include <cable_variation/harness/harness_rate.h>
#include <cable_variation/math/pose.h>

namespace cable_variation {

/// A 3-2-1 locating scheme: points [m] and unit directions in the part's frame.
using Locators = std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>;

/// Throws std::invalid_argument unless there are six locators that fix the part;
/// a singular scheme is named with its condition number, lengths being taken
/// in units of the points' spread.
void checkLocatingScheme(const Locators& locators);

/// The rigid motion T of the part, in its frame, with nᵢ·(T pᵢ − pᵢ) = δᵢ
/// exactly (Newton from the linearised solution). Throws std::invalid_argument:
/// checkLocatingScheme(), or deviations [m] that no rigid motion near the
/// identity satisfies.
Pose locatedPose(const Locators& locators, const std::array<double, 6>& deviations);

/// How the part's frame at `located` (in its nominal frame) moves, to first order, per metre
/// of each locator's deviation. Throws std::invalid_argument where that is not unique.
std::array<FrameRate, 6> locatedRates(const Locators& locators, const Pose& located);

}  // namespace cable_variation
