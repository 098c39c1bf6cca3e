#pragma once

#include <string>
#include <vector>

#include <cable_variation/harness/clip.h>
#include <cable_variation/harness/contact.h>
#include <cable_variation/rod/cable.h>

namespace cable_variation {

/// A dead load: force and moment keep their direction in the world.
struct PointLoad {
  std::string name;
  std::size_t cable = 0;                             ///< index into Harness::cables
  double arc_length = 0.0;                           ///< [m]
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< [N], world
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< [N m], world
};

/// Two cables joined: the child's section at one of its ends sits on the
/// parent's at `parent_arc_length`.
struct Joint {
  enum class Type { fixed, pivot, hinge };
  std::string name;
  Type type = Type::fixed;
  std::size_t parent = 0;          ///< index into Harness::cables
  double parent_arc_length = 0.0;  ///< [m]
  std::size_t child = 0;           ///< index into Harness::cables
  double child_arc_length = 0.0;   ///< [m]; 0 or the child's length is usual
  Eigen::Quaterniond rotation =
      Eigen::Quaterniond::Identity();               ///< child section in the parent's section frame
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< of a hinge, in the child's section frame
};

/// A connected or unconnected set of cables, what holds them and what loads
/// them: everything an equilibrium depends on. All lengths undeformed, SI.
struct Harness {
  Eigen::Vector3d gravity = Eigen::Vector3d(0.0, 0.0, -9.81);  ///< [m/s²]
  std::vector<Cable> cables;
  std::vector<Clip> clips;
  std::vector<Joint> joints;
  std::vector<PointLoad> loads;
  std::vector<PartContact> contacts;  ///< none: cables go through parts
};

/// Throws std::invalid_argument that names the cable, clip, joint or load, the
/// value and the bound: indices, arc lengths within the cable, cables that
/// nothing holds, two clips or joints that claim the same section.
void validate(const Harness& harness);

/// Everything that validate() would refuse, a message each; empty: the harness is sound.
std::vector<std::string> faultsOf(const Harness& harness);

}  // namespace cable_variation
