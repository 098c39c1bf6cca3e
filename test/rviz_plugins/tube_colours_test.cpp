// What colours cables have.
#include <rviz_plugins/displays/tube_colours.h>

#include <cmath>

#include <gtest/gtest.h>

#include <ros_interface/markers/marker_colours.h>

namespace cable_variation_rviz {
namespace {

using cable_variation::CableTube;
using cable_variation::CableTubes;

/// A cable with curvature, and the same elsewhere with variation.
CableTubes two() {
  CableTubes tubes;
  for (const char* name : {"curvature", "variation"}) {
    CableTube tube;
    tube.cable = "main";
    tube.radius = {0.1F, 0.1F, 0.1F};
    cable_variation::CableQuantity quantity;
    quantity.name = name;
    quantity.unit = "mm";
    quantity.minimum = 1.0F;
    quantity.maximum = 5.0F;
    quantity.values = {1.0F, 3.0F, 7.0F};
    tube.quantities.push_back(quantity);
    tubes.cables.push_back(tube);
  }
  tubes.cables[1].elsewhere = true;
  return tubes;
}

TEST(TubeColours, AreThoseOfTheQuantityWithinItsRange) {
  const auto colors = stationColours(two(), 0, {"curvature", 1.0, 5.0, ColourMap::viridis, 0.5F});
  ASSERT_EQ(colors.size(), 3U);
  for (const auto& [i, share] : {std::pair(0, 0.0), std::pair(1, 0.5), std::pair(2, 1.0)}) {
    const auto& color = colors[static_cast<std::size_t>(i)];
    EXPECT_TRUE(color.head<3>().isApprox(mapped(ColourMap::viridis, share).cast<float>(), 1e-5F)) << i;
    EXPECT_EQ(color[3], 0.5F);
  }
}

TEST(TubeColours, AreTheCablesOwnWithoutTheQuantity) {
  const auto colors = stationColours(two(), 0, {"force", 0.0, 1.0});
  ASSERT_EQ(colors.size(), 3U);
  EXPECT_TRUE(colors[1].isApprox(cable_variation_ros::cableColour(0).cast<float>()));
}

TEST(TubeColours, OfWhatIsElsewhereAreThereOnlyWithItsQuantity) {
  EXPECT_TRUE(stationColours(two(), 1, {"curvature", 1.0, 5.0}).empty());
  EXPECT_EQ(stationColours(two(), 1, {"variation", 1.0, 5.0}).size(), 3U);
}

TEST(TubeColours, OfOutdatedCablesAreGrey) {
  CableTubes tubes = two();
  tubes.outdated = true;
  const auto colors = stationColours(tubes, 0, {"curvature", 1.0, 5.0});
  ASSERT_EQ(colors.size(), 3U);
  EXPECT_TRUE(colors[0].isApprox(cable_variation_ros::kOutdatedGrey.cast<float>()));
  EXPECT_TRUE(stationColours(tubes, 1, {"variation", 1.0, 5.0}).empty());
}

TEST(TubeColours, OfWhatIsNoNumberAreGrey) {
  CableTubes tubes = two();
  tubes.cables[0].quantities[0].values[1] = std::nanf("");
  const auto color = stationColours(tubes, 0, {"curvature", 1.0, 5.0})[1];
  EXPECT_EQ(color[0], color[1]);
  EXPECT_EQ(color[1], color[2]);
}

TEST(QuantityRanges, AreOfAllCables) {
  CableTubes tubes = two();
  tubes.cables[1].quantities[0].name = "curvature";
  tubes.cables[1].quantities[0].maximum = 9.0F;
  const auto range = rangeOf(tubes, "curvature");
  ASSERT_TRUE(range);
  EXPECT_EQ(range->minimum, 1.0);
  EXPECT_EQ(range->maximum, 9.0);
  EXPECT_EQ(range->unit, "mm");
  EXPECT_FALSE(rangeOf(tubes, "force"));
  EXPECT_EQ(quantitiesOf(two()), (std::vector<std::string>{"curvature", "variation"}));
}

TEST(ColourMaps, GoFromEndToEnd) {
  EXPECT_TRUE(mapped(ColourMap::viridis_reversed, 0.0).isApprox(mapped(ColourMap::viridis, 1.0)));
  EXPECT_LT(mapped(ColourMap::grey, 0.0).sum(), 0.5);
  EXPECT_GT(mapped(ColourMap::grey, 2.0).sum(), 2.5);
  EXPECT_EQ(mapped(ColourMap::viridis, 3.0, 3.0, 3.0), mapped(ColourMap::viridis, 0.0));
}

}  // namespace
}  // namespace cable_variation_rviz
