#pragma once  // internal to scene_file/

#include <cable_variation/math/pose.h>
#include <cable_variation/scene_file/yaml_cursor.h>

namespace cable_variation {

/// Keys that give an orientation, for YamlCursor::checkKeys.
const std::vector<std::string>& orientationKeys();

/// The orientation given by the map at `cursor` in one of the ways
///   rpy: [roll, pitch, yaw]   about the fixed axes x, y, z in that order (as URDF)
///   quaternion: [w, x, y, z]  of norm 1 within 1e-3
///   x_axis: [x, y, z]         the tangent; with y_axis its side, else turned there
///                             the shortest way (about z from -x); then roll about it
/// Identity if none is there, or after a fault.
Eigen::Quaterniond readOrientation(const YamlCursor& cursor);

/// {position, orientation in one of the ways above}
Pose readPose(const YamlCursor& cursor);

/// x, y, z or a direction. As readDirection().
Eigen::Vector3d readAxisOrDirection(const YamlCursor& cursor);

/// A direction, normalised. A fault if its length is 0. The x axis after a fault.
Eigen::Vector3d readDirection(const YamlCursor& cursor);

}  // namespace cable_variation
