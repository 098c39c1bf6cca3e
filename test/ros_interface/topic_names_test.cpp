// Every name gets a topic of its own that ROS accepts.
#include <ros_interface/node/topic_names.h>

#include <gtest/gtest.h>
#include <ros/names.h>

namespace cable_variation_ros {
namespace {

TEST(TopicNames, AreTheNamesWhereRosAllowsThem) {
  EXPECT_EQ(topicNames("live/", {"D_CAR", "bend"}), (std::vector<std::string>{"live/D_CAR", "live/bend"}));
}

TEST(TopicNames, AreLegalAndDifferent) {
  const std::vector<std::string> topics = topicNames("reaction/", {"A-1", "A.1", "A_1", "1", "A_1_2"});
  const std::vector<std::string> expected = {"reaction/A_1", "reaction/A_1_2", "reaction/A_1_3", "reaction/1",
                                             "reaction/A_1_2_2"};
  EXPECT_EQ(topics, expected);
  for (const std::string& topic : topics) {
    std::string error;
    EXPECT_TRUE(ros::names::validate(topic, error)) << error;
  }
}

}  // namespace
}  // namespace cable_variation_ros
