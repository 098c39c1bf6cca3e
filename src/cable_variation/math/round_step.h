#pragma once

namespace cable_variation {

/// The smallest of 1, 2, 5, 10 times a power of ten that is not below `least` > 0: the step of a scale.
double roundStep(double least);

}  // namespace cable_variation
