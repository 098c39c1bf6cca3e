#include <rviz_plugins/image_overlay.h>

#include <atomic>
#include <cstring>

#include <OgreHardwarePixelBuffer.h>
#include <OgreMaterialManager.h>
#include <OgrePass.h>
#include <OgreTechnique.h>
#include <OgreTextureManager.h>
#include <OgreTextureUnitState.h>
#include <Overlay/OgreOverlay.h>
#include <Overlay/OgreOverlayContainer.h>
#include <Overlay/OgreOverlayManager.h>
#include <Overlay/OgrePanelOverlayElement.h>

#include <QImage>

namespace cable_variation_rviz {

namespace {

std::string uniqueName() {
  static std::atomic<unsigned> count{0};
  return "cable_variation/image_overlay/" + std::to_string(count++);
}

const Ogre::String& group() { return Ogre::ResourceGroupManager::DEFAULT_RESOURCE_GROUP_NAME; }

}  // namespace

ImageOverlay::ImageOverlay() : name_(uniqueName()) {
  Ogre::OverlayManager& manager = Ogre::OverlayManager::getSingleton();
  const Ogre::MaterialPtr material = Ogre::MaterialManager::getSingleton().create(name_, group());
  Ogre::Pass* pass = material->getTechnique(0)->getPass(0);
  pass->setLightingEnabled(false);
  pass->setDepthCheckEnabled(false);
  pass->setDepthWriteEnabled(false);
  pass->setSceneBlending(Ogre::SBT_TRANSPARENT_ALPHA);
  pass->createTextureUnitState();

  overlay_ = manager.create(name_);
  panel_ = static_cast<Ogre::PanelOverlayElement*>(manager.createOverlayElement("Panel", name_));
  panel_->setMetricsMode(Ogre::GMM_PIXELS);
  panel_->setMaterialName(name_);
  overlay_->add2D(panel_);
}

ImageOverlay::~ImageOverlay() {
  Ogre::OverlayManager& manager = Ogre::OverlayManager::getSingleton();
  overlay_->remove2D(panel_);
  manager.destroyOverlayElement(panel_);
  manager.destroy(overlay_);
  Ogre::MaterialManager::getSingleton().remove(name_, group());
  if (width_ > 0) Ogre::TextureManager::getSingleton().remove(name_, group());
}

void ImageOverlay::setImage(const QImage& image) {
  const QImage pixels = image.convertToFormat(QImage::Format_ARGB32);
  Ogre::TextureUnitState* unit = Ogre::MaterialManager::getSingleton()
                                     .getByName(name_, group())
                                     ->getTechnique(0)
                                     ->getPass(0)
                                     ->getTextureUnitState(0);
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
  panel_->setDimensions(static_cast<float>(width_), static_cast<float>(height_));
  place();
}

void ImageOverlay::setPlace(Corner corner, int margin) {
  corner_ = corner;
  margin_ = margin;
  place();
}

void ImageOverlay::place() {
  const bool right = corner_ == Corner::top_right || corner_ == Corner::bottom_right;
  const bool bottom = corner_ == Corner::bottom_left || corner_ == Corner::bottom_right;
  panel_->setHorizontalAlignment(right ? Ogre::GHA_RIGHT : Ogre::GHA_LEFT);
  panel_->setVerticalAlignment(bottom ? Ogre::GVA_BOTTOM : Ogre::GVA_TOP);
  panel_->setPosition(static_cast<float>(right ? -width_ - margin_ : margin_),
                      static_cast<float>(bottom ? -height_ - margin_ : margin_));
}

void ImageOverlay::setVisible(bool visible) {
  if (visible) {
    overlay_->show();
  } else {
    overlay_->hide();
  }
}

}  // namespace cable_variation_rviz
