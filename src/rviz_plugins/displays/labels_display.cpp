#include <rviz_plugins/displays/labels_display.h>

#include <OgreCamera.h>
#include <OgreRoot.h>
#include <OgreSceneNode.h>
#include <OgreViewport.h>

#include <pluginlib/class_list_macros.hpp>
#include <ros/message_traits.h>
#include <rviz/display_context.h>
#include <rviz/properties/bool_property.h>
#include <rviz/properties/float_property.h>
#include <rviz/properties/int_property.h>
#include <rviz/properties/string_property.h>
#include <rviz/view_controller.h>
#include <rviz/view_manager.h>

#include <QRegularExpression>
#include <QStringList>

#include <rviz_plugins/displays/label_overlay.h>
#include <rviz_plugins/displays/message_checks.h>
#include <rviz_plugins/image_overlay.h>

namespace cable_variation_rviz {

using cable_variation::Label;
using rviz::StatusProperty;

namespace {

const QPointF kOutOfView(-1.0, -1.0);

/// Where a point of the world is seen [px]; out of view if it is behind the camera.
QPointF pixelOf(const Ogre::Vector3& point, const Ogre::Matrix4& view_projection, const QSizeF& view) {
  const Ogre::Vector4 seen = view_projection * Ogre::Vector4(point.x, point.y, point.z, 1.0F);
  if (!(seen.w > 0.0F) || std::abs(seen.z) > seen.w) return kOutOfView;
  return {0.5 * view.width() * (1.0 + seen.x / seen.w), 0.5 * view.height() * (1.0 - seen.y / seen.w)};
}

/// Faults find their place first, then names, then figures.
int rankOf(const Label& label) {
  if (label.kind == Label::FAULT) return 0;
  return label.kind == Label::NAME ? 1 : 2;
}

}  // namespace

LabelsDisplay::LabelsDisplay()
    : TopicDisplay(ros::message_traits::datatype<cable_variation::Labels>()),
      text_height_(new rviz::IntProperty("Text Height", 15, "[pixels]", this, SLOT(redraw()))),
      plate_alpha_(new rviz::FloatProperty("Plate Alpha", 0.8F, "of the plates behind texts: 1 is opaque",
                                           this, SLOT(redraw()))),
      names_(new rviz::BoolProperty("Names", true, "of clips", this, SLOT(redraw()))),
      figures_(
          new rviz::BoolProperty("Figures", true, "distances that keep their limits", this, SLOT(redraw()))),
      faults_(new rviz::BoolProperty("Faults", true, "distances that do not", this, SLOT(redraw()))),
      left_out_(new rviz::StringProperty(
          "Leave Out", "", "texts that begin with one of these words; commas or spaces between them", this,
          SLOT(redraw()))) {
  text_height_->setMin(8);
  text_height_->setMax(64);
  plate_alpha_->setMin(0.0F);
  plate_alpha_->setMax(1.0F);
}

LabelsDisplay::~LabelsDisplay() {
  if (overlay_) Ogre::Root::getSingleton().removeFrameListener(this);
}

void LabelsDisplay::onInitialize() {
  overlay_ = std::make_unique<LabelOverlay>(*context_->getSceneManager(), *scene_node_);
  Ogre::Root::getSingleton().addFrameListener(this);
}

ros::Subscriber LabelsDisplay::listen(ros::NodeHandle& node, const std::string& topic) {
  return node.subscribe(topic, 1, &LabelsDisplay::receive, this);
}

void LabelsDisplay::receive(const cable_variation::LabelsConstPtr& labels) {
  const std::string fault = faultOf(*labels);
  if (!fault.empty()) {
    forget();
    setStatusStd(StatusProperty::Error, "Topic", fault);
    return;
  }
  labels_ = labels;
  setFrame(labels->header.frame_id, Ogre::Vector3::ZERO);
  redraw();
}

void LabelsDisplay::forget() {
  labels_.reset();
  redraw();
}

void LabelsDisplay::redraw() {
  changed_ = true;
  queueRender();
}

bool LabelsDisplay::isShown(const Label& label) const {
  const rviz::BoolProperty* kind = figures_;
  if (label.kind == Label::NAME) kind = names_;
  if (label.kind == Label::FAULT) kind = faults_;
  if (!kind->getBool() || label.text.empty()) return false;
  const QString first = QString::fromStdString(label.text).section(' ', 0, 0);
  static const QRegularExpression between("[,\\s]+");
  return !left_out_->getString().split(between).contains(first);
}

void LabelsDisplay::drawSheet() {
  changed_ = false;
  std::vector<Label> shown;
  if (labels_) {
    for (const Label& label : labels_->labels) {
      if (isShown(label)) shown.push_back(label);
    }
  }
  const LabelSheet sheet = labelSheet(shown, {text_height_->getInt(), plate_alpha_->getFloat()});
  const QString all = QString::number(shown.size()) + " texts";
  if (sheet.texts.size() < shown.size()) {
    setStatus(StatusProperty::Warn, "Topic",
              QString("the first %1 of ").arg(static_cast<int>(sheet.texts.size())) + all);
    shown.resize(sheet.texts.size());
  } else if (labels_) {
    setStatus(StatusProperty::Ok, "Topic", all);
  }
  if (shown.size() != shown_.size()) layout_.forget();
  shown_ = std::move(shown);
  overlay_->setSheet(sheet);
}

bool LabelsDisplay::frameStarted(const Ogre::FrameEvent& /*event*/) {
  const rviz::ViewController* view = context_->getViewManager()->getCurrent();
  if (view == nullptr || view->getCamera()->getViewport() == nullptr) return true;
  if (changed_) drawSheet();
  const Ogre::Camera& camera = *view->getCamera();
  const QSizeF size(camera.getViewport()->getActualWidth(), camera.getViewport()->getActualHeight());
  const Ogre::Matrix4 seen =
      camera.getProjectionMatrix() * camera.getViewMatrix() * scene_node_->_getFullTransform();
  std::vector<LabelWish> wishes;
  std::vector<QPointF> anchors;
  const LabelSheet& sheet = overlay_->sheet();
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    const auto& at = shown_[i].at;
    const Ogre::Vector3 point(static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z));
    anchors.push_back(pixelOf(point, seen, size));
    wishes.push_back({anchors.back(), sheet.texts[i].size(), rankOf(shown_[i])});
  }
  boxes_ = layout_.place(wishes, size, 1.5 * text_height_->getInt(), ImageOverlay::covered(size));
  overlay_->draw(anchors, boxes_, size);
  return true;
}

}  // namespace cable_variation_rviz

PLUGINLIB_EXPORT_CLASS(cable_variation_rviz::LabelsDisplay, rviz::Display)
