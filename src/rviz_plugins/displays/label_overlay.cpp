#include <rviz_plugins/displays/label_overlay.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <OgreManualObject.h>
#include <OgreMaterialManager.h>
#include <OgrePass.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <OgreTechnique.h>

#include <rviz_plugins/displays/surface_material.h>

namespace cable_variation_rviz {

namespace {

constexpr double kLine = 1.2, kRim = 3.2;  // width of a leader, and with its rim [px]
constexpr unsigned char kBeforeOverlays = Ogre::RENDER_QUEUE_OVERLAY - 1;

/// Quads in pixels of the view with pixels of the sheet.
class Quads {
 public:
  Quads(Ogre::ManualObject& object, QSizeF view, QSizeF sheet)
      : object_(object), view_(view), sheet_(sheet) {}

  /// Pixel by pixel.
  void add(const QRectF& box, const QRect& texels) {
    const QPointF at(std::round(box.left()), std::round(box.top()));
    const QRectF to(at, QSizeF(texels.size())), from(texels);
    add({to.topLeft(), to.bottomLeft(), to.bottomRight(), to.topRight()},
        {from.topLeft(), from.bottomLeft(), from.bottomRight(), from.topRight()});
  }

  void addLine(QPointF from, QPointF to, double width, const QRect& color) {
    const QPointF along = to - from;
    const double length = std::hypot(along.x(), along.y());
    if (!(length > 0.0)) return;
    const QPointF half = QPointF(-along.y(), along.x()) * (0.5 * width / length);
    const QPointF texel = QRectF(color).center();
    add({from - half, from + half, to + half, to - half}, {texel, texel, texel, texel});
  }

 private:
  using Corners = std::array<QPointF, 4>;

  void add(const Corners& places, const Corners& texels) {
    for (std::size_t k = 0; k < places.size(); ++k) {
      object_.position(static_cast<float>(2.0 * places[k].x() / view_.width() - 1.0),
                       static_cast<float>(1.0 - 2.0 * places[k].y() / view_.height()), 0.0F);
      object_.textureCoord(static_cast<float>(texels[k].x() / sheet_.width()),
                           static_cast<float>(texels[k].y() / sheet_.height()));
    }
    object_.quad(count_, count_ + 1, count_ + 2, count_ + 3);
    count_ += 4;
  }

  Ogre::ManualObject& object_;
  QSizeF view_, sheet_;
  std::uint32_t count_ = 0;
};

QPointF nearestIn(const QRectF& box, QPointF to) {
  return {std::clamp(to.x(), box.left(), box.right()), std::clamp(to.y(), box.top(), box.bottom())};
}

Ogre::MaterialPtr sheetMaterial() {
  Ogre::MaterialPtr material = Ogre::MaterialManager::getSingleton().create(
      uniqueName("labels"), Ogre::ResourceGroupManager::DEFAULT_RESOURCE_GROUP_NAME);
  Ogre::Pass* pass = material->getTechnique(0)->getPass(0);
  pass->setLightingEnabled(false);
  pass->setDepthCheckEnabled(false);
  pass->setDepthWriteEnabled(false);
  pass->setCullingMode(Ogre::CULL_NONE);
  pass->setSceneBlending(Ogre::SBT_TRANSPARENT_ALPHA);
  pass->createTextureUnitState();
  hideFromMouse(*material);
  return material;
}

}  // namespace

LabelOverlay::LabelOverlay(Ogre::SceneManager& scene, Ogre::SceneNode& parent)
    : scene_(scene),
      node_(parent.createChildSceneNode()),
      object_(scene.createManualObject(uniqueName("label_overlay"))),
      material_(sheetMaterial()),
      texture_(uniqueName("label_sheet")) {
  object_->setDynamic(true);
  object_->setUseIdentityProjection(true);
  object_->setUseIdentityView(true);
  object_->setRenderQueueGroup(kBeforeOverlays);
  node_->attachObject(object_);
}

LabelOverlay::~LabelOverlay() {
  scene_.destroyManualObject(object_);
  scene_.destroySceneNode(node_);
}

void LabelOverlay::setSheet(const LabelSheet& sheet) {
  sheet_ = sheet;
  texture_.set(sheet.image, *material_);
}

void LabelOverlay::draw(const std::vector<QPointF>& anchors, const std::vector<std::optional<QRectF>>& boxes,
                        QSizeF view) {
  const bool any = std::any_of(boxes.begin(), boxes.end(), [](const auto& box) { return box.has_value(); });
  object_->setVisible(any);
  if (!any) return;
  if (drawn_) {
    object_->beginUpdate(0);
  } else {
    object_->begin(material_->getName(), Ogre::RenderOperation::OT_TRIANGLE_LIST, material_->getGroup());
  }
  drawn_ = true;
  Quads quads(*object_, view, sheet_.image.size());
  for (const bool rim : {true, false}) {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (!boxes[i]) continue;
      quads.addLine(anchors[i], nearestIn(*boxes[i], anchors[i]), rim ? kRim : kLine,
                    rim ? sheet_.rim : sheet_.line);
    }
  }
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (!boxes[i]) continue;
    QRectF dot(QPointF(0.0, 0.0), QSizeF(sheet_.dot.size()));
    dot.moveCenter(anchors[i]);
    quads.add(dot, sheet_.dot);
  }
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (boxes[i]) quads.add(*boxes[i], sheet_.texts[i]);
  }
  object_->end();
  Ogre::AxisAlignedBox everywhere;
  everywhere.setInfinite();
  object_->setBoundingBox(everywhere);  // never out of view
}

}  // namespace cable_variation_rviz
