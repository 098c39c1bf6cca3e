#pragma once

#include <string>

class QImage;

namespace Ogre {
class Material;
}

namespace cable_variation_rviz {

/// An image as the only texture of an Ogre material, pixel by pixel.
class ImageTexture {
 public:
  /// @param name of the texture, which no other has
  explicit ImageTexture(std::string name);
  ~ImageTexture();
  ImageTexture(const ImageTexture&) = delete;
  ImageTexture& operator=(const ImageTexture&) = delete;

  /// @param material with a texture unit in its first pass
  void set(const QImage& image, Ogre::Material& material);

  int width() const { return width_; }    ///< [px]
  int height() const { return height_; }  ///< [px]

 private:
  std::string name_;
  int width_ = 0;
  int height_ = 0;
};

}  // namespace cable_variation_rviz
