#include <cable_variation/scene/measure_traits.h>

#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace cable_variation {
namespace {

TEST(MeasureTraits, everyTypeHasItsRowAndItsName) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < measureTraits().size(); ++i) {
    const auto type = static_cast<Measure::Type>(i);
    EXPECT_EQ(traitsOf(type).type, type);
    EXPECT_STREQ(toString(type), traitsOf(type).name);
    EXPECT_TRUE(names.insert(toString(type)).second) << toString(type) << " is there twice";
  }
  EXPECT_THROW(traitsOf(static_cast<Measure::Type>(measureTraits().size())), std::out_of_range);
}

TEST(MeasureTraits, unitsAreThoseOfTheirQuantities) {
  for (const MeasureTraits& traits : measureTraits()) {
    const Unit unit = *traits.quantity->unit ? parseUnit(traits.quantity->unit) : Unit();
    EXPECT_TRUE(agree(unit.dimension, traits.quantity->dimension)) << traits.name;
    EXPECT_EQ(unit.factor, 1.0) << traits.name << " is not in SI units";
  }
}

TEST(MeasureTraits, everyTypeIsDescribedWhereScenesAre) {
  for (const char* path : {"../doc/scene_file.md", "../msg/MeasureInfo.msg"}) {
    std::ifstream file(path);
    const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    for (const MeasureTraits& traits : measureTraits())
      EXPECT_NE(text.find(traits.name), std::string::npos) << traits.name << " is not in " << path;
  }
}

}  // namespace
}  // namespace cable_variation
