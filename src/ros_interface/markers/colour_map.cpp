#include <ros_interface/markers/colour_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace cable_variation_ros {

namespace {

/// Every 15th entry of the published table of 256; cubics through them give the others.
constexpr std::array<std::array<double, 3>, 18> kViridis = {{{0.267004, 0.004874, 0.329415},
                                                             {0.281924, 0.089666, 0.412415},
                                                             {0.280255, 0.165693, 0.476498},
                                                             {0.263663, 0.237631, 0.518762},
                                                             {0.237441, 0.305202, 0.541921},
                                                             {0.208623, 0.367752, 0.552675},
                                                             {0.182256, 0.426184, 0.557120},
                                                             {0.159194, 0.482237, 0.558073},
                                                             {0.137770, 0.537492, 0.554906},
                                                             {0.121148, 0.592739, 0.544641},
                                                             {0.128087, 0.647749, 0.523491},
                                                             {0.180653, 0.701402, 0.488189},
                                                             {0.274149, 0.751988, 0.436601},
                                                             {0.395174, 0.797475, 0.367757},
                                                             {0.535621, 0.835785, 0.281908},
                                                             {0.688944, 0.865448, 0.182725},
                                                             {0.845561, 0.887322, 0.099702},
                                                             {0.993248, 0.906157, 0.143936}}};

Eigen::Vector3d control(int i) {
  constexpr int last = static_cast<int>(kViridis.size()) - 1;
  // Beyond the ends as the parabola through the last three goes on.
  if (i < 0) return 3.0 * control(0) - 3.0 * control(1) + control(2);
  if (i > last) return 3.0 * control(last) - 3.0 * control(last - 1) + control(last - 2);
  return Eigen::Vector3d(kViridis[i][0], kViridis[i][1], kViridis[i][2]);
}

}  // namespace

Eigen::Vector3d viridis(double share) {
  if (std::isnan(share)) return Eigen::Vector3d::Constant(0.5);
  constexpr int pieces = static_cast<int>(kViridis.size()) - 1;
  const double place = std::clamp(share, 0.0, 1.0) * pieces;
  const int i = std::min(static_cast<int>(place), pieces - 1);
  const double f = place - i;
  // Catmull-Rom
  const Eigen::Vector3d a = control(i - 1), b = control(i), c = control(i + 1), d = control(i + 2);
  const Eigen::Vector3d color =
      b + 0.5 * f * (c - a + f * (2.0 * a - 5.0 * b + 4.0 * c - d + f * (3.0 * (b - c) + d - a)));
  return color.cwiseMax(0.0).cwiseMin(1.0);
}

ColourScale::ColourScale(double minimum, double maximum) : minimum_(minimum), maximum_(maximum) {
  if (!std::isfinite(minimum) || !std::isfinite(maximum) || minimum > maximum) {
    throw std::invalid_argument("colour scale from " + std::to_string(minimum) + " to " +
                                std::to_string(maximum) + ": its bounds must be finite and in order");
  }
}

Eigen::Vector3d ColourScale::operator()(double value) const {
  if (std::isnan(value)) return viridis(value);
  const double range = maximum_ - minimum_;
  return viridis(range > 0.0 ? (value - minimum_) / range : 0.0);
}

std_msgs::ColorRGBA ColourScale::rgba(double value) const {
  const Eigen::Vector3f color = (*this)(value).cast<float>();
  std_msgs::ColorRGBA message;
  message.r = color[0];
  message.g = color[1];
  message.b = color[2];
  message.a = 1.0F;
  return message;
}

}  // namespace cable_variation_ros
