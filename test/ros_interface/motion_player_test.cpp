// Where a player is after some time.
#include <ros_interface/live/motion_player.h>

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace cable_variation_ros {
namespace {

TEST(MotionPlayer, GoesWithItsSpeedAndStartsAgain) {
  MotionPlayer player(3.0, 2.0, true);
  player.advance(0.5);
  EXPECT_DOUBLE_EQ(player.time(), 1.0);
  player.advance(1.5);
  EXPECT_DOUBLE_EQ(player.time(), 1.0);
}

TEST(MotionPlayer, WithoutLoopStaysAtTheEndUntilPlayedAgain) {
  MotionPlayer player(3.0, 1.0, false);
  player.advance(5.0);
  EXPECT_EQ(player.time(), 3.0);
  EXPECT_FALSE(player.playing());
  player.play(true);
  EXPECT_EQ(player.time(), 0.0);
}

TEST(MotionPlayer, StandsStillWhenHalted) {
  MotionPlayer player(3.0, 1.0, true);
  player.advance(1.0);
  player.play(false);
  player.advance(1.0);
  EXPECT_EQ(player.time(), 1.0);
  player.play(true);
  EXPECT_EQ(player.time(), 1.0);
}

TEST(MotionPlayer, AClockSetBackIsNoTime) {
  MotionPlayer player(3.0, 1.0, true);
  player.advance(1.0);
  player.advance(-100.0);
  EXPECT_EQ(player.time(), 1.0);
}

TEST(MotionPlayer, SeeksWithinTheRecordingOnly) {
  MotionPlayer player(3.0, 1.0, true);
  player.seek(3.0);
  EXPECT_EQ(player.time(), 3.0);
  EXPECT_THROW(player.seek(3.001), std::invalid_argument);
  EXPECT_THROW(player.seek(-1e-9), std::invalid_argument);
  EXPECT_THROW(player.seek(std::nan("")), std::invalid_argument);
  EXPECT_EQ(player.time(), 3.0);
}

TEST(MotionPlayer, NothingToPlay) {
  MotionPlayer player(0.0, 1.0, true);
  player.advance(1.0);
  EXPECT_EQ(player.time(), 0.0);
}

}  // namespace
}  // namespace cable_variation_ros
