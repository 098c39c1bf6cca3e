// The legend as RViz gets it: loaded by pluginlib from the package's own description, and drawn.
#include <rviz_plugins/legend_image.h>

#include <memory>

#include <gtest/gtest.h>
#include <pluginlib/class_loader.hpp>
#include <ros/init.h>
#include <ros/master.h>
#include <rviz/display.h>

#include <QApplication>

#include <ros_interface/markers/colour_map.h>

namespace cable_variation_rviz {
namespace {

class LegendTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    static int count = 1;
    static char name[] = "legend_test";
    static char* arguments[] = {name, nullptr};
    application_ = std::make_unique<QApplication>(count, arguments);
    // Displays have a node handle, which looks for a master; this test has none to wait for.
    ros::init(ros::M_string(), name, ros::init_options::NoRosout | ros::init_options::NoSigintHandler);
    ros::master::setRetryTimeout(ros::WallDuration(0.1));
  }
  static void TearDownTestSuite() {
    ros::shutdown();
    application_.reset();
  }

  static std::unique_ptr<QApplication> application_;
};
std::unique_ptr<QApplication> LegendTest::application_;

cable_variation::Legend sixSigma() {
  cable_variation::Legend legend;
  legend.title = "Variation of parts";
  legend.quantity = "6 sigma";
  legend.unit = "mm";
  legend.minimum = 0.0;
  legend.maximum = 4.17;
  return legend;
}

/// Whether the colour is in the picture, each of r g b within `tolerance` of 255.
bool contains(const QImage& image, const Eigen::Vector3d& color, int tolerance) {
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const QColor pixel = image.pixelColor(x, y);
      if (std::abs(pixel.red() - 255 * color[0]) <= tolerance &&
          std::abs(pixel.green() - 255 * color[1]) <= tolerance &&
          std::abs(pixel.blue() - 255 * color[2]) <= tolerance && pixel.alpha() == 255) {
        return true;
      }
    }
  }
  return false;
}

TEST_F(LegendTest, IsAPluginThatRvizFinds) {
  pluginlib::ClassLoader<rviz::Display> loader("rviz", "rviz::Display");
  ASSERT_TRUE(loader.isClassAvailable("cable_variation/Legend"));
  const std::unique_ptr<rviz::Display> display(loader.createUnmanagedInstance("cable_variation/Legend"));
  ASSERT_NE(display, nullptr);
  display->setTopic("/cable_solver/legend", "cable_variation/Legend");
  ASSERT_NE(display->subProp("Topic"), nullptr);
  EXPECT_EQ(display->subProp("Topic")->getValue().toString(), "/cable_solver/legend");
  EXPECT_FALSE(display->subProp("Corner")->getValue().toString().isEmpty());
}

TEST_F(LegendTest, ShowsTheWholeScale) {
  const QImage image = legendImage(sixSigma(), 16);
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    EXPECT_TRUE(contains(image, cable_variation_ros::viridis(share), 2)) << share;
  }
}

TEST_F(LegendTest, OfOneValueShowsOneColour) {
  cable_variation::Legend legend = sixSigma();
  legend.maximum = legend.minimum;
  const QImage image = legendImage(legend, 16);
  EXPECT_TRUE(contains(image, cable_variation_ros::viridis(0.0), 2));
  EXPECT_FALSE(contains(image, cable_variation_ros::viridis(1.0), 2));
}

TEST_F(LegendTest, GrowsWithItsTextAndItsNote) {
  const QImage small = legendImage(sixSigma(), 12), large = legendImage(sixSigma(), 24);
  EXPECT_GT(large.height(), 3 * small.height() / 2);
  cable_variation::Legend noted = sixSigma();
  for (int i = 0; i < 40; ++i) noted.note += "words ";
  const QImage image = legendImage(noted, 12);
  EXPECT_GT(image.height(), small.height());
  EXPECT_LT(image.width(), 18 * 12);  // wrapped at 16 text heights, and a margin
}

}  // namespace
}  // namespace cable_variation_rviz
