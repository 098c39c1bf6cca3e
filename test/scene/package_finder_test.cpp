// Packages without ROS.
#include <cable_variation/scene/package_finder.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include <unistd.h>

namespace cable_variation {
namespace {

namespace fs = std::filesystem;

class PackageFinderTest : public testing::Test {
 protected:
  PackageFinderTest() {
    const char* before = std::getenv("ROS_PACKAGE_PATH");
    if (before != nullptr) before_ = before;
    setenv("ROS_PACKAGE_PATH", (root_ / "space").c_str(), 1);
  }
  ~PackageFinderTest() override {
    fs::remove_all(root_);
    setenv("ROS_PACKAGE_PATH", before_.c_str(), 1);
  }

  fs::path make(const fs::path& folder, const std::string& name) const {
    fs::create_directories(root_ / folder);
    std::ofstream(root_ / folder / "package.xml") << "<package><name> " << name << "\n</name></package>";
    return root_ / folder;
  }

  fs::path root_ = fs::temp_directory_path() / (std::to_string(getpid()) + "_packages");
  std::string before_;
};

TEST_F(PackageFinderTest, IsFoundBelowTheFoldersOfThePath) {
  const fs::path direct = make("space/parts", "parts"), deep = make("space/stack/other/folder", "cars");
  EXPECT_EQ(findPackageNear("parts", "/"), direct);
  EXPECT_EQ(findPackageNear("cars", "/"), deep);
  EXPECT_EQ(findPackageNear("bikes", "/"), "");
}

TEST_F(PackageFinderTest, WhatLiesInAPackageOrIsToBeIgnoredIsNone) {
  make("space/parts", "parts");
  make("space/parts/inner", "inner");
  make("space/left_out/cars", "cars");
  std::ofstream(root_ / "space/left_out/CATKIN_IGNORE") << "";
  EXPECT_EQ(findPackageNear("inner", "/"), "");
  EXPECT_EQ(findPackageNear("cars", "/"), "");
}

TEST_F(PackageFinderTest, ElseAroundTheFileThatNamesIt) {
  const fs::path around = make("elsewhere/parts", "parts");
  fs::create_directories(around / "config");
  EXPECT_EQ(findPackageNear("parts", around / "config/harness.yaml"), around);
  EXPECT_EQ(findPackageNear("parts", around / "not/there.yaml"), around);
  const fs::path first = make("space/parts", "parts");
  EXPECT_EQ(findPackageNear("parts", around / "config/harness.yaml"), first);
}

TEST_F(PackageFinderTest, ADamagedPackageFileIsPassedOver) {
  fs::create_directories(root_ / "space/parts");
  std::ofstream(root_ / "space/parts/package.xml") << "<package><name>parts";
  EXPECT_EQ(findPackageNear("parts", "/"), "");
}

TEST_F(PackageFinderTest, ThroughLinks) {
  const fs::path parts = make("elsewhere/parts", "parts");
  fs::create_directories(parts / "config");
  fs::create_directories(root_ / "space");
  fs::create_directory_symlink(parts / "config", root_ / "scenes");  // to within the package
  EXPECT_EQ(findPackageNear("parts", root_ / "scenes/harness.yaml"), parts);
  fs::create_directory_symlink(root_ / "elsewhere", root_ / "space/linked");  // on the package path
  EXPECT_EQ(findPackageNear("parts", "/"), root_ / "space/linked/parts");
  setenv("ROS_PACKAGE_PATH", (root_ / "workspace").c_str(), 1);  // the path itself
  fs::create_directory_symlink(root_ / "elsewhere", root_ / "workspace");
  EXPECT_EQ(findPackageNear("parts", "/"), root_ / "workspace/parts");
  fs::create_directory_symlink(root_ / "space", root_ / "elsewhere/round");  // in circles
  EXPECT_EQ(findPackageNear("bikes", "/"), "");
}

}  // namespace
}  // namespace cable_variation
