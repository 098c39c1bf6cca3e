// The colour map against entries of its published table, and values outside a scale.
#include <ros_interface/markers/colour_map.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace cable_variation_ros {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(Viridis, IsThePublishedTable) {
  struct Entry {
    int index;  // of 256
    Eigen::Vector3d rgb;
  };
  // Between the control points, where the interpolation is worst, and both ends.
  const Entry published[] = {{0, {0.267004, 0.004874, 0.329415}},   {7, {0.276022, 0.044167, 0.370164}},
                             {8, {0.277018, 0.050344, 0.375715}},   {22, {0.283187, 0.125848, 0.444960}},
                             {38, {0.273006, 0.204520, 0.501721}},  {52, {0.252194, 0.269783, 0.531579}},
                             {68, {0.221989, 0.339161, 0.548752}},  {98, {0.169646, 0.456262, 0.558030}},
                             {128, {0.127568, 0.566949, 0.550556}}, {142, {0.119699, 0.618490, 0.536347}},
                             {158, {0.150148, 0.676631, 0.506589}}, {172, {0.220124, 0.725509, 0.466226}},
                             {200, {0.440137, 0.811138, 0.340967}}, {218, {0.616293, 0.852709, 0.230052}},
                             {232, {0.762373, 0.876424, 0.137064}}, {236, {0.804182, 0.882046, 0.114965}},
                             {244, {0.886271, 0.892374, 0.095374}}, {248, {0.926106, 0.897330, 0.104071}},
                             {251, {0.955300, 0.901065, 0.118128}}, {255, {0.993248, 0.906157, 0.143936}}};
  for (const Entry& entry : published) {
    const Eigen::Vector3d found = viridis(entry.index / 255.0);
    EXPECT_LT((found - entry.rgb).lpNorm<Eigen::Infinity>(), 0.004)
        << entry.index << ": " << found.transpose();
  }
}

TEST(Viridis, BrightensAllTheWay) {
  // Relative luminance of the sRGB primaries (ITU-R BT.709), on the encoded values.
  const Eigen::Vector3d weight(0.2126, 0.7152, 0.0722);
  for (int i = 1; i <= 1000; ++i) {
    EXPECT_GT(weight.dot(viridis(i / 1000.0)), weight.dot(viridis((i - 1) / 1000.0))) << i;
  }
}

TEST(Viridis, EndsHoldBeyondTheRangeAndNoNumberIsGrey) {
  EXPECT_EQ(viridis(-3.0), viridis(0.0));
  EXPECT_EQ(viridis(std::numeric_limits<double>::infinity()), viridis(1.0));
  EXPECT_EQ(viridis(kNan), Eigen::Vector3d::Constant(0.5));
}

TEST(ColourScale, SpreadsItsRange) {
  const ColourScale scale(2.0, 6.0);
  EXPECT_EQ(scale(3.0), viridis(0.25));
  EXPECT_EQ(scale(7.0), viridis(1.0));
  EXPECT_FLOAT_EQ(scale.rgba(6.0).r, 0.993248F);
  EXPECT_FLOAT_EQ(scale.rgba(6.0).a, 1.0F);
}

TEST(ColourScale, OfNoRangeIsOneColour) {
  const ColourScale scale(2.0, 2.0);
  EXPECT_EQ(scale(2.0), viridis(0.0));
  EXPECT_EQ(scale(kNan), viridis(kNan));
}

TEST(ColourScale, RefusesBoundsThatAreNone) {
  EXPECT_THROW(ColourScale(1.0, 0.0), std::invalid_argument);
  EXPECT_THROW(ColourScale(kNan, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace cable_variation_ros
