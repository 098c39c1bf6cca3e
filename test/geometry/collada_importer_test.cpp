// COLLADA is imported by a process of its own: whatever becomes of that one, who asked for it goes on and
// tells.
#include <cable_variation/geometry/mesh/imported_mesh.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>

#include <unistd.h>

#include <gtest/gtest.h>

#include <cable_variation/geometry/mesh/mesh_reader.h>
#include <cable_variation/util/child_process.h>
#include <cable_variation/util/helper_program.h>
#include <cable_variation/util/import_program.h>

namespace cable_variation {
namespace {

namespace fs = std::filesystem;

class ColladaImporter : public testing::Test {
 protected:
  ColladaImporter() {
    std::string name = (fs::temp_directory_path() / "collada_XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~ColladaImporter() override { fs::remove_all(folder_); }

  TriangleMesh read(const std::string& document, const InputLimits& limits = {}) const {
    std::ofstream(folder_ / "part.dae", std::ios::binary) << document;
    return readMesh(folder_ / "part.dae", Eigen::Vector3d::Ones(), limits);
  }
  // Without the file's name, with which it begins.
  std::string refusal(const std::string& document, const InputLimits& limits = {}) const {
    try {
      read(document, limits);
    } catch (const std::invalid_argument& error) {
      const std::string start = "mesh '" + (folder_ / "part.dae").string() + "': ", said = error.what();
      EXPECT_EQ(said.substr(0, start.size()), start);
      return said.substr(std::min(start.size(), said.size()));
    }
    return "";
  }

  fs::path folder_;
};

// A grid of triangles, `count` of them, shown by so many nodes.
std::string grid(std::size_t count, std::size_t nodes = 1) {
  std::string points, indices, shown;
  for (std::size_t i = 0; i < count + 2; ++i) {
    points += std::to_string(i / 2) + " " + std::to_string(i % 2) + " " + std::to_string(i % 7) + " ";
  }
  for (std::size_t i = 0; i < count; ++i) {
    indices += std::to_string(i) + " " + std::to_string(i + 1) + " " + std::to_string(i + 2) + " ";
  }
  for (std::size_t i = 0; i < nodes; ++i) {
    shown += "<node><translate>0 0 " + std::to_string(10 * i) +
             "</translate><instance_geometry url=\"#g\"/></node>";
  }
  return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter="1"/></asset><library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a" count=")" +
         std::to_string(3 * (count + 2)) + "\">" + points +
         R"(</float_array><technique_common><accessor source="#a"
count=")" +
         std::to_string(count + 2) +
         R"(" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
</accessor></technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles
count=")" +
         std::to_string(count) + R"("><input semantic="VERTEX" source="#v" offset="0"/><p>)" + indices +
         "</p></triangles></mesh></geometry></library_geometries><library_visual_scenes><visual_scene "
         "id=\"s\">" +
         shown +
         "</visual_scene></library_visual_scenes><scene><instance_visual_scene "
         "url=\"#s\"/></scene></COLLADA>\n";
}

TEST_F(ColladaImporter, HandsOverAllTriangles) {
  for (const std::size_t count : {1U, 10U, 20000U}) {
    const TriangleMesh mesh = read(grid(count));
    EXPECT_EQ(mesh.triangles.size(), count);
    EXPECT_EQ(mesh.vertices.size(), count + 2);
    EXPECT_EQ(mesh.vertices.back(),
              Eigen::Vector3d(static_cast<double>((count + 1) / 2), static_cast<double>((count + 1) % 2),
                              static_cast<double>((count + 1) % 7)));
  }
  EXPECT_EQ(read(grid(10, 3)).triangles.size(), 30U);
}

TEST_F(ColladaImporter, IsGivenUpBeyondItsLimits) {
  InputLimits limits;
  limits.triangles = 25;
  EXPECT_NE(refusal(grid(10, 3), limits).find("limit triangles"), std::string::npos);
  EXPECT_EQ(refusal(grid(10, 2), limits), "");
  EXPECT_NE(refusal(grid(26), limits).find("limit triangles"), std::string::npos);

  limits = InputLimits();
  limits.import_memory = 20'000'000;  // less than its libraries have already
  EXPECT_EQ(refusal(grid(200000), limits),
            "reading it took more than the 20000000 bytes of the limit import_memory; it was given up");
  limits = InputLimits();
  limits.import_seconds = 150;  // the machine may be busy
  EXPECT_EQ(refusal(grid(200000), limits), "");

  limits = InputLimits();
  limits.xml_parts = 20;
  EXPECT_NE(refusal(grid(10), limits).find("limit xml_parts"), std::string::npos);
  limits = InputLimits();
  limits.collada_bytes = 1000;
  EXPECT_NE(refusal(grid(200), limits).find("expected at most 1 kB"), std::string::npos);
}

// A check whose work grows with the square of the file: inputs of vertices, looked at for each primitive.
TEST_F(ColladaImporter, IsGivenUpWhenItTakesTooLong) {
  std::string document = grid(1);
  const std::string input = R"(<input semantic="POSITION" source="#p"/>)";
  std::string inputs, shapes;
  for (int i = 0; i < 200000; ++i) inputs += R"(<input semantic="NORMAL" source="#p"/>)";
  for (int i = 0; i < 100000; ++i) {
    shapes +=
        R"(<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>)";
  }
  document.insert(document.find(input) + input.size(), inputs);
  document.insert(document.find("</mesh>"), shapes);
  InputLimits limits;
  limits.import_seconds = 2;
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(refusal(document, limits),
            "reading it took longer than the 2 s of the limit import_seconds; it was given up");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60));
}

// Files that the check lets pass may still end the importer: here it is ended by hand, by its memory.
TEST_F(ColladaImporter, IsAProgramThatMayEndInAnyWay) {
  const std::string program = helperProgram("collada_importer");
  const std::string document = grid(3);
  const auto run = [&](const std::vector<std::string>& arguments) {
    return runChild(program, arguments, document, 20.0, 100000);
  };
  const ChildRun whole = run({"2000000000", "20", "1000", "1000"});
  EXPECT_EQ(whole.code, static_cast<int>(ImportEnd::done));
  EXPECT_EQ(importedMesh(whole.output).triangles.size(), 3U);
  EXPECT_NE(run({}).code, static_cast<int>(ImportEnd::done));
  const ChildRun refused = run({"2000000000", "20", "1000", "2"});
  EXPECT_EQ(refused.code, static_cast<int>(ImportEnd::refused));
  EXPECT_NE(refused.output, "");
}

TEST(ImportedMeshBytes, AreAMeshWhateverTheyAre) {
  ImportedMesh mesh;
  mesh.points = {{0.0, 0.0, 0.0}, {1.0, 0.5, 0.25}, {0.0, 1.0, 0.0}, {2.0, 2.0, 2.0}};
  mesh.triangles = {{0, 1, 2}, {1, 2, 3}};
  const std::string whole = bytesOf(mesh);
  EXPECT_EQ(importedMesh(whole).points, mesh.points);
  EXPECT_EQ(importedMesh(whole).triangles, mesh.triangles);
  EXPECT_LE(whole.size(), mostBytesOf(2));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_THROW(importedMesh(whole.substr(0, size)), std::invalid_argument) << size;
  }
  EXPECT_THROW(importedMesh(whole + "x"), std::invalid_argument);
  std::mt19937 random(17);
  for (int round = 0; round < 20000; ++round) {
    std::string bytes = whole;
    for (unsigned k = 1 + random() % 4; k > 0; --k) {
      char& byte = bytes[random() % (round % 2 == 0 ? 16 : bytes.size())];
      byte = static_cast<char>(static_cast<unsigned char>(byte) ^ (1U << (random() % 8U)));
    }
    try {
      const ImportedMesh read = importedMesh(bytes);
      for (const auto& triangle : read.triangles) {
        for (const std::uint32_t corner : triangle) ASSERT_LT(corner, read.points.size());
      }
    } catch (const std::invalid_argument& error) {
      ASSERT_STRNE(error.what(), "");
    }
  }
}

}  // namespace
}  // namespace cable_variation
