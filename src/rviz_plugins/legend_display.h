#pragma once

#include <memory>

#include <rviz/display.h>

#ifndef Q_MOC_RUN
#include <cable_variation/Legend.h>
#endif

namespace rviz {
class EnumProperty;
class IntProperty;
class RosTopicProperty;
}  // namespace rviz

namespace cable_variation_rviz {

class ImageOverlay;

/// What the colours in the view mean: the latest Legend of a topic in a corner of the view. An empty legend
/// hides it.
class LegendDisplay : public rviz::Display {
  Q_OBJECT

 public:
  LegendDisplay();
  ~LegendDisplay() override;

  void setTopic(const QString& topic, const QString& datatype) override;
  void reset() override;

 protected:
  void onInitialize() override;
  void onEnable() override;
  void onDisable() override;

 private Q_SLOTS:
  void subscribe();
  void place();
  void draw();

 private:
  void receive(const cable_variation::LegendConstPtr& legend);

  rviz::RosTopicProperty* topic_;
  rviz::EnumProperty* corner_;
  rviz::IntProperty* margin_;
  rviz::IntProperty* text_height_;
  ros::Subscriber subscriber_;
  cable_variation::LegendConstPtr legend_;
  std::unique_ptr<ImageOverlay> overlay_;
};

}  // namespace cable_variation_rviz
