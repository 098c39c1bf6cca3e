#pragma once

#include <string>

#include <Eigen/Core>

#include <cable_variation/math/pose.h>
#include <cable_variation/util/quantity.h>

namespace cable_variation {

// Values as a person would write them in a scene file, to 1e-9 m, 1e-10 rad or 12 digits.

/// A value [SI] in the unit and the quotes of the text that was there: 0.315 for "312 mm" is "315 mm".
/// Throws std::invalid_argument of readQuantity() for a text that is no such quantity.
std::string valueLike(const std::string& text, double value, const Quantity& quantity);

std::string lengthText(double metres);                            ///< "315 mm"
std::string positionText(const Eigen::Vector3d& position);        ///< "[1 mm, 0, -2.5 mm]"
std::string rotationText(const Eigen::Quaterniond& orientation);  ///< "rpy: [0, 0, 90 deg]"
/// "{position: [...], rpy: [...]}", without the angles if there are none.
std::string poseText(const Pose& pose);

}  // namespace cable_variation
