#pragma once

#include <string>
#include <vector>

namespace cable_variation {

/// Design variables whose tolerance is no box: their deviations together stay
/// within a ball (three translations), a disc (two translations) or a cone (two
/// rotations, the angle between the axis and its nominal to first order).
struct ToleranceRegion {
  enum class Shape { ball, disc, cone };
  std::string name;
  Shape shape = Shape::ball;
  std::vector<std::size_t> variables;  ///< indices into Scene::design_variables
  double radius = 0.0;                 ///< [m], cone: half the opening angle [rad]
  bool uniform = true;                 ///< spread evenly over the region; else normal, see `sigma`
  double sigma = 3.0;                  ///< normal: the radius is this many standard deviations of each
                                       ///< coordinate, cut off at the radius
};

/// Correlation between two design variables, none of them in a region.
struct Correlation {
  std::size_t first = 0, second = 0;  ///< indices into Scene::design_variables
  double coefficient = 0.0;           ///< in (-1, 1)
};

}  // namespace cable_variation
