// One document, whatever its line ends; nothing that hangs, explodes or is dropped in silence.
#include <cable_variation/scene_file/yaml_document.h>

#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <cable_variation/scene_file/yaml_cursor.h>

#include "cpu_time.h"

namespace cable_variation {
namespace {

// "LINE: MESSAGE" of the only fault; empty: none.
std::string faultOf(const std::string& text) {
  FaultList faults("scene.yaml");
  const YAML::Node node = readYamlDocument(text, faults);
  const auto found = faults.sorted();
  if (found.empty()) return "";
  EXPECT_EQ(found.size(), 1U);
  EXPECT_TRUE(node.IsNull());
  return std::to_string(found[0].line) + ": " + found[0].message;
}

YAML::Node read(const std::string& text) {
  FaultList faults("scene.yaml");
  YAML::Node node = readYamlDocument(text, faults);
  for (const SceneFault& fault : faults.sorted()) ADD_FAILURE() << toString(fault);
  return node;
}

const std::string kSecond = "a second document starts here ('---'); expected one scene in a file";

TEST(YamlDocument, aSecondOneIsRefusedWithItsLine) {
  EXPECT_EQ(faultOf("a: 1\n---\nb: 2\n"), "2: " + kSecond);
  EXPECT_EQ(faultOf("---\na: 1\n---\n"), "3: " + kSecond);
  EXPECT_EQ(faultOf("---\n---\na: 1\n"), "2: " + kSecond);
  EXPECT_EQ(faultOf("a: 1\n...\n# more\n---\nb: 2\n"), "4: " + kSecond);
  EXPECT_EQ(faultOf("a: |\n  x\n--- b\n"), "3: " + kSecond);
  EXPECT_EQ(faultOf("a: 1\n"), "");
  EXPECT_EQ(faultOf("# first\n---\na: 1\n"), "");
  EXPECT_EQ(faultOf("%YAML 1.2\n---\na: 1\n...\n"), "");
  EXPECT_EQ(faultOf("a: |\n  x\n  --- y\n"), "");
}

TEST(YamlDocument, marksAndLineEndsMakeNoDifference) {
  for (const std::string text : {"a: 1\nb: [2, 'x']\n", "a: 1\r\nb: [2, 'x']\r\n",
                                 "\xef\xbb\xbf"
                                 "a: 1\nb: [2, 'x']",
                                 "\xef\xbb\xbf# \xc3\xa4\r\na: 1\r\n\r\nb:\r\n  - 2\r\n  - 'x'\r\n"}) {
    const YAML::Node node = read(text);
    EXPECT_EQ(node["a"].as<int>(), 1);
    EXPECT_EQ(node["b"][1].as<std::string>(), "x");
  }
  EXPECT_EQ(faultOf("a: 1\r\nb: \xc3\xa4\r\n---\r\n"), "3: " + kSecond);
}

TEST(YamlDocument, whatIsNoText) {
  EXPECT_EQ(faultOf(std::string("a: 1\nb: \0\n", 10)), "2: a byte is 0; expected text");
  EXPECT_EQ(faultOf(std::string("\xff\xfe"
                                "a\0",
                                4)),
            "1: the file is in UTF-16; expected UTF-8");
  EXPECT_EQ(faultOf("a: 1\nb: \xe4\n"), "2: a character is not in UTF-8, in which scene files are");
  EXPECT_EQ(faultOf("a: \xc3"), "1: a character is not in UTF-8, in which scene files are");
}

TEST(YamlDocument, openQuotesAndTabs) {
  EXPECT_EQ(faultOf("a: 1\nb: 'x\nc: 2\n"), "2: not valid YAML: the quote ' is not closed");
  EXPECT_EQ(faultOf("a: \"x\\\"\n"), "1: not valid YAML: the quote \" is not closed");
  EXPECT_EQ(faultOf("\xef\xbb\xbf"
                    "a: \xc3\xa4\nb: 'it''s'\nc: \"a \\\" b\"\nd: x'y\n"),
            "");
  EXPECT_EQ(
      faultOf("a:\n  b: 1\n\tc: 2\n"),
      "3: not valid YAML: illegal tab when looking for indentation (line 3 is indented by a tab; YAML takes "
      "blanks)");
  EXPECT_EQ(faultOf("a:\n\t- 1\n"),
            "2: not valid YAML: illegal block entry (line 2 is indented by a tab; YAML takes blanks)");
}

TEST(YamlDocument, anchorsAliasesAndMergedMaps) {
  const std::string text =
      "base: &base {x: 1, y: 2}\n"
      "more: &more {y: 3, z: 4}\n"
      "one: {<<: *base, x: 5}\n"
      "two: {<<: [*base, *more]}\n"
      "same: *base\n"
      "odd: {<<: 3}\n";
  FaultList faults("scene.yaml");
  const YamlCursor root(readYamlDocument(text, faults), 1, "", faults);
  const auto entries = [&](const std::string& key) {
    std::string list;
    const auto map = root.find(key);
    for (const auto& [name, value] : map->entries()) list += name + value.text() + " ";
    return list;
  };
  EXPECT_EQ(entries("one"), "x5 y2 ");
  EXPECT_EQ(entries("two"), "x1 y2 z4 ");
  EXPECT_EQ(entries("same"), "x1 y2 ");
  EXPECT_EQ(faults.count(), 0U);
  root.find("odd")->checkKeys({"x"});
  ASSERT_EQ(faults.count(), 1U);
  EXPECT_EQ(faults.sorted()[0].message, "odd: unknown key '<<'; known: x");
}

TEST(YamlDocument, aliasesThatHaveNoEnd) {
  EXPECT_EQ(faultOf("a: &a [1, *a]\n"), "1: the alias is within its own anchor");
  EXPECT_EQ(faultOf("a: &a\n  b:\n    <<: *a\n"), "3: the alias is within its own anchor");
  EXPECT_EQ(faultOf("a: *b\n"), "1: not valid YAML: the referenced anchor is not defined");
}

// Whatever the width and depth of the tree of aliases: a fault, and soon.
TEST(YamlDocument, bombsOfAliases) {
  for (const int width : {2, 3, 10, 1000}) {
    std::string text = "a0: &a0 [0]\n";
    for (int i = 1; i <= 30; ++i) {
      text += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [";
      for (int k = 0; k < width; ++k) text += (k ? ", *a" : "*a") + std::to_string(i - 1);
      text += "]\n";
    }
    const test::CpuTime start;
    EXPECT_NE(faultOf(text).find("the file has more than 2000000 values"), std::string::npos) << width;
    EXPECT_LT(start.seconds(), 5.0);
  }
  std::string chain = "a0: &a0 {x: 1}\n";  // one after the other, each within the next
  for (int i = 1; i < 1000; ++i) {
    chain +=
        "a" + std::to_string(i) + ": &a" + std::to_string(i) + " {<<: *a" + std::to_string(i - 1) + "}\n";
  }
  EXPECT_NE(faultOf(chain).find("nested more than 32 deep"), std::string::npos);
}

TEST(YamlDocument, deepNesting) {
  for (const std::string open : {"[", "{a: ", "- ", "? "}) {
    std::string text;
    for (int i = 0; i < 100000; ++i) text += open;
    EXPECT_NE(faultOf(text), "") << open;
  }
}

// Bytes drawn from what YAML is made of: a fault or a document, never worse.
TEST(YamlDocument, randomText) {
  std::mt19937 random(3);
  const std::vector<std::string> pieces{"a",  ":",  " ",  "\n", "- ", "[",  "]",        "{",   "}", "&x ",
                                        "*x", "'",  "\"", "#",  "|",  ">",  "---",      "...", "%", "<<",
                                        "\t", "\r", ",",  "?",  "!",  "\\", "\xc3\xa4", "1"};
  for (int trial = 0; trial < 20000; ++trial) {
    std::string text;
    for (std::size_t i = std::uniform_int_distribution<std::size_t>(0, 30)(random); i-- > 0;) {
      text += pieces[std::uniform_int_distribution<std::size_t>(0, pieces.size() - 1)(random)];
    }
    FaultList faults("scene.yaml");
    readYamlDocument(text, faults);
    EXPECT_LE(faults.count(), 1U);
  }
}

}  // namespace
}  // namespace cable_variation
