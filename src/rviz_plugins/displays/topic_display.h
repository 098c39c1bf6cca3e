#pragma once

#include <string>

#include <rviz/display.h>

#ifndef Q_MOC_RUN
#include <ros/subscriber.h>
#include <rviz/ogre_helpers/ogre_vector.h>
#endif

namespace rviz {
class RosTopicProperty;
}

namespace cable_variation_rviz {

/// A display of the latest message of one latched topic, drawn in the message's frame wherever tf has that.
class TopicDisplay : public rviz::Display {
  Q_OBJECT

 public:
  void setTopic(const QString& topic, const QString& datatype) override;
  void reset() override;
  void update(float wall_dt, float ros_dt) override;

 protected:
  /// @param datatype of the messages
  /// @param waiting what the status says until there is one
  explicit TopicDisplay(const std::string& datatype, const char* waiting = "no message yet");

  void onEnable() override;
  void onDisable() override;

  /// Listens to a topic.
  virtual ros::Subscriber listen(ros::NodeHandle& node, const std::string& topic) = 0;
  /// No message: draws nothing.
  virtual void forget() = 0;

  /// Of the message that is drawn; its origin in the frame [m].
  void setFrame(const std::string& frame, const Ogre::Vector3& origin);

 private Q_SLOTS:
  void subscribe();

 private:
  rviz::RosTopicProperty* topic_;
  const char* waiting_;
  ros::Subscriber subscriber_;
  std::string frame_;
  Ogre::Vector3 origin_ = Ogre::Vector3::ZERO;
};

}  // namespace cable_variation_rviz
