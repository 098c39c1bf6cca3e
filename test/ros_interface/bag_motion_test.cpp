// Motions read from bags that the tests write: what is taken, and what is refused with its name.
#include <ros_interface/conversion/bag_motion.h>

#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <random>

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <geometry_msgs/TransformStamped.h>
#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <std_msgs/String.h>
#include <tf2_msgs/TFMessage.h>

#include <cable_variation/scene/motion.h>

namespace cable_variation_ros {
namespace {

using cable_variation::TimedPose;

geometry_msgs::TransformStamped transform(double time, const std::string& parent, const std::string& frame,
                                          double x) {
  geometry_msgs::TransformStamped message;
  message.header.stamp = ros::Time(time);
  message.header.frame_id = parent;
  message.child_frame_id = frame;
  message.transform.translation.x = x;
  message.transform.rotation.w = 1.0;
  return message;
}

tf2_msgs::TFMessage tf(const std::vector<geometry_msgs::TransformStamped>& transforms) {
  tf2_msgs::TFMessage message;
  message.transforms = transforms;
  return message;
}

class BagMotion : public testing::Test {
 protected:
  BagMotion()
      : path_(
            (std::filesystem::temp_directory_path() / (std::to_string(getpid()) + "_motion.bag")).string()) {}
  ~BagMotion() override { std::remove(path_.c_str()); }

  void write(const std::function<void(rosbag::Bag&)>& content) {
    rosbag::Bag bag(path_, rosbag::bagmode::Write);
    content(bag);
  }

  std::vector<TimedPose> read(const std::string& topic = "/tf") {
    motion_ = {};
    readBagMotion(path_, topic, "sled", "world", motion_);
    return motion_.samples;
  }

  void expectRefused(const std::string& part, const std::string& topic = "/tf") {
    try {
      read(topic);
      ADD_FAILURE() << "expected: " << part;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(path_), std::string::npos) << error.what();
    }
  }

  std::string path_;
  cable_variation::Motion motion_;
};

TEST_F(BagMotion, TakesTheFrameFromTfWithTimesFromZero) {
  write([](rosbag::Bag& bag) {
    bag.write("/tf", ros::Time(7),
              tf({transform(5.0, "map", "other", 9.0), transform(5.0, "/world", "/sled", 0.1)}));
    bag.write("/tf", ros::Time(8), tf({transform(5.25, "world", "sled", 0.2)}));
  });
  const std::vector<TimedPose> samples = read();
  ASSERT_EQ(samples.size(), 2u);
  EXPECT_EQ(samples[0].time, 0.0);
  EXPECT_EQ(samples[1].time, 0.25);
  EXPECT_EQ(samples[1].pose.position, Eigen::Vector3d(0.2, 0.0, 0.0));
}

TEST_F(BagMotion, TakesEachTypeOfPose) {
  write([](rosbag::Bag& bag) {
    geometry_msgs::PoseStamped pose;
    pose.header.frame_id = "world";
    pose.header.stamp = ros::Time(1.0);
    pose.pose.position.y = 0.5;
    pose.pose.orientation.w = 1.0;
    bag.write("/pose", ros::Time(1), pose);
    geometry_msgs::PoseWithCovarianceStamped uncertain;
    uncertain.header = pose.header;
    uncertain.pose.pose = pose.pose;
    bag.write("/uncertain", ros::Time(1), uncertain);
    bag.write("/transform", ros::Time(1), transform(1.0, "world", "sled", 0.5));
  });
  EXPECT_EQ(read("/pose").at(0).pose.position.y(), 0.5);
  EXPECT_EQ(read("/uncertain").at(0).pose.position.y(), 0.5);
  EXPECT_EQ(read("/transform").at(0).pose.position.x(), 0.5);
}

TEST_F(BagMotion, WithoutStampsTheRecordersTimesCount) {
  write([](rosbag::Bag& bag) {
    bag.write("/tf", ros::Time(7.0), tf({transform(0.0, "world", "sled", 0.1)}));
    bag.write("/tf", ros::Time(7.5), tf({transform(0.0, "world", "sled", 0.2)}));
  });
  EXPECT_EQ(read().at(1).time, 0.5);
}

TEST_F(BagMotion, TakesARepeatedTransformOnce) {
  write([](rosbag::Bag& bag) {
    bag.write("/tf", ros::Time(7), tf({transform(5.0, "world", "sled", 0.1)}));
    bag.write("/tf", ros::Time(8), tf({transform(5.0, "world", "sled", 0.1)}));
  });
  EXPECT_EQ(read().size(), 1u);
}

TEST_F(BagMotion, RefusesWhatIsNotThere) {
  write([](rosbag::Bag& bag) { bag.write("/tf", ros::Time(7), tf({transform(5.0, "world", "cart", 0.1)})); });
  expectRefused("no frame 'sled'; frames there: cart");
  expectRefused("topic '/poses': is not there; topics there: /tf", "/poses");
}

TEST_F(BagMotion, RefusesAnotherParent) {
  write([](rosbag::Bag& bag) { bag.write("/tf", ros::Time(7), tf({transform(5.0, "map", "sled", 0.1)})); });
  expectRefused("pose 1 is in frame 'map', expected 'world'");
}

TEST_F(BagMotion, TakesTheLastOfOtherPosesAtTheSameTime) {
  write([](rosbag::Bag& bag) {
    bag.write("/tf", ros::Time(7), tf({transform(5.0, "world", "sled", 0.1)}));
    bag.write("/tf", ros::Time(8), tf({transform(5.0, "world", "sled", 0.2)}));
    bag.write("/tf", ros::Time(9), tf({transform(5.5, "world", "sled", 0.3)}));
  });
  const std::vector<TimedPose> samples = read();
  ASSERT_EQ(samples.size(), 2u);
  EXPECT_EQ(samples[0].pose.position.x(), 0.2);
  EXPECT_EQ(motion_.replaced_poses, 1u);
}

TEST_F(BagMotion, RefusesTimesThatGoBack) {
  write([](rosbag::Bag& bag) {
    bag.write("/tf", ros::Time(7), tf({transform(5.0, "world", "sled", 0.1)}));
    bag.write("/tf", ros::Time(8), tf({transform(5.5, "world", "sled", 0.2)}));
    bag.write("/tf", ros::Time(9), tf({transform(5.25, "world", "sled", 0.2)}));
  });
  expectRefused("pose 3: time 0.250000 s is before 0.500000 s of the pose before");
}

TEST_F(BagMotion, RefusesPosesThatAreNone) {
  write([](rosbag::Bag& bag) {
    geometry_msgs::TransformStamped zero = transform(5.0, "world", "sled", 0.1);
    zero.transform.rotation.w = 0.0;
    bag.write("/zero", ros::Time(7), zero);
    geometry_msgs::TransformStamped nan = transform(5.0, "world", "sled", std::nan(""));
    bag.write("/nan", ros::Time(7), nan);
    geometry_msgs::TransformStamped turned = transform(5.0, "world", "sled", 0.1);
    bag.write("/nan_turn", ros::Time(7), turned);
    turned.header.stamp = ros::Time(6.0);
    turned.transform.rotation.y = std::nan("");
    bag.write("/nan_turn", ros::Time(8), turned);
    turned.transform.rotation.y = 1.0;
    bag.write("/long", ros::Time(8), turned);
  });
  expectRefused("pose 2: quaternion has norm", "/nan_turn");
  expectRefused("pose 1: quaternion has norm 1.414214, expected 1", "/long");
  expectRefused("pose 1: quaternion has norm 0", "/zero");
  expectRefused("pose 1: position is not finite", "/nan");
}

TEST_F(BagMotion, RefusesOtherTypesAndOtherFiles) {
  write([](rosbag::Bag& bag) { bag.write("/text", ros::Time(7), std_msgs::String()); });
  expectRefused("is of type std_msgs/String, expected geometry_msgs/PoseStamped", "/text");
  std::remove(path_.c_str());
  expectRefused("bag '");
  std::ofstream(path_) << "0 0 0 0 0 0 0 1\n";
  expectRefused("bag '");
}

TEST_F(BagMotion, RefusesAnEmptyBag) {
  write([](rosbag::Bag&) {});
  expectRefused("topic '/tf': is not there; topics there: none");
  std::ofstream(path_, std::ios::trunc);
  expectRefused("bag '");
}

TEST_F(BagMotion, RefusesABagThatEndsEarlyWhereverThatIs) {
  write([](rosbag::Bag& bag) {
    for (int k = 0; k < 100; ++k) {
      const double time = 5.0 + 0.01 * k;
      bag.write("/tf", ros::Time(time), tf({transform(time, "world", "sled", 0.001 * k)}));
    }
  });
  EXPECT_EQ(read().size(), 100u);
  const std::uintmax_t size = std::filesystem::file_size(path_);
  // Bytes at the end hold the index of the last chunk, those in the middle the messages.
  for (std::uintmax_t left = size - 1; left > 0; left -= std::min<std::uintmax_t>(left, 997)) {
    std::filesystem::resize_file(path_, left);
    expectRefused("bag '");
  }
}

TEST_F(BagMotion, ARecordingThatWasCutOffSaysHowToRepairIt) {
  // What rosbag record leaves when it is killed: a bag that was never closed has no index.
  rosbag::Bag bag(path_, rosbag::bagmode::Write);
  bag.setChunkThreshold(1000);
  for (int k = 0; k < 100; ++k) {
    const double time = 5.0 + 0.01 * k;
    bag.write("/tf", ros::Time(time), tf({transform(time, "world", "sled", 0.001 * k)}));
  }
  const std::string cut = path_ + ".cut.bag";
  std::filesystem::copy_file(path_, cut);
  bag.close();
  std::filesystem::rename(cut, path_);
  expectRefused("has no index, as when a recording ends early; rosbag reindex makes one");
}

TEST_F(BagMotion, BrokenAtRandomItIsReadOrRefusedAndThisProcessLivesOn) {
  write([](rosbag::Bag& bag) {
    for (int k = 0; k < 20; ++k)
      bag.write("/tf", ros::Time(5.0 + k), tf({transform(5.0 + k, "world", "sled", 0.001 * k)}));
  });
  std::ifstream file(path_, std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(file), {}};
  std::mt19937 random(5);
  int refused = 0;
  for (int round = 0; round < 60; ++round) {
    std::string broken = whole;
    for (unsigned i = random() % 8; i < 8; ++i) {
      const std::size_t at = random() % broken.size();
      if (random() % 2 == 0) {
        broken[at] = static_cast<char>(random());
      } else {  // a count or a length of 4 GB
        broken.replace(at, 4, "\xff\xff\xff\xff");
      }
    }
    std::ofstream(path_, std::ios::binary) << broken;
    try {
      for (const TimedPose& sample : read()) ASSERT_TRUE(sample.pose.position.allFinite());
    } catch (const std::invalid_argument& error) {
      ASSERT_NE(std::string(error.what()).find(path_), std::string::npos) << error.what();
      ++refused;
    }
  }
  EXPECT_GT(refused, 10);
}

TEST_F(BagMotion, MorePosesThanTheLimitAreRefused) {
  write([](rosbag::Bag& bag) {
    for (int k = 0; k < 20; ++k)
      bag.write("/tf", ros::Time(5.0 + k), tf({transform(5.0 + k, "world", "sled", 0.001 * k)}));
  });
  cable_variation::InputLimits limits;
  limits.poses = 20;
  EXPECT_NO_THROW(readBagMotion(path_, "/tf", "sled", "world", motion_, limits));
  limits.poses = 19;
  try {
    readBagMotion(path_, "/tf", "sled", "world", motion_, limits);
    ADD_FAILURE() << "20 poses were taken";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("at most 19 (the limit poses)"), std::string::npos)
        << error.what();
  }
}

TEST(PosesHandedOver, AreReadBackAndNothingElseIs) {
  cable_variation::Motion motion, again;
  for (int k = 0; k < 3; ++k) {
    TimedPose sample;
    sample.time = 0.1 * k;
    sample.pose.position = {1.0, 0.3 * k, -2.0};
    motion.samples.push_back(sample);
  }
  motion.replaced_poses = 7;
  setPoses(bytesOf(motion), again);
  EXPECT_EQ(bytesOf(again), bytesOf(motion));
  EXPECT_EQ(again.replaced_poses, 7U);
  const std::string bytes = bytesOf(motion);
  EXPECT_THROW(setPoses("", again), std::invalid_argument);
  EXPECT_THROW(setPoses(bytes.substr(0, 8), again), std::invalid_argument);
  EXPECT_THROW(setPoses(bytes.substr(0, bytes.size() - 1), again), std::invalid_argument);
  std::string back = bytes;
  back.replace(8 + 64, 64, bytes, 8, 64);  // the first pose twice
  EXPECT_THROW(setPoses(back, again), std::invalid_argument);
  for (std::size_t at = 8; at < bytes.size(); at += 8) {
    std::string wrong = bytes;
    wrong.replace(at, 8, 8, '\xff');  // not a number
    EXPECT_THROW(setPoses(wrong, again), std::invalid_argument) << at;
  }
}

TEST(EngineRun, IsTheSameAsABagAndAsATrajectory) {
  const std::string stem = std::string(CABLE_VARIATION_SOURCE_DIR) + "/config/engine_run";
  cable_variation::Motion from_bag, from_text;
  readBagMotion(stem + ".bag", "/tf", "engine", "engine_bay", from_bag);
  readTum(stem + ".tum", from_text);
  const std::vector<TimedPose>& bag = from_bag.samples;
  const std::vector<TimedPose>& trajectory = from_text.samples;
  ASSERT_EQ(bag.size(), trajectory.size());
  for (std::size_t k = 0; k < bag.size(); ++k) {
    ASSERT_NEAR(bag[k].time, trajectory[k].time, 2e-9) << k;  // stamps count nanoseconds
    ASSERT_EQ(bag[k].pose.position, trajectory[k].pose.position) << k;
    ASSERT_EQ(bag[k].pose.orientation.coeffs(), trajectory[k].pose.orientation.coeffs()) << k;
  }
}

}  // namespace
}  // namespace cable_variation_ros
