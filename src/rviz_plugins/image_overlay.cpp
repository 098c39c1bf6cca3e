#include <rviz_plugins/image_overlay.h>

#include <atomic>
#include <set>

#include <OgreMaterialManager.h>
#include <OgrePass.h>
#include <OgreTechnique.h>
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

std::set<const ImageOverlay*>& all() {
  static std::set<const ImageOverlay*> overlays;  // used by RViz's thread alone
  return overlays;
}

const Ogre::String& group() { return Ogre::ResourceGroupManager::DEFAULT_RESOURCE_GROUP_NAME; }

}  // namespace

ImageOverlay::ImageOverlay() : name_(uniqueName()), texture_(name_) {
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
  all().insert(this);
}

ImageOverlay::~ImageOverlay() {
  all().erase(this);
  Ogre::OverlayManager& manager = Ogre::OverlayManager::getSingleton();
  overlay_->remove2D(panel_);
  manager.destroyOverlayElement(panel_);
  manager.destroy(overlay_);
  Ogre::MaterialManager::getSingleton().remove(name_, group());
}

void ImageOverlay::setImage(const QImage& image) {
  texture_.set(image, *Ogre::MaterialManager::getSingleton().getByName(name_, group()));
  panel_->setDimensions(static_cast<float>(texture_.width()), static_cast<float>(texture_.height()));
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
  panel_->setPosition(static_cast<float>(right ? -texture_.width() - margin_ : margin_),
                      static_cast<float>(bottom ? -texture_.height() - margin_ : margin_));
}

std::vector<QRectF> ImageOverlay::covered(QSizeF view) {
  std::vector<QRectF> boxes;
  for (const ImageOverlay* each : all()) {
    if (!each->overlay_->isVisible()) continue;
    QPointF corner(each->panel_->getLeft(), each->panel_->getTop());
    if (each->panel_->getHorizontalAlignment() == Ogre::GHA_RIGHT) corner.rx() += view.width();
    if (each->panel_->getVerticalAlignment() == Ogre::GVA_BOTTOM) corner.ry() += view.height();
    boxes.emplace_back(corner, QSizeF(each->texture_.width(), each->texture_.height()));
  }
  return boxes;
}

void ImageOverlay::setVisible(bool visible) {
  if (visible) {
    overlay_->show();
  } else {
    overlay_->hide();
  }
}

}  // namespace cable_variation_rviz
