#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <cable_variation/scene/motion.h>

#include "test_packages.h"

namespace cable_variation {
namespace {

constexpr double kPi = 3.14159265358979323846;

Motion quarterTurn() {
  Motion motion;
  motion.name = "turn";
  motion.samples = readTum(findTestPackage("test_data") + "/motions/quarter_turn.tum");
  return motion;
}

double angleAboutZ(const Pose& pose) { return 2.0 * std::atan2(pose.orientation.z(), pose.orientation.w()); }

std::string refusal(const std::vector<std::string>& lines) {
  const TemporaryFile file("motion.tum", lines);
  try {
    readTum(file.path());
  } catch (const std::invalid_argument& error) {
    const std::string what = error.what();
    EXPECT_EQ(what.substr(0, file.path().size()), file.path());
    return what.substr(file.path().size());
  }
  return "";
}

TEST(Tum, startsAtZeroAndSkipsComments) {
  const Motion motion = quarterTurn();
  ASSERT_EQ(motion.samples.size(), 3U);
  EXPECT_DOUBLE_EQ(motion.samples[0].time, 0.0);
  EXPECT_DOUBLE_EQ(motion.samples[1].time, 1.0);
  EXPECT_DOUBLE_EQ(motion.duration(), 3.0);
  EXPECT_EQ(motion.samples[2].pose.position, Eigen::Vector3d(0.1, 0.2, 0.0));
  EXPECT_NEAR(angleAboutZ(motion.samples[2].pose), kPi / 2.0, 1e-12);
}

TEST(Tum, namesTheLineOfAFault) {
  EXPECT_EQ(refusal({"0 0 0 0 0 0 0 1", "# two", "1 0 0 0 0 0 0"}),
            ":3: a number is missing; expected time tx ty tz qx qy qz qw");
  EXPECT_EQ(refusal({"0 0 0 x 0 0 0 1"}), ":1: found 'x'; expected a finite number");
  EXPECT_EQ(refusal({"0 0 0 1e999 0 0 0 1"}), ":1: found '1e999'; expected a finite number");
  EXPECT_EQ(refusal({"0 0 0 nan 0 0 0 1"}), ":1: found 'nan'; expected a finite number");
  EXPECT_EQ(refusal({"0 0 0 1m 0 0 0 1"}), ":1: found '1m'; expected a finite number");
  EXPECT_EQ(refusal({"0 0 0 0 0 0 0 1 2"}), ":1: found '2' after the eighth number; expected no more");
  EXPECT_EQ(refusal({"0 0 0 0 0 0 0 0"}), ":1: quaternion has norm 0.000000; expected 1");
  EXPECT_EQ(refusal({"0 0 0 0 0 0 0 1.002"}), ":1: quaternion has norm 1.002000; expected 1");
  EXPECT_EQ(refusal({"0 0 0 0 nan 0 0 1"}), ":1: found 'nan'; expected a finite number");
  EXPECT_EQ(refusal({"0 0 0 0 0 0 0 1", "1 0 0 0 0 0 0 0.5"}), ":2: quaternion has norm 0.500000; expected 1");
  EXPECT_EQ(refusal({"1 0 0 0 0 0 0 1", "1 0 0 0 0 0 0 1"}),
            ":2: time 1.000000 s is not after 1.000000 s of the pose before");
  EXPECT_EQ(refusal({"0.5 0 0 0 0 0 0 1", "", "0.25 0 0 0 0 0 0 1"}),
            ":3: time 0.250000 s is not after 0.500000 s of the pose before");
  EXPECT_EQ(refusal({}), ": it holds no pose");
  EXPECT_EQ(refusal({"# nothing"}), ": it holds no pose");
  EXPECT_EQ(refusal({"0 0 0 0 0 0 0 1.0005"}), "");
  EXPECT_THROW(readTum("/nowhere/motion.tum"), std::invalid_argument);
}

TEST(Tum, doesNotTakeAFolderForAnEmptyFile) {
  const std::string folder = findTestPackage("test_data") + "/motions";
  try {
    readTum(folder);
    ADD_FAILURE() << "expected: cannot be read";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(error.what(), folder + ": cannot be read");
  }
}

TEST(Tum, holdsTheEngineRunOfTheHoseCase) {
  Motion motion;
  motion.samples = readTum(std::string(CABLE_VARIATION_SOURCE_DIR) + "/config/engine_run.tum");
  EXPECT_EQ(motion.samples.size(), 10001U);
  EXPECT_DOUBLE_EQ(motion.duration(), 50.0);
  // An engine on rubber mounts: it moves in all six ways, by less than 10 mm and 5 degrees either way.
  Eigen::Matrix<double, 6, 1> least, most;
  least.setConstant(1.0);
  most.setConstant(-1.0);
  for (const TimedPose& sample : motion.samples) {
    Eigen::Matrix<double, 6, 1> moved;
    moved << sample.pose.position - motion.samples.front().pose.position, 2.0 * sample.pose.orientation.vec();
    least = least.cwiseMin(moved);
    most = most.cwiseMax(moved);
  }
  EXPECT_GT((most - least).head<3>().minCoeff(), 1e-3);
  EXPECT_LT((most - least).head<3>().maxCoeff(), 20e-3);
  EXPECT_GT((most - least).tail<3>().minCoeff(), 0.3 * kPi / 180.0);
  EXPECT_LT((most - least).tail<3>().maxCoeff(), 10.0 * kPi / 180.0);
}

TEST(PoseAt, isLinearInPositionAndConstantInAngularVelocity) {
  const Motion motion = quarterTurn();
  const Pose half = poseAt(motion, 0.5);
  EXPECT_NEAR((half.position - Eigen::Vector3d(0.05, 0.0, 0.0)).norm(), 0.0, 1e-15);
  EXPECT_NEAR(angleAboutZ(half), kPi / 8.0, 1e-12);
  const Pose later = poseAt(motion, 2.5);
  EXPECT_NEAR((later.position - Eigen::Vector3d(0.1, 0.15, 0.0)).norm(), 0.0, 1e-15);
  EXPECT_NEAR(angleAboutZ(later), kPi / 4.0 + 0.75 * kPi / 4.0, 1e-12);
}

TEST(PoseAt, turnsTheShortWayWhateverTheSignOfTheQuaternion) {
  Motion motion = quarterTurn();
  motion.samples[1].pose.orientation.coeffs() *= -1.0;
  const Eigen::Quaterniond q = poseAt(motion, 0.5).orientation;
  EXPECT_NEAR(std::abs(q.dot(poseAt(quarterTurn(), 0.5).orientation)), 1.0, 1e-12);
}

TEST(PoseAt, isClampedToTheRecording) {
  const Motion motion = quarterTurn();
  EXPECT_EQ(poseAt(motion, -1.0).position, motion.samples.front().pose.position);
  EXPECT_EQ(poseAt(motion, 1e9).position, motion.samples.back().pose.position);
}

TEST(PoseAt, needsSamplesAndATime) {
  EXPECT_THROW(poseAt(Motion(), 0.0), std::invalid_argument);
  EXPECT_THROW(poseAt(quarterTurn(), std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace cable_variation
