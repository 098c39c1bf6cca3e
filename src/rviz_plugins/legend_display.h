#pragma once

#include <memory>
#include <string>

#include <rviz_plugins/displays/topic_display.h>

#ifndef Q_MOC_RUN
#include <cable_variation/Legend.h>
#endif

namespace rviz {
class EnumProperty;
class IntProperty;
}  // namespace rviz

namespace cable_variation_rviz {

class ImageOverlay;

/// What the colours in the view mean: the latest Legend of a topic in a corner of the view. An empty legend
/// hides it.
class LegendDisplay : public TopicDisplay {
  Q_OBJECT

 public:
  LegendDisplay();
  ~LegendDisplay() override;

 protected:
  void onInitialize() override;
  ros::Subscriber listen(ros::NodeHandle& node, const std::string& topic) override;
  void forget() override;

 private Q_SLOTS:
  void place();
  void draw();

 private:
  void receive(const cable_variation::LegendConstPtr& legend);

  rviz::EnumProperty* corner_;
  rviz::IntProperty* margin_;
  rviz::IntProperty* text_height_;
  cable_variation::LegendConstPtr legend_;
  std::unique_ptr<ImageOverlay> overlay_;
};

}  // namespace cable_variation_rviz
