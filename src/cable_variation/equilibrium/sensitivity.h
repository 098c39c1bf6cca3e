#pragma once

#include <vector>

#include <Eigen/Core>

#include <cable_variation/harness/harness_rate.h>

namespace cable_variation {

/// First-order change of a ShapePoint per unit of a variable. The point keeps
/// its share of the piece of cable between two stations (ends, clips, joints,
/// loads, steps), so its arc length changes with theirs.
struct ShapePointRate {
  double arc_length = 0.0;                             ///< [m]
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< [m], world
  Eigen::Vector3d rotation = Eigen::Vector3d::Zero();  ///< rotation vector of the section [rad], world
  Eigen::Vector3d tangent = Eigen::Vector3d::Zero();   ///< of ShapePoint::tangent
  Eigen::Vector3d second_derivative = Eigen::Vector3d::Zero();  ///< of ShapePoint::second_derivative [1/m]
  Eigen::Vector3d force = Eigen::Vector3d::Zero();              ///< of ShapePoint::force [N]
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();             ///< of ShapePoint::moment [N m]
  Eigen::Vector3d strain = Eigen::Vector3d::Zero();             ///< of ShapePoint::strain
  Eigen::Vector3d curvature = Eigen::Vector3d::Zero();          ///< of ShapePoint::curvature [1/m]
};

/// First-order change of a Reaction per unit of a variable.
struct ReactionRate {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< [N], world
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< [N m], world
  double arc_length = 0.0;                           ///< [m]
};

/// First-order change of what a part presses a cable with, per unit of a variable, places that press being
/// held; where they press in one point, as that moves.
struct ContactForceRate {
  std::size_t cable = 0;    ///< index into Harness::cables
  std::size_t contact = 0;  ///< index into Harness::contacts
  double arc_length = 0.0;  ///< [m]
  double force = 0.0;       ///< of the force's amount [N]
};

/// First-order change of an Equilibrium per unit of a variable.
struct EquilibriumRate {
  std::vector<std::vector<ShapePointRate>> shapes;  ///< per cable and point, as Equilibrium::shapes
  std::vector<ReactionRate> clip_reactions;         ///< per clip
  double elastic_energy = 0.0;                      ///< [J]
  std::vector<ContactForceRate> contacts;           ///< one per place that presses
};

}  // namespace cable_variation
