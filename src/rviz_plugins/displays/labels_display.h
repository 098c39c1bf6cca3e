#pragma once

#include <memory>
#include <vector>

#ifndef Q_MOC_RUN
#include <OgreFrameListener.h>
#include <cable_variation/Labels.h>
#endif

#include <rviz_plugins/displays/label_layout.h>
#include <rviz_plugins/displays/topic_display.h>

namespace rviz {
class BoolProperty;
class FloatProperty;
class IntProperty;
class StringProperty;
}  // namespace rviz

namespace cable_variation_rviz {

class LabelOverlay;

/// Texts of the scene at a constant size, none on another, readable on every background.
class LabelsDisplay : public TopicDisplay, public Ogre::FrameListener {
  Q_OBJECT

 public:
  LabelsDisplay();
  ~LabelsDisplay() override;

  /// Places the labels for the camera as it is now.
  bool frameStarted(const Ogre::FrameEvent& event) override;

  /// Where labels are seen, in pixels from the view's top left corner; for tests.
  const std::vector<std::optional<QRectF>>& boxes() const { return boxes_; }

 protected:
  void onInitialize() override;
  ros::Subscriber listen(ros::NodeHandle& node, const std::string& topic) override;
  void forget() override;

 private Q_SLOTS:
  void redraw();

 private:
  void receive(const cable_variation::LabelsConstPtr& labels);
  bool isShown(const cable_variation::Label& label) const;
  void drawSheet();

  rviz::IntProperty* text_height_;
  rviz::FloatProperty* plate_alpha_;
  rviz::BoolProperty* names_;
  rviz::BoolProperty* figures_;
  rviz::BoolProperty* faults_;
  rviz::StringProperty* left_out_;
  cable_variation::LabelsConstPtr labels_;
  std::vector<cable_variation::Label> shown_;
  std::unique_ptr<LabelOverlay> overlay_;
  LabelLayout layout_;
  std::vector<std::optional<QRectF>> boxes_;
  bool changed_ = false;
};

}  // namespace cable_variation_rviz
