#pragma once  // internal to scene_file/

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <cable_variation/scene/scene.h>
#include <cable_variation/util/input_limits.h>

namespace cable_variation {

struct LoadedMesh {
  std::shared_ptr<const TriangleMesh> mesh;
  std::string url;  ///< as RViz reads it, see ResourceFile
};

/// Loads the mesh at an address with a scale per axis; throws std::invalid_argument.
using MeshLoader = std::function<LoadedMesh(const std::string& address, const Eigen::Vector3d& scale)>;

/// Where a joint is: an angle [rad] or a displacement [m].
struct JointPosition {
  enum class Unit { none, radian, metre };
  double value = 0.0;
  Unit unit = Unit::none;  ///< that it was given in
};

/// A link of a URDF file.
struct UrdfLink {
  std::string name;
  std::string parent;              ///< the link that carries it; of the root: empty
  std::optional<LinkJoint> joint;  ///< to that link; of the root: none
  Pose pose;                       ///< in the frame of the root link, the joints where they were asked to be
  std::vector<Visual> visuals;     ///< in its own frame; of a link without any: its collision geometry
};

/// The links of a URDF file, each after the one that carries it, its joints at `joint_positions` by name and
/// else at 0; mimic joints follow.
/// What is wrong is appended to `faults`: the file itself, links that make no tree, a floating or planar
/// joint, a position out of the joint's limits or of no movable joint, a mesh,
/// a primitive's size; implausible values go to `warnings`.
std::vector<UrdfLink> readUrdfLinks(const std::string& path,
                                    const std::map<std::string, JointPosition>& joint_positions,
                                    const MeshLoader& load_mesh, std::vector<std::string>& faults,
                                    std::vector<std::string>& warnings, const InputLimits& limits = {});

/// The visuals of every link of a URDF file (of a link without any: its
/// collision geometry), in the frame of the root link. Arguments as readUrdfLinks() has them.
std::vector<Visual> readUrdf(const std::string& path,
                             const std::map<std::string, JointPosition>& joint_positions,
                             const MeshLoader& load_mesh, std::vector<std::string>& faults,
                             std::vector<std::string>& warnings, const InputLimits& limits = {});

}  // namespace cable_variation
