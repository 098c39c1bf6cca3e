// Where running nodes write unless told otherwise.
#include <ros_interface/node/default_output_directory.h>

#include <cstdlib>

#include <gtest/gtest.h>

namespace cable_variation_ros {
namespace {

TEST(DefaultOutputDirectory, IsBelowRosHomeElseBelowHome) {
  ASSERT_EQ(setenv("ROS_HOME", "/somewhere", 1), 0);
  EXPECT_EQ(defaultOutputDirectory(), "/somewhere/cable_variation");
  ASSERT_EQ(unsetenv("ROS_HOME"), 0);
  ASSERT_EQ(setenv("HOME", "/home/someone", 1), 0);
  EXPECT_EQ(defaultOutputDirectory(), "/home/someone/.ros/cable_variation");
  ASSERT_EQ(unsetenv("HOME"), 0);
  EXPECT_EQ(defaultOutputDirectory(), "cable_variation");
}

}  // namespace
}  // namespace cable_variation_ros
