#include <rviz_plugins/image_texture.h>

#include <cstring>
#include <utility>

#include <OgreHardwarePixelBuffer.h>
#include <OgreMaterial.h>
#include <OgrePass.h>
#include <OgreTechnique.h>
#include <OgreTextureManager.h>
#include <OgreTextureUnitState.h>

#include <QImage>

namespace cable_variation_rviz {

namespace {

const Ogre::String& group() { return Ogre::ResourceGroupManager::DEFAULT_RESOURCE_GROUP_NAME; }

}  // namespace

ImageTexture::ImageTexture(std::string name) : name_(std::move(name)) {}

ImageTexture::~ImageTexture() {
  if (width_ > 0) Ogre::TextureManager::getSingleton().remove(name_, group());
}

void ImageTexture::set(const QImage& image, Ogre::Material& material) {
  const QImage pixels = image.convertToFormat(QImage::Format_ARGB32);
  Ogre::TextureUnitState* unit = material.getTechnique(0)->getPass(0)->getTextureUnitState(0);
  if (pixels.width() != width_ || pixels.height() != height_) {
    unit->setBlank();
    if (width_ > 0) Ogre::TextureManager::getSingleton().remove(name_, group());
    width_ = pixels.width();
    height_ = pixels.height();
    Ogre::TextureManager::getSingleton().createManual(name_, group(), Ogre::TEX_TYPE_2D, width_, height_, 0,
                                                      Ogre::PF_A8R8G8B8, Ogre::TU_DYNAMIC_WRITE_ONLY);
    unit->setTextureName(name_);
    unit->setTextureFiltering(Ogre::TFO_NONE);
  }
  const Ogre::TexturePtr texture = Ogre::TextureManager::getSingleton().getByName(name_, group());
  const Ogre::HardwarePixelBufferSharedPtr buffer = texture->getBuffer();
  buffer->lock(Ogre::HardwareBuffer::HBL_DISCARD);
  const Ogre::PixelBox& box = buffer->getCurrentLock();
  const std::size_t row = Ogre::PixelUtil::getMemorySize(width_, 1, 1, box.format);
  const std::size_t pitch = Ogre::PixelUtil::getMemorySize(box.rowPitch, 1, 1, box.format);
  auto* target = static_cast<unsigned char*>(static_cast<void*>(box.data));
  for (int y = 0; y < height_; ++y) std::memcpy(target + y * pitch, pixels.constScanLine(y), row);
  buffer->unlock();
}

}  // namespace cable_variation_rviz
