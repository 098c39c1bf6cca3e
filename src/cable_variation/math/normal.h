#pragma once

namespace cable_variation {

/// The share of a standard normal variable below z.
double normalShare(double z);

/// Where the share below is `probability` in (0, 1).
double normalScore(double probability);

}  // namespace cable_variation
