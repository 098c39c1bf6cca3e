#pragma once

#include <memory>

#ifndef Q_MOC_RUN
#include <OgreMaterial.h>
#include <cable_variation/EnvelopeMesh.h>
#endif

#include <rviz_plugins/displays/surface.h>
#include <rviz_plugins/displays/topic_display.h>

namespace rviz {
class ColorProperty;
class FloatProperty;
}  // namespace rviz

namespace cable_variation_rviz {

class SurfaceObject;

/// The space that cables take up, as a translucent shell: only its nearest wall is seen, clear where one
/// looks through it.
class EnvelopeDisplay : public TopicDisplay {
  Q_OBJECT

 public:
  EnvelopeDisplay();
  ~EnvelopeDisplay() override;

 protected:
  void onInitialize() override;
  ros::Subscriber listen(ros::NodeHandle& node, const std::string& topic) override;
  void forget() override;

 private Q_SLOTS:
  void draw();

 private:
  void receive(const cable_variation::EnvelopeMeshConstPtr& envelope);

  rviz::ColorProperty* color_;
  rviz::FloatProperty* alpha_;
  Surface mesh_;
  std::unique_ptr<SurfaceObject> surface_;
  Ogre::MaterialPtr material_, opaque_;
};

}  // namespace cable_variation_rviz
