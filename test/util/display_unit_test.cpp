#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <cable_variation/util/display_unit.h>

namespace cable_variation {
namespace {

TEST(DisplayUnit, isWhatPeopleRead) {
  EXPECT_EQ(displayValue(0.312, "m"), "312 mm");
  EXPECT_EQ(displayValue(M_PI / 36.0, "rad"), "5 deg");
  EXPECT_EQ(displayValue(2.5e6, "Pa"), "2.5 MPa");
  EXPECT_EQ(displayValue(0.15, "1"), "15 %");
  EXPECT_EQ(displayValue(7.475123, "N"), "7.475 N");
  EXPECT_EQ(displayValue(0.2954, "N m", 3), "0.295 N m");
  EXPECT_EQ(displayValue(-0.0, "m"), "0 mm");
}

TEST(DisplayUnit, hasWordsForWhatIsNotFinite) {
  EXPECT_EQ(displayValue(std::numeric_limits<double>::infinity(), "m"), "infinite");
  EXPECT_EQ(displayNumber(-std::numeric_limits<double>::infinity(), "m"), "-infinite");
  EXPECT_EQ(displayValue(std::nan(""), "m"), "-");
}

TEST(DisplayUnit, readsWhatIsTyped) {
  EXPECT_DOUBLE_EQ(parseDisplayed("312", "m"), 0.312);
  EXPECT_DOUBLE_EQ(parseDisplayed("31.2 cm", "m"), 0.312);
  EXPECT_DOUBLE_EQ(parseDisplayed("0.05 rad", "rad"), 0.05);
  EXPECT_DOUBLE_EQ(parseDisplayed("-5", "rad"), -M_PI / 36.0);
  EXPECT_DOUBLE_EQ(parseDisplayed("50", "1"), 0.5);
  EXPECT_DOUBLE_EQ(parseDisplayed("50 %", "1"), 0.5);
  EXPECT_DOUBLE_EQ(parseDisplayed("1200", "N"), 1200.0);
  EXPECT_DOUBLE_EQ(parseDisplayed("0.07", "N m^2"), 0.07);
  for (const char* text : {"", "five", "5 kg", "5 NM", "1e999"}) {
    EXPECT_THROW(parseDisplayed(text, "m"), std::invalid_argument) << text;
  }
}

TEST(DisplayUnit, whatIsShownInFullIsReadBack) {
  for (const char* unit : {"m", "rad", "Pa", "1", "N", "kg/m"}) {
    for (const double value : {0.312, 1e-9, -2.5, 0.0, 123456.789}) {
      const double read = parseDisplayed(displayValue(value, unit, 17), unit);
      EXPECT_NEAR(read, value, 1e-15 * std::abs(value)) << unit;
    }
  }
}

}  // namespace
}  // namespace cable_variation
