#pragma once

#include <string>
#include <vector>

#include <QRectF>
#include <QSizeF>

#include <rviz_plugins/image_texture.h>

class QImage;

namespace Ogre {
class Overlay;
class OverlayContainer;
class PanelOverlayElement;
}  // namespace Ogre

namespace cable_variation_rviz {

enum class Corner { top_left, top_right, bottom_left, bottom_right };

/// An image in a corner of the 3D view, in front of the scene; hidden until shown.
class ImageOverlay {
 public:
  ImageOverlay();
  ~ImageOverlay();
  ImageOverlay(const ImageOverlay&) = delete;
  ImageOverlay& operator=(const ImageOverlay&) = delete;

  void setImage(const QImage& image);
  void setPlace(Corner corner, int margin);  ///< distance from the view's edges [px]
  void setVisible(bool visible);

  /// What the visible ones cover of a view of that size [px], from its top left corner.
  static std::vector<QRectF> covered(QSizeF view);

 private:
  void place();

  std::string name_;  ///< of all its Ogre resources
  ImageTexture texture_;
  Ogre::Overlay* overlay_;
  Ogre::PanelOverlayElement* panel_;
  Corner corner_ = Corner::top_right;
  int margin_ = 10;  ///< [px]
};

}  // namespace cable_variation_rviz
