#pragma once

#include <Eigen/Core>

namespace cable_variation {

/// Force and moment on a section, or its displacement and rotation; and what relates them.
using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;
/// The same of a span's ends: the left one, the right one, the arc lengths of the left and the right station.
using Vector14d = Eigen::Matrix<double, 14, 1>;
using Matrix14d = Eigen::Matrix<double, 14, 14>;

}  // namespace cable_variation
