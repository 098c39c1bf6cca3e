#pragma once

#include <memory>
#include <optional>

#ifndef Q_MOC_RUN
#include <OgreMaterial.h>
#include <cable_variation/CableTubes.h>
#endif

#include <rviz_plugins/displays/topic_display.h>

namespace rviz {
class BoolProperty;
class EnumProperty;
class FloatProperty;
}  // namespace rviz

namespace cable_variation_rviz {

class ImageOverlay;
class SurfaceObject;
struct QuantityRange;

/// Cables as smooth tubes, in their own colours or in those of a quantity along them, with what the colours
/// mean in a corner of the view.
class CablesDisplay : public TopicDisplay {
  Q_OBJECT

 public:
  CablesDisplay();
  ~CablesDisplay() override;

  void update(float wall_dt, float ros_dt) override;

 protected:
  void onInitialize() override;
  ros::Subscriber listen(ros::NodeHandle& node, const std::string& topic) override;
  void forget() override;

 private Q_SLOTS:
  void redraw();
  void offerQuantities();

 private:
  void receive(const cable_variation::CableTubesConstPtr& tubes);
  /// The range in force; none: nothing is coloured.
  std::optional<QuantityRange> range();
  void draw();
  void drawLegend(const std::optional<QuantityRange>& range);

  rviz::EnumProperty* quantity_;
  rviz::BoolProperty* automatic_;
  rviz::FloatProperty* minimum_;
  rviz::FloatProperty* maximum_;
  rviz::EnumProperty* map_;
  rviz::FloatProperty* alpha_;
  rviz::EnumProperty* legend_;
  cable_variation::CableTubesConstPtr tubes_;
  std::unique_ptr<SurfaceObject> surface_;
  std::unique_ptr<ImageOverlay> overlay_;
  Ogre::MaterialPtr lit_, translucent_;
  bool changed_ = false;
};

}  // namespace cable_variation_rviz
