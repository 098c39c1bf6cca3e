#pragma once

#include <utility>
#include <vector>

#include <Eigen/Core>

namespace cable_variation {

/// First-order motion of a frame, in the world, per unit of a variable.
struct FrameRate {
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();  ///< of its origin [m]
  Eigen::Vector3d rotation = Eigen::Vector3d::Zero();     ///< rotation vector [rad]
};

/// First-order change of a cable's properties, per unit of a variable.
struct CableRate {
  std::size_t cable = 0;  ///< index into Harness::cables
  double length = 0.0;    ///< [m]
  double knots =
      0.0;  ///< sections and rest curvature move along the cable: by `knots` times their arc length
  Eigen::Matrix<double, 6, 1> stiffness =
      Eigen::Matrix<double, 6, 1>::Zero();  ///< EA GA_y GA_z GJ EI_y EI_z, each relative to itself
  double mass = 0.0;                        ///< relative
  double rest_curvature = 0.0;              ///< relative
  double radius = 0.0;                      ///< relative
};

/// How a harness changes with one variable, to first order: only what changes is listed.
/// First: an index into the harness's clips, contacts, joints or loads.
struct HarnessRate {
  std::vector<std::pair<std::size_t, FrameRate>> clip_frames;
  std::vector<std::pair<std::size_t, FrameRate>> part_frames;      ///< of PartContact::pose
  std::vector<std::pair<std::size_t, double>> clip_arc_lengths;    ///< [m]
  std::vector<std::pair<std::size_t, double>> parent_arc_lengths;  ///< of joints [m]
  std::vector<std::pair<std::size_t, double>> child_arc_lengths;   ///< of joints [m]
  std::vector<std::pair<std::size_t, double>> load_arc_lengths;    ///< [m]
  std::vector<CableRate> cables;
};

struct Harness;

/// The harness after a change of the variable by `step`: frames of clips and parts turn about their origins,
/// everything else changes in proportion.
Harness changed(const Harness& harness, const HarnessRate& rate, double step);

}  // namespace cable_variation
