#pragma once  // internal to sensitivity/

#include <string>
#include <vector>

#include <cable_variation/sensitivity/stability_analysis.h>

namespace cable_variation {

/// One for each measure whose solved limits (`low_high`) are off the straight lines that its derivatives make
/// of them, by a quarter or more of what all tolerances do to it: its spread and worst case to first order
/// are rough then. The variable for which that is most is named, with the figures in the units that people
/// use.
std::vector<std::string> curvatureWarnings(const Scene& scene, const StabilityAnalysis& analysis);

}  // namespace cable_variation
