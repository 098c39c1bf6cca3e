#include <rviz_plugins/displays/topic_display.h>

#include <OgreSceneNode.h>

#include <rviz/display_context.h>
#include <rviz/frame_manager.h>
#include <rviz/properties/ros_topic_property.h>

namespace cable_variation_rviz {

using rviz::StatusProperty;

TopicDisplay::TopicDisplay(const std::string& datatype, const char* waiting)
    : topic_(new rviz::RosTopicProperty("Topic", "", QString::fromStdString(datatype),
                                        QString::fromStdString(datatype) + ", latched", this,
                                        SLOT(subscribe()))),
      waiting_(waiting) {}

void TopicDisplay::onEnable() { subscribe(); }

void TopicDisplay::onDisable() {
  subscriber_.shutdown();
  forget();
}

void TopicDisplay::setTopic(const QString& topic, const QString& /*datatype*/) { topic_->setString(topic); }

void TopicDisplay::reset() {
  Display::reset();
  subscribe();
}

void TopicDisplay::subscribe() {
  subscriber_.shutdown();
  frame_.clear();
  forget();
  if (!isEnabled() || topic_->getTopicStd().empty()) return;
  try {
    subscriber_ = listen(update_nh_, topic_->getTopicStd());
    setStatus(StatusProperty::Ok, "Topic", waiting_);
  } catch (const ros::Exception& error) {
    setStatusStd(StatusProperty::Error, "Topic", error.what());
  }
}

void TopicDisplay::setFrame(const std::string& frame, const Ogre::Vector3& origin) {
  frame_ = frame;
  origin_ = origin;
}

void TopicDisplay::update(float /*wall_dt*/, float /*ros_dt*/) {
  if (frame_.empty()) return;
  Ogre::Vector3 position;
  Ogre::Quaternion orientation;
  if (!context_->getFrameManager()->getTransform(frame_, ros::Time(), position, orientation)) {
    setStatusStd(StatusProperty::Error, "Frame", "no transform from " + frame_ + " to the fixed frame");
    return;
  }
  deleteStatus("Frame");
  scene_node_->setPosition(position + orientation * origin_);
  scene_node_->setOrientation(orientation);
}

}  // namespace cable_variation_rviz
