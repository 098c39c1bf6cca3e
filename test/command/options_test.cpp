// What may stand on a command line, and what is said of anything else.
#include <command/options.h>

#include <limits>

#include <gtest/gtest.h>

namespace cable_variation_command {
namespace {

struct Read {
  Read() {
    options_.word("SCENE", scene_, "a scene file");
    options_.text("report", "NAME", report_, "write NAME.html");
    options_.texts("variables", "NAME", variables_, "that vary");
    options_.flag("motion_only", motion_only_, "nothing varies");
    options_.number("margin", "LENGTH", "m", margin_, "before inflation");
    options_.number("probability", "SHARE", "1", probability_, "held");
    options_.number("from_time", "TIME", "s", time_, "of the motions");
    options_.count("sections", "COUNT", sections_, "along each cable");
    options_.count("seed", "NUMBER", seed_, "of samples");
  }

  Options options_;
  std::string scene_, report_;
  std::vector<std::string> variables_;
  bool motion_only_ = false;
  double margin_ = 0.0, probability_ = 0.0, time_ = 0.0;
  std::uint32_t sections_ = 0;
  std::uint64_t seed_ = 0;
};

class OptionsTest : public testing::Test, protected Read {};

/// What is said of words that are refused.
std::string refusalOf(const std::vector<std::string>& words) {
  try {
    Read().options_.read(words);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

TEST_F(OptionsTest, ValuesArriveWhereTheyBelong) {
  options_.read({"a.yaml", "--report", "r", "--variables", "x", "y,z", "--motion_only", "--margin", "0.2mm",
                 "--probability=99.73%", "--from_time", "200ms", "--sections", "9", "--seed",
                 "18446744073709551615"});
  EXPECT_EQ(scene_, "a.yaml");
  EXPECT_EQ(report_, "r");
  EXPECT_EQ(variables_, (std::vector<std::string>{"x", "y", "z"}));
  EXPECT_TRUE(motion_only_);
  EXPECT_DOUBLE_EQ(margin_, 2e-4);
  EXPECT_DOUBLE_EQ(probability_, 0.9973);
  EXPECT_DOUBLE_EQ(time_, 0.2);
  EXPECT_EQ(sections_, 9U);
  EXPECT_EQ(seed_, std::numeric_limits<std::uint64_t>::max());
}

TEST_F(OptionsTest, ALetterStandsForAnOption) {
  options_.shortName('r', "report");
  options_.read({"a.yaml", "--variables", "x", "-r", "page", "--margin", "-1"});
  EXPECT_EQ(report_, "page");
  EXPECT_EQ(variables_, std::vector<std::string>{"x"});
  EXPECT_DOUBLE_EQ(margin_, -1.0);
  EXPECT_THROW(options_.shortName('x', "nothing"), UsageError);
}

TEST_F(OptionsTest, WhatIsLeftOutStaysAsItIs) {
  options_.read({"a.yaml"});
  EXPECT_TRUE(variables_.empty());
  EXPECT_FALSE(motion_only_);
  EXPECT_EQ(seed_, 0U);
}

TEST_F(OptionsTest, ADashInANameIsAnUnderscoreAndANegativeNumberIsAValue) {
  options_.read({"a.yaml", "--from-time", "-1", "--motion-only"});
  EXPECT_DOUBLE_EQ(time_, -1.0);
  EXPECT_TRUE(motion_only_);
}

TEST_F(OptionsTest, WhatIsWrongIsNamedWithWhatWasExpected) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"a.yaml", "--marign", "1"}, "unknown option '--marign'; did you mean '--margin'?"},
      {{"a.yaml", "--margin", "1mm", "--margin", "2mm"}, "--margin: is given twice"},
      {{"a.yaml", "--from_time", "1", "--from-time", "1"}, "--from_time: is given twice"},
      {{"a.yaml", "--margin"}, "--margin: has no value, expected LENGTH"},
      {{"a.yaml", "--margin", "--seed", "1"}, "--margin: has no value"},
      {{"a.yaml", "--margin", "1 deg"}, "--margin: "},
      {{"a.yaml", "--margin", "wide"}, "--margin: "},
      {{"a.yaml", "--variables"}, "--variables: has no value, expected NAME ..."},
      {{"a.yaml", "--variables", ","}, "--variables: is empty"},
      {{"a.yaml", "--motion_only=yes"}, "--motion_only: takes no value"},
      {{"a.yaml", "--sections", "-1"}, "--sections: is '-1', expected a whole number, 1 to 4294967295"},
      {{"a.yaml", "--sections", "0"}, "--sections: is '0', expected a whole number, 1 to "},
      {{"a.yaml", "--seed=0"}, "--seed: is '0', expected"},
      {{"a.yaml", "--sections", "4294967296"}, "--sections: is '4294967296'"},
      {{"a.yaml", "--seed", "1.5"}, "--seed: is '1.5'"},
      {{"a.yaml", "b.yaml"}, "unexpected 'b.yaml'"},
      {{"a.yaml", "--report", "r", "s"}, "unexpected 's'"},
      {{}, "SCENE is missing"},
      {{"--seed", "1"}, "SCENE is missing"},
  };
  for (const auto& [words, part] : cases) {
    const std::string said = refusalOf(words);
    EXPECT_NE(said.find(part), std::string::npos) << "expected " << part << " in: " << said;
  }
}

TEST_F(OptionsTest, AnOptionThatIsThereAlreadyIsAFaultOfTheProgram) {
  EXPECT_THROW(options_.flag("seed", motion_only_, "again"), std::logic_error);
}

TEST_F(OptionsTest, TheHelpNamesAllOfThem) {
  const std::string help = options_.help();
  for (const char* part :
       {"SCENE", "--report NAME", "--variables NAME ...", "--motion_only", "write NAME.html"})
    EXPECT_NE(help.find(part), std::string::npos) << help;
}

}  // namespace
}  // namespace cable_variation_command
