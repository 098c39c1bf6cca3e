// What is late on tf is told once, and so is its coming back.
#include <ros_interface/live/tf_watch.h>

#include <gtest/gtest.h>

namespace cable_variation_ros {
namespace {

using cable_variation::CableEvent;

ros::Time at(double seconds) { return ros::Time(1e9 + seconds); }

TEST(TfWatch, SaysNothingWhileTfComesInTime) {
  TfWatch watch(0.5);
  for (double t = 0.0; t < 10.0; t += 0.1) {
    watch.saw("gripper", at(t - 0.05), at(t));
    EXPECT_TRUE(watch.eventsAt(at(t + 0.05)).empty());
  }
  EXPECT_TRUE(watch.late(at(10.0)).empty());
}

TEST(TfWatch, TellsOnceWhenTfStopsAndOnceWhenItIsBack) {
  TfWatch watch(0.5);
  watch.saw("gripper", at(0.0), at(0.0));
  EXPECT_TRUE(watch.eventsAt(at(0.5)).empty());
  const auto late = watch.eventsAt(at(0.75));
  ASSERT_EQ(late.size(), 1u);
  EXPECT_EQ(late[0].kind, CableEvent::TF_LATE);
  EXPECT_EQ(late[0].component, "gripper");
  EXPECT_NEAR(late[0].to_value, 0.75, 1e-6);
  EXPECT_TRUE(watch.eventsAt(at(2.0)).empty());
  ASSERT_EQ(watch.late(at(2.0)).size(), 1u);
  EXPECT_NE(watch.late(at(2.0))[0].find("2 s old"), std::string::npos) << watch.late(at(2.0))[0];
  watch.saw("gripper", at(0.0), at(2.1));  // the same stamp again is no news
  EXPECT_TRUE(watch.eventsAt(at(2.1)).empty());
  watch.saw("gripper", at(2.2), at(2.2));
  const auto back = watch.eventsAt(at(2.2));
  ASSERT_EQ(back.size(), 1u);
  EXPECT_EQ(back[0].kind, CableEvent::TF_BACK);
  EXPECT_TRUE(watch.late(at(2.2)).empty());
}

TEST(TfWatch, TellsOfTfThatComesButIsOld) {
  TfWatch watch(0.5);
  for (double t = 0.0; t < 1.0; t += 0.1) watch.saw("gripper", at(t - 3.0), at(t));
  ASSERT_EQ(watch.eventsAt(at(1.0)).size(), 1u);
}

TEST(TfWatch, AStampAheadOfTimeIsNoAnswerForLong) {
  TfWatch watch(0.5);
  const ros::Time in_2096(3976214400.0);
  watch.saw("gripper", in_2096, at(0.0));
  EXPECT_TRUE(watch.eventsAt(at(0.4)).empty());
  ASSERT_EQ(watch.eventsAt(at(0.6)).size(), 1u);
}

TEST(TfWatch, WantsWhatIsExpectedAndForgetsWhatIsNot) {
  TfWatch watch(0.5);
  watch.expect("gripper", at(0.0));
  watch.expect("gripper", at(0.4));  // not from anew
  watch.saw("tray", at(0.0), at(0.0));
  watch.keepOnly({"gripper"});
  const auto events = watch.eventsAt(at(0.6));
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].component, "gripper");
  EXPECT_NE(events[0].text.find("has not been on it"), std::string::npos);
  watch.restart();
  EXPECT_TRUE(watch.eventsAt(at(9.0)).empty());
}

}  // namespace
}  // namespace cable_variation_ros
