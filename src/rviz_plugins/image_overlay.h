#pragma once

#include <string>

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

 private:
  void place();

  std::string name_;  ///< of all its Ogre resources
  Ogre::Overlay* overlay_;
  Ogre::PanelOverlayElement* panel_;
  Corner corner_ = Corner::top_right;
  int margin_ = 10;  ///< [px]
  int width_ = 0;    ///< [px]
  int height_ = 0;   ///< [px]
};

}  // namespace cable_variation_rviz
