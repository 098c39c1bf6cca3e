#pragma once

#include <optional>
#include <vector>

#include <OgreMaterial.h>
#include <QPointF>
#include <QRectF>
#include <QSizeF>

#include <rviz_plugins/displays/label_sheet.h>
#include <rviz_plugins/image_texture.h>

namespace Ogre {
class ManualObject;
class SceneManager;
class SceneNode;
}  // namespace Ogre

namespace cable_variation_rviz {

/// Labels in front of the scene, each with a line from its place, pixel by pixel.
class LabelOverlay {
 public:
  LabelOverlay(Ogre::SceneManager& scene, Ogre::SceneNode& parent);
  ~LabelOverlay();
  LabelOverlay(const LabelOverlay&) = delete;
  LabelOverlay& operator=(const LabelOverlay&) = delete;

  void setSheet(const LabelSheet& sheet);
  const LabelSheet& sheet() const { return sheet_; }

  /// @param anchors what labels are about, and `boxes` where they are, in pixels from the view's top left
  /// corner: one for each text of the sheet
  void draw(const std::vector<QPointF>& anchors, const std::vector<std::optional<QRectF>>& boxes,
            QSizeF view);

 private:
  Ogre::SceneManager& scene_;
  Ogre::SceneNode* node_;
  Ogre::ManualObject* object_;
  Ogre::MaterialPtr material_;
  ImageTexture texture_;
  LabelSheet sheet_;
  bool drawn_ = false;
};

}  // namespace cable_variation_rviz
