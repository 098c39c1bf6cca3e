#pragma once

#include <vector>

#include <Eigen/Core>
#include <OgreMaterial.h>

#include <rviz_plugins/displays/surface.h>

namespace Ogre {
class ManualObject;
class SceneManager;
class SceneNode;
}  // namespace Ogre

namespace cable_variation_rviz {

/// A surface with a colour at each vertex in the scene. Its vertex buffer stays and is written anew when the
/// surface changes.
class SurfaceObject {
 public:
  SurfaceObject(Ogre::SceneManager& scene, Ogre::SceneNode& parent);
  ~SurfaceObject();
  SurfaceObject(const SurfaceObject&) = delete;
  SurfaceObject& operator=(const SurfaceObject&) = delete;

  /// @param surface finite; without triangles nothing is drawn
  /// @param colors r g b a, one for each vertex
  void set(const Surface& surface, const std::vector<Eigen::Vector4f>& colors,
           const Ogre::MaterialPtr& material);
  /// Drawn after everything else of the scene, as what is translucent has to be.
  void drawLast();

 private:
  Ogre::SceneManager& scene_;
  Ogre::SceneNode* node_;
  Ogre::ManualObject* object_;
  std::size_t vertices_ = 0;
};

}  // namespace cable_variation_rviz
