#pragma once  // internal to report/

#include <string>
#include <vector>

#include <cable_variation/report/picture/scene_picture.h>

namespace cable_variation {

/// A name at a place of the world.
struct SceneLabel {
  std::string text;
  Eigen::Vector3d place;  ///< [m]
  bool bad = false;       ///< where a limit is broken: red
};

/// The picture of a scene with names beside their places, as far as there is room, and a scale; an SVG
/// element that holds the picture itself.
std::string sceneFigure(const ScenePicture& picture, const std::vector<SceneLabel>& labels);

}  // namespace cable_variation
