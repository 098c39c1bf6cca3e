#pragma once  // internal to report/

#include <cstddef>
#include <limits>
#include <vector>

#include <cable_variation/measures/measure_evaluation.h>

namespace cable_variation {

/// One section of a solved cable, as it goes into a file.
struct CablePoint {
  double arc_length = 0.0;  ///< undeformed [m]
  Pose pose;                ///< section frame in the world, x the director normal to the section
  double radius = 0.0;      ///< [m]
  double curvature = 0.0;   ///< of the centreline [1/m]
  /// Of the part s+ on the part s- [N], world; not a number where it is not known.
  Eigen::Vector3d force = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  Eigen::Vector3d moment = force;  ///< likewise [N m], world
};

/// Throws std::invalid_argument: a step that is not above 0, or so short that the cable would have more than
/// a million points.
void checkStep(const Cable& cable, double step);

/// Along a cable (index), no further apart than `step` [m]: at all sections that were solved, and at equal
/// steps between two of them. Where a clip, a joint or a load acts, two points share the arc length: force
/// and moment jump there. Of a cable that touches a part they are known at the sections solved only.
/// Throws as checkStep().
std::vector<CablePoint> cablePoints(const SolvedScene& solved, std::size_t cable, double step);

}  // namespace cable_variation
