#pragma once

namespace cable_variation_ros {

/// What colours the cables.
enum class VariationFigure { six_sigma, range };

}  // namespace cable_variation_ros
