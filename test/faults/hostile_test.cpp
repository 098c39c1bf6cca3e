// Files of parts that are made to kill whoever reads them, or to eat up memory: each a fault that names the
// file and what is wrong, at once.

#include <sys/stat.h>

#include <chrono>
#include <fstream>

#include <cable_variation/scene/resource_address.h>

#include "fault_scene.h"

namespace cable_variation::test {
namespace {

Scene sceneWithPart(const std::string& part) {
  return sceneOfLines({"components:", "  - {name: part, " + part + "}", "cables:",
                       "  - {name: c, length: 200 mm, stiffness: {EA: 1e3, GA: 1e3, EI: 0.02, GJ: 0.02, "
                       "mass_per_length: 0.1, radius: 2 mm}}",
                       "clips:", "  - {name: a, type: fixed, cable: c, at: start, pose: {}}"});
}

struct HostileFile {
  const char* file;
  const char* key;
  const char* reason;
};

void PrintTo(const HostileFile& of, std::ostream* stream) { *stream << of.file; }

class HostilePart : public testing::TestWithParam<HostileFile> {};

TEST_P(HostilePart, IsAFaultAtOnce) {
  const auto start = std::chrono::steady_clock::now();
  const std::string file = GetParam().file;
  std::string refusal;
  try {
    sceneWithPart(std::string(GetParam().key) + ": package://test_data/faults/hostile/" + file);
  } catch (const SceneError& error) {
    refusal = error.what();
  }
  EXPECT_TRUE(contains(refusal, "component 'part'")) << refusal;
  EXPECT_TRUE(contains(refusal, file)) << refusal;
  EXPECT_TRUE(contains(refusal, GetParam().reason)) << refusal;
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
}

INSTANTIATE_TEST_SUITE_P(
    Files, HostilePart,
    testing::Values(HostileFile{"daecount0.dae", "mesh", "float_array: it announces 0 numbers and holds 9"},
                    HostileFile{"daecycle.dae", "mesh", "node: it instances itself"},
                    HostileFile{"daeletter.dae", "mesh", "p: found '1A'; expected a whole number"},
                    HostileFile{"daebomb.dae", "mesh", "are more than 100000"},
                    HostileFile{"urdfcycle.urdf", "urdf", "link 'a' has two parents"},
                    HostileFile{"urdfdiamond40.urdf", "urdf", "link 'l1' has two parents"},
                    HostileFile{"fmts2.urdf", "urdf", "%s%s%s"}));

// Its materials are in a pipe that nobody writes to: nothing of them is needed.
TEST(HostileObj, DoesNotWaitForItsMaterials) {
  const auto folder = std::filesystem::temp_directory_path() / (std::to_string(getpid()) + "_hostile");
  std::filesystem::create_directories(folder);
  const auto path = folder / "mtlfifo.obj";
  std::filesystem::copy_file(findTestPackage("test_data") + "/faults/hostile/mtlfifo.obj", path,
                             std::filesystem::copy_options::overwrite_existing);
  ASSERT_EQ(mkfifo((folder / "fifo").c_str(), 0600), 0);
  const Scene scene = sceneWithPart("mesh: \"" + fileUrl(path.string()) + "\"");
  EXPECT_EQ(scene.components.at(0).visuals.at(0).mesh->triangles.size(), 1U);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace cable_variation::test
