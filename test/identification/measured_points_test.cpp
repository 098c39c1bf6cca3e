// Tables of measured points.
#include <cable_variation/identification/measured_points.h>

#include <cstdio>
#include <fstream>
#include <stdexcept>

#include <gtest/gtest.h>

namespace cable_variation {
namespace {

class MeasuredPoints : public ::testing::Test {
 protected:
  std::vector<Eigen::Vector3d> read(const std::string& text) const {
    std::ofstream(path_, std::ios::binary) << text;
    return readMeasuredPoints(path_);
  }

  void refused(const std::string& text, const std::string& part) const {
    try {
      read(text);
      ADD_FAILURE() << text;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
      EXPECT_EQ(std::string(error.what()).find(path_), 0U) << error.what();
    }
  }

  ~MeasuredPoints() override { std::remove(path_.c_str()); }

  const std::string path_ = testing::TempDir() + "measured_points_test.csv";
};

TEST_F(MeasuredPoints, UnitsAndOrderOfColumnsAreThoseOfTheTitles) {
  for (const char* text :
       {"x [mm],y [mm],z [mm]\n1000,2,3\n4,5,6\n", "x,y,z\n1,0.002,0.003\n0.004,0.005,0.006\n",
        "name;z_mm;Y_m;x [m]\r\na;3;0.002;1\r\nb;6;0.005;0.004\r\n", "x y z\n1 2e-3 3e-3\n4e-3 5e-3 6e-3\n",
        "# made by hand\n\"x (cm)\",\"y (cm)\",\"z (cm)\"\n100,.2,.3\n\n.4,.5,.6\n"}) {
    const auto points = read(text);
    ASSERT_EQ(points.size(), 2U) << text;
    EXPECT_LT((points[0] - Eigen::Vector3d(1.0, 2e-3, 3e-3)).norm(), 1e-15) << text;
    EXPECT_LT((points[1] - Eigen::Vector3d(4e-3, 5e-3, 6e-3)).norm(), 1e-15) << text;
  }
  EXPECT_EQ(read("x_m,y_m\n1,2\n3,4\n")[1], Eigen::Vector3d(3.0, 4.0, 0.0));
}

TEST_F(MeasuredPoints, WhatIsWrongIsToldWithItsLine) {
  refused("", "0 points; expected at least 2");
  refused("x,y\n1,2\n", "1 points; expected at least 2");
  refused("1,2\n3,4\n", ":1: no column 'x'");
  refused("x,z\n3,4\n", ":1: no column 'y'");
  refused("x,y,x\n3,4,5\n", ":1: column 'x' is there twice");
  refused("x [N],y\n3,4\n", ":1: ");
  refused("x [furlong],y\n3,4\n", "unknown unit 'furlong'");
  refused("x,y\n3,4\n3\n", ":3: 1 values; expected 2");
  refused("x,y\n3,4\n3,4,5\n", ":3: 3 values; expected 2");
  refused("x,y\n3,four\n", ":2: 'four' is no number");
  refused("x,y\n3,nan\n", ":2: 'nan' is no number");
  refused("x,y\n3,1e999\n", ":2: '1e999' is no number");
  EXPECT_THROW(readMeasuredPoints("/nowhere/at.all"), std::invalid_argument);
}

}  // namespace
}  // namespace cable_variation
