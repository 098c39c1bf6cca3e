#include <cmath>
#include <iomanip>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <cable_variation/scene/motion.h>
#include <cable_variation/scene/motion_samples.h>

#include "test_packages.h"

namespace cable_variation {
namespace {

Motion quarterTurn() {
  Motion motion;
  motion.name = "turn";
  readTum(findTestPackage("test_data") + "/motions/quarter_turn.tum", motion);
  return motion;
}

double angleAboutZ(const Pose& pose) { return 2.0 * std::atan2(pose.orientation.z(), pose.orientation.w()); }

std::string refusal(const std::vector<std::string>& lines) {
  const TemporaryFile file("motion.tum", lines);
  try {
    Motion motion;
    readTum(file.path(), motion);
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
  EXPECT_NEAR(angleAboutZ(motion.samples[2].pose), M_PI / 2.0, 1e-12);
}

TEST(Tum, namesTheLineOfAFault) {
  EXPECT_EQ(refusal({"0 0 0 0 0 0 0 1", "# two", "1 0 0 0 0 0 0"}),
            ":3: a number is missing; expected time tx ty tz qx qy qz qw");
  EXPECT_EQ(refusal({"0 0 0 x 0 0 0 1"}), ":1: found 'x'; expected a finite number");
  EXPECT_EQ(refusal({std::string("0 0 0 x\0\xff 0 0 0 1", 17)}),
            ":1: found 'x\\x00\\xff'; expected a finite number");
  EXPECT_EQ(refusal({std::string("\xff\xfe"
                                 "0\0 \0",
                                 6)}),
            ":1: the file is in UTF-16; expected UTF-8");
  EXPECT_EQ(refusal({"0 0 0 1e999 0 0 0 1"}), ":1: found '1e999'; expected a finite number");
  EXPECT_EQ(refusal({"0 0 0 nan 0 0 0 1"}), ":1: found 'nan'; expected a finite number");
  EXPECT_EQ(refusal({"0 0 0 1m 0 0 0 1"}), ":1: found '1m'; expected a finite number");
  EXPECT_EQ(refusal({"0 0 0 0 0 0 0 1 2"}), ":1: found '2' after the eighth number; expected no more");
  EXPECT_EQ(refusal({"0 0 0 0 0 0 0 0"}), ":1: quaternion has norm 0.000000; expected 1");
  EXPECT_EQ(refusal({"0 0 0 0 0 0 0 1.002"}), ":1: quaternion has norm 1.002000; expected 1");
  EXPECT_EQ(refusal({"0 0 0 0 nan 0 0 1"}), ":1: found 'nan'; expected a finite number");
  EXPECT_EQ(refusal({"0 0 0 0 0 0 0 1", "1 0 0 0 0 0 0 0.5"}),
            ":2: quaternion has norm 0.500000; expected 1");
  EXPECT_EQ(refusal({"0.5 0 0 0 0 0 0 1", "", "0.25 0 0 0 0 0 0 1"}),
            ":3: time 0.250000 s is before 0.500000 s of the pose before");
  EXPECT_EQ(
      refusal({"0,0,0,0,0,0,0,1"}),
      ":1: found '0,0,0,0,0,0,0,1'; expected numbers parted by blanks, with a decimal point and no comma");
  EXPECT_EQ(refusal({"0 0 1,5 0 0 0 0 1"}),
            ":1: found '1,5'; expected numbers parted by blanks, with a decimal point and no comma");
  EXPECT_EQ(refusal({}), ": it holds no pose");
  EXPECT_EQ(refusal({"# nothing"}), ": it holds no pose");
  EXPECT_EQ(refusal({"0 0 0 0 0 0 0 1.0005"}), "");
  Motion motion;
  EXPECT_THROW(readTum("/nowhere/motion.tum", motion), std::invalid_argument);
}

TEST(Tum, doesNotTakeAFolderForAnEmptyFile) {
  const std::string folder = findTestPackage("test_data") + "/motions";
  try {
    Motion motion;
    readTum(folder, motion);
    ADD_FAILURE() << "expected: is a folder";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(error.what(), folder + ": is a folder; expected a file");
  }
}

Motion read(const std::vector<std::string>& lines) {
  const TemporaryFile file("motion.tum", lines);
  Motion motion;
  readTum(file.path(), motion);
  return motion;
}

TEST(Tum, isReadHoweverItIsWritten) {
  const std::string plain = "0.5 0.1 -0.2 300 0 0 0.6 0.8";
  for (const std::string& line :
       {plain, plain + "\r", plain + "  \t", "  " + plain, plain + " # end",
        std::string("5e-1\t1E-1 -.2 +3e+2 0 -0 0.6 8.0e-01"), "\xef\xbb\xbf" + plain}) {
    const Motion motion = read({line, "# nothing\r", "\r", "1.5 0 0 0 0 0 0 1\r"});
    ASSERT_EQ(motion.samples.size(), 2U) << line;
    EXPECT_EQ(motion.samples[0].pose.position, Eigen::Vector3d(0.1, -0.2, 300.0)) << line;
    EXPECT_EQ(motion.samples[1].time, 1.0) << line;
  }
}

TEST(Tum, ofPosesAtTheSameTimeTheLastCounts) {
  Motion motion = read({"1 0 0 0 0 0 0 1", "1 0 0 0 0 0 0 1", "1 0 0 0 0 0 0 -1", "2 1 0 0 0 0 0 1",
                        "2 3 0 0 0 0 0 1", "2 5 0 0 0 0 0 1", "3 0 0 0 0 0 0 1"});
  ASSERT_EQ(motion.samples.size(), 3U);
  EXPECT_EQ(motion.samples[1].pose.position.x(), 5.0);
  EXPECT_EQ(motion.replaced_poses, 2U);
  EXPECT_EQ(noteOnReplaced(motion),
            "2 of its poses have the same time as the next one, and another place; of 3 times the last pose "
            "counts");
  EXPECT_EQ(poseAt(motion, 0.5).position.x(), 2.5);
  motion = read({"1 0 0 0 0 0 0 1", "1 0 0 0 0 0 0 1"});
  EXPECT_EQ(motion.samples.size(), 1U);
  EXPECT_EQ(noteOnReplaced(motion), "");
}

// Any recording with repeated stamps is what is left when all but the last of each stamp are struck out.
TEST(Tum, randomRepeatedTimes) {
  std::mt19937 random(11);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<std::string> all, struck;
    double time = 1305031098.6659;
    std::size_t different = 0;
    for (int k = 0; k < 200; ++k) {
      const bool repeats = k > 0 && random() % 3 == 0;
      const bool same = repeats && random() % 2 == 0;
      if (!repeats) time += 0.01;
      std::ostringstream line;
      line << std::setprecision(17) << time << " " << k << " 0 0 0 0 0 1";
      const std::string text = same ? all.back() : line.str();
      if (repeats && !same) ++different;
      if (repeats) struck.pop_back();
      all.push_back(text);
      struck.push_back(text);
    }
    const Motion a = read(all);
    const Motion b = read(struck);
    ASSERT_EQ(a.samples.size(), b.samples.size());
    EXPECT_EQ(a.replaced_poses, different);
    EXPECT_EQ(b.replaced_poses, 0U);
    for (std::size_t k = 0; k < a.samples.size(); ++k) {
      EXPECT_EQ(a.samples[k].time, b.samples[k].time);
      EXPECT_EQ(a.samples[k].pose.position, b.samples[k].pose.position);
    }
  }
}

TEST(Tum, holdsTheEngineRunOfTheHoseCase) {
  Motion motion;
  readTum(std::string(CABLE_VARIATION_SOURCE_DIR) + "/config/engine_run.tum", motion);
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
  EXPECT_GT((most - least).tail<3>().minCoeff(), 0.3 * M_PI / 180.0);
  EXPECT_LT((most - least).tail<3>().maxCoeff(), 10.0 * M_PI / 180.0);
}

TEST(PoseAt, isLinearInPositionAndConstantInAngularVelocity) {
  const Motion motion = quarterTurn();
  const Pose half = poseAt(motion, 0.5);
  EXPECT_NEAR((half.position - Eigen::Vector3d(0.05, 0.0, 0.0)).norm(), 0.0, 1e-15);
  EXPECT_NEAR(angleAboutZ(half), M_PI / 8.0, 1e-12);
  const Pose later = poseAt(motion, 2.5);
  EXPECT_NEAR((later.position - Eigen::Vector3d(0.1, 0.15, 0.0)).norm(), 0.0, 1e-15);
  EXPECT_NEAR(angleAboutZ(later), M_PI / 4.0 + 0.75 * M_PI / 4.0, 1e-12);
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
