#include <cmath>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <cable_variation/util/quantity.h>

namespace cable_variation {
namespace {

std::string refusal(const std::string& text, const Quantity& quantity) {
  try {
    parseQuantity(text, quantity);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

struct Case {
  const char* text;
  const Quantity& quantity;
  double si;
};

TEST(Quantity, takesUnitsToSi) {
  const Case cases[] = {
      {"0.25", quantity::length, 0.25},
      {"312 mm", quantity::length, 0.312},
      {"4.0 cm", quantity::length, 0.04},
      {"-3mm", quantity::length, -0.003},
      {"+.5 um", quantity::length, 5e-7},
      {"10 \u00b5m", quantity::length, 1e-5},
      {"2 in", quantity::length, 0.0508},
      {"1e-2 m", quantity::length, 0.01},
      {"180 deg", quantity::angle, M_PI},
      {"90\u00b0", quantity::angle, M_PI / 2.0},
      {"1.5 turns", quantity::angle, 3.0 * M_PI},
      {"2 rev", quantity::angle, 4.0 * M_PI},
      {"5 mrad", quantity::angle, 0.005},
      {"2 kN", quantity::force, 2000.0},
      {"3 kg m/s^2", quantity::force, 3.0},
      {"10 N mm", quantity::moment, 0.01},
      {"10 N*mm", quantity::moment, 0.01},
      {"2 J", quantity::moment, 2.0},
      {"5 N/mm", quantity::spring, 5000.0},
      {"0.1 N mm/rad", quantity::torsion_spring, 1e-4},
      {"1 N m/deg", quantity::torsion_spring, 180.0 / M_PI},
      {"7 N m", quantity::torsion_spring, 7.0},
      {"100 MPa", quantity::pressure, 1e8},
      {"0.2 GPa", quantity::pressure, 2e8},
      {"3 N/mm^2", quantity::pressure, 3e6},
      {"3 N/mm2", quantity::pressure, 3e6},
      {"3 N/mm\u00b2", quantity::pressure, 3e6},
      {"1200 kg/m^3", quantity::density, 1200.0},
      {"1.2 g/cm^3", quantity::density, 1200.0},
      {"2 g/m", quantity::mass_per_length, 0.002},
      {"6 N m^2", quantity::bending_stiffness, 6.0},
      {"6e4 N\u00b7mm\u00b2", quantity::bending_stiffness, 0.06},
      {"4 1/m", quantity::curvature, 4.0},
      {"4 rad/m", quantity::curvature, 4.0},
      {"4 m^-1", quantity::curvature, 4.0},
      {"4/m", quantity::curvature, 4.0},
      {"20 %", quantity::number, 0.2},
      {"9.81 m/s^2", quantity::acceleration, 9.81},
  };
  for (const Case& c : cases) {
    EXPECT_NEAR(parseQuantity(c.text, c.quantity), c.si, 1e-14 * (1.0 + std::abs(c.si))) << c.text;
  }
}

TEST(Quantity, refusesAnotherDimension) {
  EXPECT_EQ(refusal("5 deg", quantity::length),
            "'5 deg' has the wrong unit; expected a length, e.g. '312 mm'");
  EXPECT_NE(refusal("5 m", quantity::angle), "");
  EXPECT_NE(refusal("5 rad", quantity::number), "");
  EXPECT_NE(refusal("5 m", quantity::number), "");
  EXPECT_NE(refusal("5 N", quantity::spring), "");
  EXPECT_NE(refusal("5 kg/m^2", quantity::density), "");
  EXPECT_NE(refusal("5 %", quantity::length), "");
}

TEST(Quantity, refusesWhatIsNoFiniteNumber) {
  for (const char* text : {"", " ", "m", "mm 5", "abc", "nan", "inf", "-.inf", "0x", ".", "-", "e5", "--1"}) {
    EXPECT_NE(refusal(text, quantity::length), "") << text;
  }
  EXPECT_EQ(refusal("1e400", quantity::length),
            "'1e400' is not a finite number; expected a length, e.g. '312 mm'");
}

TEST(Quantity, refusesUnitsItDoesNotKnow) {
  EXPECT_NE(refusal("5 1", quantity::number), "");
  EXPECT_EQ(refusal("5 mn", quantity::length),
            "unknown unit 'mn' in '5 mn'; expected a length, e.g. '312 mm'; did you mean 'mm'? known: m, cm, "
            "mm, um, "
            "in, ft");
  EXPECT_EQ(
      refusal("5 NM", quantity::moment),
      "unknown unit 'NM' in '5 NM'; expected a moment, e.g. '0.1 N m'; did you mean 'N m'? known: N m, N mm, "
      "kN m, mN m");
  EXPECT_EQ(refusal("5 parsec", quantity::force),
            "unknown unit 'parsec' in '5 parsec'; expected a force, e.g. '10 N'; known: N, kN, mN, lbf");
  EXPECT_EQ(refusal("5,3 m", quantity::length),
            "',3 m' is no unit in '5,3 m' (a number has a decimal point, and no comma); expected a length, "
            "e.g. '312 "
            "mm'; known: m, cm, mm, um, in, ft");
  for (const char* text :
       {"5 parsec", "5 m;", "5 m 6", "5 5", "5,3 m", "1.2.3", "5 m^", "5 m/", "5 m-", "5 1", "5 11/m"}) {
    EXPECT_NE(refusal(text, quantity::length), "") << text;
  }
}

TEST(Range, holdsItsBounds) {
  EXPECT_FALSE(Range::positive().holds(0.0));
  EXPECT_TRUE(Range::notNegative().holds(0.0));
  EXPECT_FALSE(Range::any().holds(std::nan("")));
  EXPECT_FALSE(Range::any().holds(HUGE_VAL));
  const Range closed{-1.0, 2.0, false};
  EXPECT_TRUE(closed.holds(-1.0));
  EXPECT_TRUE(closed.holds(2.0));
  EXPECT_FALSE(closed.holds(2.0000001));
  EXPECT_EQ(closed.text("m"), "between -1 and 2 m");
}

}  // namespace
}  // namespace cable_variation
