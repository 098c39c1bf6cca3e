// Numbers as text: beside the C library's own in the plain locale, over doubles of every size, and in a
// locale that writes commas, where there is one.
#include <cable_variation/util/number_text.h>

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

namespace cable_variation {
namespace {

// Any bit pattern that is a finite number, and numbers as people write them.
std::vector<double> numbers() {
  std::mt19937_64 random(7);
  std::vector<double> values = {0.0,
                                -0.0,
                                0.1,
                                0.3,
                                1.0 / 3.0,
                                100000.0,
                                1e22,
                                1e23,
                                5e-324,
                                2.2250738585072014e-308,
                                std::numeric_limits<double>::max(),
                                std::numeric_limits<double>::lowest()};
  while (values.size() < 20000) {
    const std::uint64_t bits = random();
    double value;
    std::memcpy(&value, &bits, sizeof value);
    if (std::isfinite(value)) values.push_back(value);
    values.push_back(std::round(1e4 * std::ldexp(static_cast<double>(bits), -64)) / 1e4);
  }
  return values;
}

bool same(double a, double b) { return a == b && std::signbit(a) == std::signbit(b); }

TEST(number_text, reads_back_as_the_same_number) {
  for (const double value : numbers()) {
    const std::string text = numberText(value);
    EXPECT_LE(text.size(), 24u) << text;
    double read = std::nan("");
    const auto [end, error] = readNumber(text, read);
    EXPECT_EQ(end, text.data() + text.size()) << text;
    EXPECT_EQ(error, std::errc()) << text;
    EXPECT_TRUE(same(read, value)) << text;
    EXPECT_TRUE(same(std::strtod(text.c_str(), nullptr), value)) << text;
  }
  EXPECT_EQ(numberText(0.1), "0.1");
  EXPECT_EQ(numberText(-0.25), "-0.25");
  EXPECT_EQ(numberText(HUGE_VAL), "inf");
  EXPECT_EQ(numberText(-HUGE_VAL), "-inf");
  EXPECT_EQ(numberText(std::nan("")), "nan");
}

TEST(number_text, rounds_to_digits_as_printf_does) {
  for (const double value : numbers()) {
    for (const int digits : {1, 3, 4, 17}) {
      char expected[64];
      std::snprintf(expected, sizeof expected, "%.*g", digits, value);
      EXPECT_EQ(numberText(value, digits), expected);
    }
  }
}

TEST(number_text, reads_what_the_text_starts_with) {
  struct Case {
    const char* text;
    std::size_t length;
    double value;
  };
  for (const Case& one :
       std::vector<Case>{{"1.5 mm", 3, 1.5},
                         {"-.5e1x", 5, -5.0},
                         {"5.", 2, 5.0},
                         {"1e", 1, 1.0},
                         {"1e+", 1, 1.0},
                         {"2e-3", 4, 2e-3},
                         {"1,5", 1, 1.0},
                         {"0x10", 1, 0.0},
                         {"00012", 5, 12.0},
                         {"0e99999", 7, 0.0},
                         {"-0.0", 4, -0.0},
                         {"inf", 3, HUGE_VAL},
                         {"-Infinity!", 9, -HUGE_VAL},
                         {"infinit", 3, HUGE_VAL},
                         {"0.1000000000000000055511151231257827021181583404541015625", 57, 0.1},
                         {"9007199254740993", 16, 9007199254740992.0}}) {
    double value = 7.0;
    const std::string_view text = one.text;
    const auto [end, error] = readNumber(text, value);
    EXPECT_EQ(error, std::errc()) << text;
    EXPECT_EQ(static_cast<std::size_t>(end - text.data()), one.length) << text;
    EXPECT_TRUE(same(value, one.value)) << text << ' ' << value;
  }
  double value = 7.0;
  const std::string_view nan = "nan";
  EXPECT_EQ(readNumber(nan, value).ec, std::errc());
  EXPECT_TRUE(std::isnan(value));
}

TEST(number_text, says_what_is_no_number) {
  for (const std::string_view text :
       {"", "-", ".", "-.", "e5", ".e5", " 1", "+1", "in", "na", "--1", "abc"}) {
    double value = 7.0;
    const auto [end, error] = readNumber(text, value);
    EXPECT_EQ(error, std::errc::invalid_argument) << text;
    EXPECT_EQ(end, text.data()) << text;
    EXPECT_EQ(value, 7.0) << text;
  }
  for (const std::string_view text : {"1e400", "-1e400", "1e-400", "-1e-400"}) {
    double value = 7.0;
    const auto [end, error] = readNumber(text, value);
    EXPECT_EQ(error, std::errc::result_out_of_range) << text;
    EXPECT_EQ(end, text.data() + text.size()) << text;
    EXPECT_EQ(value, 7.0) << text;
  }
}

TEST(number_text, does_not_read_past_the_text) {
  const std::string_view text = std::string_view("123456").substr(0, 3);
  double value = 0.0;
  EXPECT_EQ(readNumber(text, value).ptr, text.data() + 3);
  EXPECT_EQ(value, 123.0);
}

TEST(number_text, has_a_point_where_the_locale_has_a_comma) {
  const std::string before = std::setlocale(LC_NUMERIC, nullptr);
  bool comma = false;
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE.utf8", "fr_FR.utf8", "de_DE", "fr_FR"}) {
    if (std::setlocale(LC_NUMERIC, name) != nullptr) {
      comma = true;
      break;
    }
  }
  if (!comma) GTEST_SKIP() << "no locale with a decimal comma is installed";
  double value = 0.0;
  const auto [end, error] = readNumber("1.5", value);
  const std::string text = numberText(0.25), rounded = numberText(0.25, 2);
  std::setlocale(LC_NUMERIC, before.c_str());
  EXPECT_EQ(error, std::errc());
  EXPECT_EQ(value, 1.5);
  EXPECT_EQ(text, "0.25");
  EXPECT_EQ(rounded, "0.25");
  EXPECT_NE(end, nullptr);
}

}  // namespace
}  // namespace cable_variation
