#include <cable_variation/util/enum_rows.h>

#include <array>

#include <gtest/gtest.h>

namespace cable_variation {
namespace {

enum class Fruit { apple, pear, plum };
enum class Single { one };

struct Price {
  Fruit fruit;
  double price;
};

TEST(EnumRows, countsEnumerators) {
  EXPECT_EQ(enumeratorCount<Fruit>(), 3U);
  EXPECT_EQ(enumeratorCount<Single>(), 1U);
  EXPECT_TRUE((isEnumerator<Fruit, Fruit::plum>()));
  EXPECT_FALSE((isEnumerator<Fruit, static_cast<Fruit>(3)>()));
}

TEST(EnumRows, oneRowForEachInTheirOrder) {
  using Two = std::array<Price, 2>;
  using Three = std::array<Price, 3>;
  using Four = std::array<Price, 4>;
  const Price apple{Fruit::apple, 1.0}, pear{Fruit::pear, 2.0}, plum{Fruit::plum, 3.0};
  EXPECT_TRUE(hasRowOfEach(Three{apple, pear, plum}, &Price::fruit));
  EXPECT_FALSE(hasRowOfEach(Three{apple, plum, pear}, &Price::fruit)) << "out of order";
  EXPECT_FALSE(hasRowOfEach(Three{apple, pear}, &Price::fruit)) << "the last is left empty";
  EXPECT_FALSE(hasRowOfEach(Two{apple, pear}, &Price::fruit)) << "one is missing";
  EXPECT_FALSE(hasRowOfEach(Four{apple, pear, plum, plum}, &Price::fruit)) << "one is there twice";
}

}  // namespace
}  // namespace cable_variation
