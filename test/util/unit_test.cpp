#include <cable_variation/util/unit.h>

#include <cctype>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <cable_variation/util/quantity.h>

namespace cable_variation {
namespace {

struct Case {
  const char* text;
  double factor;
  Dimension dimension;
};

TEST(Unit, compoundsAreReadHoweverTheyAreWritten) {
  const Dimension moment{1, 2, -2, 0}, stiffness{1, 3, -2, 0}, spring{1, 0, -2, 0}, torsion{1, 2, -2, -1},
      pressure{1, -1, -2, 0}, per_length{1, -1, 0, 0}, curvature{0, -1, 0, 0};
  const Case cases[] = {
      {"Nm", 1.0, moment},
      {"Nmm", 1e-3, moment},
      {"Ncm", 1e-2, moment},
      {"kNm", 1e3, moment},
      {"mNm", 1e-3, moment},
      {"kNmm", 1.0, moment},
      {"N m", 1.0, moment},
      {"N*m", 1.0, moment},
      {"N.m", 1.0, moment},
      {"N-m", 1.0, moment},
      {"N\u00b7m", 1.0, moment},
      {"N\u22c5mm", 1e-3, moment},
      {"N \u00b7 mm", 1e-3, moment},
      {"lbf in", 0.45359237 * 9.80665 * 0.0254, moment},
      {"lbfin", 0.45359237 * 9.80665 * 0.0254, moment},
      {"Nm^2", 1.0, stiffness},
      {"Nm2", 1.0, stiffness},
      {"Nm\u00b2", 1.0, stiffness},
      {"Nmm^2", 1e-6, stiffness},
      {"Nmm\u00b2", 1e-6, stiffness},
      {"N mm\u00b2", 1e-6, stiffness},
      {"MPa mm^4", 1e-6, stiffness},
      {"N/mm", 1e3, spring},
      {"N mm\u207b\u00b9", 1e3, spring},
      {"N/(mm)", 1e3, spring},
      {"Nm/rad", 1.0, torsion},
      {"Nmm/rad", 1e-3, torsion},
      {"Nmm/deg", 1e-3 * 180.0 / M_PI, torsion},
      {"MPa", 1e6, pressure},
      {"N/mm\u00b2", 1e6, pressure},
      {"N/(mm mm)", 1e6, pressure},
      {"kg/(m s^2)", 1.0, pressure},
      {"kg m^-1 s^-2", 1.0, pressure},
      {"bar", 1e5, pressure},
      {"kg/m", 1.0, per_length},
      {"g/m", 1e-3, per_length},
      {"g/mm", 1.0, per_length},
      {"1/m", 1.0, curvature},
      {"1/mm", 1e3, curvature},
      {"/m", 1.0, curvature},
      {"rad/m", 1.0, {0, -1, 0, 1}},
      {"turns", 2.0 * M_PI, {0, 0, 0, 1}},
      {"mm\u00b2", 1e-6, {0, 2, 0, 0}},
      {"t/mm\u00b3", 1e12, {1, -3, 0, 0}},
  };
  for (const Case& c : cases) {
    const Unit unit = parseUnit(plainSigns(c.text));
    EXPECT_NEAR(unit.factor / c.factor, 1.0, 1e-14) << c.text;
    EXPECT_EQ(unit.dimension.kilogram, c.dimension.kilogram) << c.text;
    EXPECT_EQ(unit.dimension.metre, c.dimension.metre) << c.text;
    EXPECT_EQ(unit.dimension.second, c.dimension.second) << c.text;
    EXPECT_EQ(unit.dimension.radian, c.dimension.radian) << c.text;
  }
}

// Any product of symbols with powers, written in any of the ways, has the product's factor and dimension.
TEST(Unit, randomProducts) {
  std::mt19937 random(7);
  const std::vector<std::string> symbols = unitSymbols();
  const std::vector<std::string> times{" ", "*", " * ", "\u00b7", "  "};
  const std::vector<std::string> squares{"^2", "2", "\u00b2"};
  const auto any = [&](std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
  };
  for (int trial = 0; trial < 2000; ++trial) {
    std::string text;
    double factor = 1.0;
    Dimension sum;
    for (std::size_t i = 0, count = 1 + any(3); i < count; ++i) {
      const std::string symbol = symbols[any(symbols.size())];
      const Unit unit = parseUnit(symbol);
      const bool over = i > 0 && any(2) == 0;
      const bool square = any(3) == 0;
      const int power = (over ? -1 : 1) * (square ? 2 : 1);
      text += i == 0 ? "" : over ? "/" : times[any(times.size())];
      text += symbol + (square ? squares[any(squares.size())] : "");
      factor *= std::pow(unit.factor, power);
      sum.kilogram += power * unit.dimension.kilogram;
      sum.metre += power * unit.dimension.metre;
      sum.second += power * unit.dimension.second;
      sum.radian += power * unit.dimension.radian;
    }
    const Unit unit = parseUnit(plainSigns(text));
    EXPECT_NEAR(unit.factor / factor, 1.0, 1e-12) << text;
    EXPECT_EQ(unit.dimension.kilogram, sum.kilogram) << text;
    EXPECT_EQ(unit.dimension.metre, sum.metre) << text;
    EXPECT_EQ(unit.dimension.second, sum.second) << text;
    EXPECT_EQ(unit.dimension.radian, sum.radian) << text;
  }
}

TEST(Unit, whatIsNoneIsRefused) {
  for (const char* text : {"parsec", "m^",  "m/",    "m-",  "m^-", "m12",  "1",
                           "11/m",   "m 6", "(m",    "m)",  "()x", "m//s", "m**s",
                           "*m",     "m;",  "mm Nq", "mmN", "NmN", "Nkg",  "((((((((((m))))))))))",
                           "\xff"}) {
    EXPECT_THROW(parseUnit(text), std::invalid_argument) << text;
  }
}

TEST(Unit, aSquareOfTheNumberIsNoDigit) {
  EXPECT_THROW(parseQuantity("10\u00b2", quantity::number), std::invalid_argument);
  EXPECT_THROW(parseQuantity("10\u00b2 mm", quantity::length), std::invalid_argument);
}

// Every usual unit of every quantity is one, also in the wrong case, which it is then proposed for.
TEST(Unit, usualUnitsFitAndAreProposed) {
  for (const Quantity* quantity :
       {&quantity::length, &quantity::angle, &quantity::force, &quantity::moment, &quantity::acceleration,
        &quantity::pressure, &quantity::stress, &quantity::energy, &quantity::density,
        &quantity::mass_per_length, &quantity::stretch_stiffness, &quantity::bending_stiffness,
        &quantity::spring, &quantity::torsion_spring, &quantity::curvature}) {
    const std::string list = quantity->units;
    for (std::size_t start = 0; start < list.size();) {
      const std::size_t end = std::min(list.find(", ", start), list.size());
      const std::string unit = list.substr(start, end - start);
      start = end + 2;
      EXPECT_TRUE(readQuantity("1 " + unit, *quantity).has_unit) << unit;
      std::string wrong = unit;
      for (char& c : wrong) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
      try {
        readQuantity("1 " + wrong, *quantity);
      } catch (const std::invalid_argument& error) {
        const std::string what = error.what();
        if (what.find("wrong unit") != std::string::npos) continue;  // MN for mN: another unit
        EXPECT_NE(what.find("did you mean '"), std::string::npos) << what;
        EXPECT_NE(what.find("known: " + list), std::string::npos) << what;
      }
    }
  }
}

}  // namespace
}  // namespace cable_variation
