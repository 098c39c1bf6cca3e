#pragma once

#include <limits>
#include <string>

#include <Eigen/Core>

#include <cable_variation/math/pose.h>

namespace cable_variation {

/// How a link of a robot is joined to the link that carries it, as URDF has it.
struct LinkJoint {
  enum class Type { fixed, revolute, prismatic };

  std::string name;
  Type type = Type::fixed;
  Pose origin;  ///< in the frame of the link that carries it, the joint at 0
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  ///< unit vector in the link's frame: about or along it
  std::string driver;       ///< the joint whose position counts: this one, or the one that it mimics
  double multiplier = 1.0;  ///< this joint's position = multiplier * the driver's + offset
  double offset = 0.0;      ///< [rad or m]
  double position = 0.0;    ///< of this joint, in the scene [rad or m]
  double lower = -std::numeric_limits<double>::infinity();  ///< limits of this joint [rad or m]
  double upper = std::numeric_limits<double>::infinity();
};

/// The joint's position [rad or m], its driver at `driver_position` [rad or m].
double jointPosition(const LinkJoint& joint, double driver_position);

/// What a joint at `position` [rad or m] does to its link.
Pose jointMotion(const LinkJoint& joint, double position);

/// The link in the frame of the one that carries it, its driver at `driver_position` [rad or m].
Pose linkPose(const LinkJoint& joint, double driver_position);

}  // namespace cable_variation
