#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <cable_variation/scene_file/scene_reader.h>

#include "test_packages.h"

namespace cable_variation {
namespace {

using Fault = std::pair<int, std::string>;  // line and message

// One entry of data/broken_scenes.txt.
struct BrokenScene {
  std::string name;
  std::vector<std::string> lines;
  std::vector<Fault> expected;
};

void PrintTo(const BrokenScene& scene, std::ostream* stream) { *stream << scene.name; }

const std::string kMark = "#!";

// Takes the expected messages off a line.
void takeExpected(std::string line, BrokenScene& scene) {
  const bool whole_file = line.compare(0, 3, kMark + "0") == 0;
  const int number = whole_file ? 0 : static_cast<int>(scene.lines.size()) + 1;
  std::size_t at = line.find(kMark);
  const std::string content = line.substr(0, at);
  while (at != std::string::npos) {
    const std::size_t start = at + kMark.size() + (whole_file ? 1 : 0);
    const std::size_t next = line.find(" " + kMark, start);
    std::string message = line.substr(start, next == std::string::npos ? next : next - start);
    message.erase(0, message.find_first_not_of(' '));
    scene.expected.emplace_back(number, message);
    at = next == std::string::npos ? next : next + 1;
  }
  if (!whole_file) scene.lines.push_back(content);
}

// Top-level parts by key, as lines.
std::vector<std::pair<std::string, std::vector<std::string>>> partsOf(const std::vector<std::string>& lines) {
  std::vector<std::pair<std::string, std::vector<std::string>>> parts;
  for (const std::string& line : lines) {
    const bool starts = !line.empty() && line.front() != ' ';
    if (starts) parts.push_back({line.substr(0, line.find(':')), {}});
    if (!parts.empty()) parts.back().second.push_back(line);
  }
  return parts;
}

std::vector<BrokenScene> brokenScenes() {
  std::ifstream file(std::string(CABLE_VARIATION_SOURCE_DIR) + "/test/data/broken_scenes.txt");
  std::vector<BrokenScene> scenes;
  for (std::string line; std::getline(file, line);) {
    if (line.compare(0, 4, "=== ") == 0) {
      scenes.push_back({line.substr(4), {}, {}});
    } else if (!scenes.empty() && !line.empty()) {
      takeExpected(line, scenes.back());
    }
  }
  if (scenes.empty()) return scenes;
  const auto base = partsOf(scenes.front().lines);
  scenes.erase(scenes.begin());
  for (BrokenScene& scene : scenes) {
    if (scene.name.find("(alone)") != std::string::npos) continue;
    const auto own = partsOf(scene.lines);
    for (const auto& part : base) {
      const bool given =
          std::any_of(own.begin(), own.end(), [&](const auto& o) { return o.first == part.first; });
      if (!given) scene.lines.insert(scene.lines.end(), part.second.begin(), part.second.end());
    }
  }
  return scenes;
}

std::vector<Fault> faultsOfText(const std::vector<std::string>& lines) {
  const TemporaryFile file("broken_scene.yaml", lines);
  std::vector<Fault> faults;
  try {
    readScene(file.path(), findTestPackage);
  } catch (const SceneError& error) {
    for (const SceneFault& fault : error.faults()) {
      EXPECT_EQ(fault.file, file.path());
      faults.emplace_back(fault.line, withoutRoot(fault.message));
    }
  }
  return faults;
}

class BrokenScenes : public testing::TestWithParam<BrokenScene> {};

TEST_P(BrokenScenes, tellsEveryFaultWithItsLine) {
  ASSERT_FALSE(GetParam().expected.empty());
  EXPECT_EQ(faultsOfText(GetParam().lines), GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(Table, BrokenScenes, testing::ValuesIn(brokenScenes()));

TEST(BrokenScenesTable, isReadWhole) { EXPECT_GE(brokenScenes().size(), 80U); }

TEST(BrokenScenesTable, baseSceneIsSound) {
  std::ifstream file(std::string(CABLE_VARIATION_SOURCE_DIR) + "/test/data/broken_scenes.txt");
  std::vector<std::string> base;
  bool inside = false;
  for (std::string line; std::getline(file, line);) {
    if (line.compare(0, 4, "=== ") == 0)
      inside = line == "=== base";
    else if (inside)
      base.push_back(line);
  }
  ASSERT_FALSE(base.empty());
  EXPECT_EQ(faultsOfText(base), std::vector<Fault>());
}

TEST(SceneErrors, areListedOnePerLineWithFileAndLine) {
  const TemporaryFile file("two_faults.yaml", {"gravity: 1", "accuracy: 1 kg", "cables: []"});
  try {
    readScene(file.path(), findTestPackage);
    FAIL() << "the scene was read";
  } catch (const SceneError& error) {
    EXPECT_EQ(std::string(error.what()),
              file.path() + ":1: gravity: found '1'; expected a list of 3\n" + file.path() +
                  ":2: accuracy: '1 kg' has the wrong unit; expected a length, e.g. '312 mm'");
  }
}

TEST(SceneErrors, staysReadableWhateverTheFileHolds) {
  std::vector<std::string> lines{
      "gravity: [0, 0, " + std::string(300000, '9') + "\xc3\xa4" + std::string(1500, '9') + "]",
      "components:"};
  for (int i = 0; i < 2000; ++i) lines.push_back("  - {nam: a}");
  const TemporaryFile file("long.yaml", lines);
  try {
    readScene(file.path(), findTestPackage);
    FAIL() << "the scene was read";
  } catch (const SceneError& error) {
    const std::string what = error.what();
    EXPECT_GT(error.faults().size(), 1000U);
    EXPECT_LT(what.size(), 500U * 200U);
    EXPECT_NE(what.find(" bytes) ... "), std::string::npos);
    EXPECT_EQ(what.substr(what.rfind('\n') + 1, 4), "and ");
  }
}

TEST(SceneErrors, aFileThatIsNotThere) {
  try {
    readScene("/nowhere/scene.yaml", findTestPackage);
    FAIL() << "the scene was read";
  } catch (const SceneError& error) {
    EXPECT_EQ(std::string(error.what()), "/nowhere/scene.yaml: the file does not exist");
  }
}

}  // namespace
}  // namespace cable_variation
