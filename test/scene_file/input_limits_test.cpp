// What is beyond a limit is a fault that names it, before the work that it would take; what is within one is
// read.
#include <cable_variation/util/input_limits.h>

#include <fstream>
#include <functional>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <cable_variation/scene_file/scene_reader.h>

#include "test_packages.h"

#include "cpu_time.h"

namespace cable_variation {
namespace {

using Lines = std::vector<std::string>;

const std::string kStiffness =
    "stiffness: {EA: 1e3, GA: 1e3, EI: 0.02, GJ: 0.02, mass_per_length: 0.1, radius: 2 mm}";

// All faults, one per line.
std::string faultsOf(const Lines& lines, const InputLimits& limits = {}) {
  const TemporaryFile file("limits.yaml", lines);
  try {
    readScene(file.path(), findTestPackage, limits);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "";
}

std::string numbered(const std::string& start, std::size_t i, const std::string& rest) {
  return "  - {name: " + start + std::to_string(i) + ", " + rest + "}";
}

Lines harness(std::size_t cables, std::size_t clips_each) {
  Lines lines{"cables:"};
  for (std::size_t i = 0; i < cables; ++i) lines.push_back(numbered("c", i, "length: 1, " + kStiffness));
  lines.emplace_back("clips:");
  for (std::size_t i = 0; i < cables * clips_each; ++i) {
    lines.push_back(numbered(
        "k", i,
        "type: fixed, cable: c" + std::to_string(i / clips_each) +
            ", at: " + std::to_string(static_cast<double>(i % clips_each) / static_cast<double>(clips_each)) +
            ", pose: {position: [" + std::to_string(i % clips_each) + ", 0, 0]}"));
  }
  return lines;
}

struct Beyond {
  std::size_t InputLimits::*limit;
  const char* name;
  std::function<Lines(std::size_t count)> scene;  // with so many of what it is of
};

Lines list(std::size_t count, const std::string& item) {
  std::string text = "[";
  for (std::size_t i = 0; i < count; ++i) text += (i > 0 ? ", " : "") + item;
  return {text + "]"};
}

Lines with(Lines lines, const std::string& key, std::size_t count, const std::string& item) {
  lines.push_back(key + ": " + list(count, item)[0]);
  return lines;
}

Lines cableWith(const std::string& more) {
  return {"cables:", "  - {name: c, length: 1, " + kStiffness + ", " + more + "}",
          "clips: [{name: a, type: fixed, cable: c, at: start, pose: {}}]"};
}

TEST(InputLimitsTest, CountsHaveEachTheirFault) {
  const auto points = [](std::size_t count) {
    std::string text = "rest_shape: {points: [";
    for (std::size_t i = 0; i < count; ++i) {
      text += (i > 0 ? ", [" : "[") +
              std::to_string(static_cast<double>(i) / static_cast<double>(count - 1)) + ", 0, 0]";
    }
    return cableWith(text + "]}");
  };
  const auto sections = [](std::size_t count) {
    Lines lines{"cables:", "  - name: c", "    length: 1", "    sections:"};
    for (std::size_t i = 0; i < count; ++i) {
      lines.push_back("      - {at: " + std::to_string(static_cast<double>(i) / static_cast<double>(count)) +
                      ", " + kStiffness + "}");
    }
    return lines;
  };
  using L = InputLimits;
  const std::vector<Beyond> table{
      {&L::components, "components",
       [](std::size_t n) {
         Lines lines{"components:"};
         for (std::size_t i = 0; i < n; ++i) lines.push_back(numbered("p", i, "pose: {}"));
         return lines;
       }},
      {&L::cables, "cables", [](std::size_t n) { return harness(n, 1); }},
      {&L::clips, "clips", [](std::size_t n) { return harness(1, n); }},
      {&L::joints, "joints", [](std::size_t n) { return with(harness(1, 1), "joints", n, "{}"); }},
      {&L::loads, "loads", [](std::size_t n) { return with(harness(1, 1), "loads", n, "{}"); }},
      {&L::design_variables, "design_variables",
       [](std::size_t n) { return with(harness(1, 1), "design_variables", n, "{}"); }},
      {&L::correlations, "correlations",
       [](std::size_t n) { return with(harness(1, 1), "correlations", n, "{}"); }},
      {&L::measures, "measures", [](std::size_t n) { return with(harness(1, 1), "measures", n, "{}"); }},
      {&L::motions, "motions", [](std::size_t n) { return with(harness(1, 1), "motions", n, "{}"); }},
      {&L::sections, "sections", sections},
      {&L::rest_points, "rest_points", points},
      {&L::via_points, "via_points",
       [](std::size_t n) { return cableWith("via: " + list(n, "[0, 0, 0]")[0]); }},
      {&L::turns, "turns", [](std::size_t n) { return cableWith("twist: " + std::to_string(n) + " turns"); }},
      {&L::name_bytes, "name_bytes", [](std::size_t n) {
         return Lines{"components:", "  - {name: " + std::string(n, 'a') + ", pose: {}}"};
       }}};
  for (const Beyond& row : table) {
    InputLimits limits;
    limits.*row.limit = 7;
    const std::string reason = "expected at most 7 (the limit " + std::string(row.name) + ")";
    EXPECT_EQ(faultsOf(row.scene(7), limits).find(reason), std::string::npos) << row.name;
    EXPECT_NE(faultsOf(row.scene(8), limits).find(reason), std::string::npos)
        << row.name << ": " << faultsOf(row.scene(8), limits);
  }
}

// With the limits as they are by default: a fault at once for each of what once took minutes or all memory.
TEST(InputLimitsTest, TheDefaultsEndWhatWouldTakeLong) {
  const test::CpuTime start;
  EXPECT_NE(faultsOf(cableWith("twist: 1e6")).find("limit turns"), std::string::npos);
  EXPECT_NE(faultsOf(cableWith("twist: -1e300")).find("limit turns"), std::string::npos);
  std::string points = "rest_shape: {points: [";
  for (int i = 0; i < 5000; ++i) points += (i > 0 ? ", [" : "[") + std::to_string(i) + ", 0, 0]";
  EXPECT_NE(faultsOf(cableWith(points + "]}")).find("limit rest_points"), std::string::npos);
  EXPECT_NE(faultsOf(harness(10, 1000)).find("limit clips"), std::string::npos);
  EXPECT_LT(start.seconds(), 20.0);
}

TEST(InputLimitsTest, LargeScenesAreReadFast) {
  const test::CpuTime start;
  EXPECT_EQ(faultsOf(harness(100, 20)), "");
  EXPECT_LT(start.seconds(), 5.0);
}

TEST(InputLimitsTest, TheLastFaultSaysThatTheRestWasNotRead) {
  Lines lines{"components:"};
  for (int i = 0; i < 100000; ++i) lines.emplace_back("  - {nam: a}");
  const TemporaryFile file("faults.yaml", lines);
  const test::CpuTime start;
  InputLimits limits;
  limits.components = 1000000;
  try {
    readScene(file.path(), findTestPackage, limits);
    ADD_FAILURE() << "it was read";
  } catch (const SceneError& error) {
    EXPECT_EQ(error.faults().size(), 1001U);
    EXPECT_EQ(
        error.faults().back().message,
        "no more than these 1000 faults are told (the limit faults); the rest of the file was not read");
    EXPECT_LT(std::string(error.what()).size(), 200000U);
  }
  EXPECT_LT(start.seconds(), 5.0);
}

// Files lie in certain folders, if any are named: by whatever way they are addressed.
TEST(InputLimitsTest, FilesOutOfTheFoldersAreRefused) {
  const Lines lines{"components:", "  - {name: a, mesh: package://test_data/meshes/tetrahedron.stl}",
                    "  - {name: b, urdf: package://test_data/urdf/arm.urdf}"};
  const std::string data = findTestPackage("test_data");
  InputLimits limits;
  for (const std::string& folder : {data, data + "/", data + "/meshes/..", std::string("/")}) {
    limits.folders = {"/no/such/folder", folder};
    EXPECT_EQ(faultsOf(lines, limits).find("is not within"), std::string::npos) << folder;
  }
  limits.folders = {data + "/meshes"};
  EXPECT_NE(
      faultsOf(lines, limits).find("urdf/arm.urdf' is not within the folders that files may be read from"),
      std::string::npos);
  EXPECT_EQ(faultsOf(lines, limits).find("tetrahedron.stl' is not"), std::string::npos);
  for (const std::string& folder : {data + "/mesh", data + "/meshes/tetrahedron", std::string("/proc")}) {
    limits.folders = {folder};
    EXPECT_NE(faultsOf(lines, limits).find("tetrahedron.stl' is not within"), std::string::npos) << folder;
  }
  // a link leads out of them, and what is not there is not told of
  const auto root = std::filesystem::temp_directory_path() / (std::to_string(getpid()) + "_folders");
  std::filesystem::create_directories(root);
  std::filesystem::create_symlink(data + "/meshes", root / "meshes");
  limits.folders = {root.string()};
  for (const char* file : {"/meshes/tetrahedron.stl", "/meshes/none.stl", "/../none.stl"}) {
    const std::string said =
        faultsOf({"components:", "  - {name: a, mesh: \"file://" + root.string() + file + "\"}"}, limits);
    EXPECT_NE(said.find("is not within"), std::string::npos) << said;
  }
  std::filesystem::remove_all(root);
}

// doc/nodes.md has a row for each limit, with its default.
TEST(InputLimitsTest, AreDocumented) {
  std::ifstream file(std::string(CABLE_VARIATION_SOURCE_DIR) + "/doc/nodes.md");
  std::stringstream text;
  text << file.rdbuf();
  const InputLimits defaults;
  for (const InputLimitRow& row : inputLimitRows()) {
    const std::regex pattern("\\| `" + std::string(row.name) + "` \\| " +
                             std::to_string(defaults.*row.value) + " \\|");
    EXPECT_TRUE(std::regex_search(text.str(), pattern)) << row.name << " " << defaults.*row.value;
  }
  EXPECT_NE(text.str().find("| `folders` |"), std::string::npos);
}

}  // namespace
}  // namespace cable_variation
