// STL, OBJ and COLLADA files that are cut off, changed or hostile.
#include <cable_variation/geometry/mesh/mesh_reader.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include <sys/stat.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include <cable_variation/geometry/tube_distance/distance.h>
#include <cable_variation/geometry/mesh/collada_check.h>
#include <cable_variation/geometry/mesh/obj_reader.h>
#include <cable_variation/geometry/mesh/stl_reader.h>
#include <cable_variation/geometry/mesh/mesh_volume.h>
#include <cable_variation/geometry/body/primitives.h>
#include <geometry/distance_oracle.h>

#include "cpu_time.h"

namespace cable_variation {
namespace {

using test::Chance;

const TriangleMesh& box() {
  static const TriangleMesh made = boxMesh({0.5, 0.25, 0.125});
  return made;
}

std::string binaryStl(std::string title = "made by a test") {
  title.resize(80, ' ');
  std::string file = title;
  const auto add = [&](const auto& value) {
    file.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  add(static_cast<std::uint32_t>(box().triangles.size()));
  for (const auto& triangle : box().triangles) {
    for (int i = 0; i < 3; ++i) add(0.0F);
    for (const std::uint32_t corner : triangle) {
      for (const double coordinate : box().vertices[corner]) add(static_cast<float>(coordinate));
    }
    add(static_cast<std::uint16_t>(0));
  }
  return file;
}

std::string textStl() {
  std::string file = "solid part of 3 facet words\n";
  for (const auto& triangle : box().triangles) {
    file += "facet normal 0 0 nan\n outer loop\n";
    for (const std::uint32_t corner : triangle) {
      file += "  vertex";
      for (const double coordinate : box().vertices[corner]) file += " " + std::to_string(coordinate);
      file += "\n";
    }
    file += " endloop\nendfacet\n";
  }
  return file + "endsolid part\n";
}

std::string obj() {
  std::string file = "# a box\nmtllib none.mtl\no part\n";
  for (const Eigen::Vector3d& at : box().vertices) {
    file +=
        "v " + std::to_string(at.x()) + " " + std::to_string(at.y()) + " " + std::to_string(at.z()) + "\n";
  }
  file += "vt 0 0\nvn 0 0 1\nusemtl paint\ns off\n";
  for (const auto& [a, b, c] : box().triangles) {
    file += "f " + std::to_string(a + 1) + "/1/1 " + std::to_string(b + 1) + "//1 " +
            std::to_string(static_cast<long>(c) - static_cast<long>(box().vertices.size())) + "\n";
  }
  return file;
}

template <typename Read>
std::string refusal(const Read& read, const std::string& file) {
  try {
    read(file);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TriangleMesh readObjText(const std::string& file) { return readObj(file); }
TriangleMesh readStlText(const std::string& file) { return readStl(file); }
void checkColladaText(const std::string& file) { checkCollada(file); }

void expectBox(const TriangleMesh& mesh) {
  EXPECT_EQ(mesh.vertices.size(), 8U);
  EXPECT_EQ(mesh.triangles.size(), 12U);
  EXPECT_NEAR(volumeWithin(mesh), 1.0 / 64.0, 1e-12);
}

TEST(StlReader, ReadsBothKindsWhateverTheyBeginWith) {
  expectBox(readStl(binaryStl()));
  expectBox(readStl(binaryStl("solid binary all the same")));
  expectBox(readStl(textStl()));
  EXPECT_EQ(readStl(textStl() + textStl()).triangles.size(), 24U);
}

TEST(StlReader, PassesOverBytesAfterTheLastFacet) {
  for (const std::size_t more : {1U, 2U, 49U, 50U, 1000U})
    expectBox(readStl(binaryStl() + std::string(more, '\7')));
}

TEST(StlReader, RefusesWhatIsCutOff) {
  const std::string binary = binaryStl(), text = textStl();
  for (std::size_t size = 0; size < binary.size(); ++size) {
    EXPECT_THROW(readStl(binary.substr(0, size)), std::invalid_argument) << size;
  }
  EXPECT_EQ(
      refusal(readStlText, binary.substr(0, 600)),
      "not readable as stl: neither a text that begins with solid, nor is there room for the 12 facets of 50 "
      "bytes that it announces; it has 600 bytes, expected 684: cut off?");
  const std::size_t last = text.find("endsolid") + std::strlen("endsolid");
  for (std::size_t size = 1; size < last; ++size) {
    EXPECT_THROW(readStl(text.substr(0, size)), std::invalid_argument) << size;
  }
}

TEST(StlReader, RefusesCoordinatesThatAreNone) {
  for (const char* bad : {"nan", "inf", "-inf", "1e999", "0x1", "1,5", "--1"}) {
    std::string file = textStl();
    const std::size_t at = file.find("0.250000");
    file.replace(at, 8, bad);
    EXPECT_NE(refusal(readStlText, file), "") << bad;
  }
  std::string binary = binaryStl();
  const float bad = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(binary.data() + 84 + 50 + 12, &bad, sizeof bad);
  EXPECT_EQ(refusal(readStlText, binary), "a vertex of facet 2 is not finite");
}

TEST(ObjReader, ReadsFacesOfAllForms) {
  expectBox(readObj(obj()));
  EXPECT_EQ(
      readObj("v 0 \\\n 0 0\nv 1 0 0 1 0.5 0.5 0.5\nv 0 1 0\nv 1 1 0\nf 1 2 \\\n 4 3\n").triangles.size(),
      2U);
}

TEST(ObjReader, SaysWhatIsWrong) {
  const std::string start = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_EQ(refusal(readObjText, start + "f 1 2 3\n"), "");
  EXPECT_EQ(refusal(readObjText, start + "f 1 2 -3"), "");
  EXPECT_EQ(refusal(readObjText, start + "f 1 2 4\n"),
            "line 4: found the corner '4'; expected one of the 3 vertices so far");
  for (const char* corner : {"0", "-4", "x", "", "99999999999999999999", "1.5"}) {
    EXPECT_NE(refusal(readObjText, start + "f 1 2 " + corner + "\n"), "") << corner;
  }
  EXPECT_EQ(refusal(readObjText, "v 0 nan 0\n"),
            "line 1: found 'nan'; expected a coordinate, a finite number");
  EXPECT_EQ(refusal(readObjText, "v 0 0\nv 1 0 0\n"),
            "line 1: the line ends; expected a coordinate, a finite number");
}

TEST(MeshFiles, SurviveBitsTurnedOver) {
  Chance chance(31);
  const std::string files[] = {binaryStl(), textStl(), obj()};
  for (int i = 0; i < 20000; ++i) {
    const std::size_t kind = chance.below(3);
    std::string file = files[kind];
    for (std::size_t k = 1 + chance.below(4); k > 0; --k) {
      char& byte = file[chance.below(file.size())];
      byte = static_cast<char>(static_cast<unsigned char>(byte) ^ (1U << chance.below(8)));
    }
    if (chance.oneOf(3)) file.resize(chance.below(file.size()));
    try {
      const TriangleMesh mesh = kind == 2 ? readObj(file) : readStl(file);
      for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) ASSERT_LT(vertex, mesh.vertices.size());
      }
    } catch (const std::invalid_argument& error) {
      ASSERT_STRNE(error.what(), "");
    }
  }
}

// A folder of its own, gone afterwards.
class Folder {
 public:
  Folder() : path_(std::filesystem::temp_directory_path() / ("mesh_files_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(path_);
  }
  ~Folder() {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string write(const std::string& name, const std::string& contents) const {
    std::ofstream(path_ / name, std::ios::binary) << contents;
    return (path_ / name).string();
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

// Nothing writes into the pipe: whoever opens it waits for ever.
TEST(MeshFiles, DoNotOpenWhatAnObjNames) {
  const Folder folder;
  ASSERT_EQ(mkfifo((folder.path() / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(readMesh(folder.write("part.obj", "mtllib pipe\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"))
                .triangles.size(),
            1U);
}

TEST(MeshFiles, KeepTheirPrecision) {
  const Folder folder;
  const TriangleMesh mesh =
      readMesh(folder.write("part.obj", "v 0.1234567890123 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  EXPECT_EQ(mesh.vertices[0].x(), 0.1234567890123);
}

std::string collada(const std::string& array, const std::string& indices, const std::string& nodes,
                    const std::string& library = "") {
  return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter="1"/></asset><library_geometries><geometry id="g"><mesh><source id="p">)" +
         array + R"(<technique_common><accessor source="#a" count="3" stride="3"><param name="X"
type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>)" +
         indices + "</p></triangles></mesh></geometry></library_geometries>" + library +
         "<library_visual_scenes><visual_scene id=\"s\">" + nodes +
         "</visual_scene></library_visual_scenes><scene><instance_visual_scene "
         "url=\"#s\"/></scene></COLLADA>\n";
}
const char kArray[] = R"(<float_array id="a" count="9">0 0 0 1 0 0 0 1 0</float_array>)";
const char kNode[] = R"(<node id="n"><instance_geometry url="#g"/></node>)";

TEST(MeshFiles, ColladaIsCheckedBeforeItIsImported) {
  const Folder folder;
  const test::CpuTime begin;
  EXPECT_EQ(readMesh(folder.write("part.dae", collada(kArray, "0 1 2", kNode))).triangles.size(), 1U);
  const auto says = [&](const std::string& document) { return refusal(checkColladaText, document); };
  EXPECT_EQ(says(collada(kArray, "0 1 2", kNode)), "");
  const std::string other = R"(<float_array id="a" count="0">0 0 0 1 0 0 0 1 0</float_array>)";
  EXPECT_EQ(says(collada(other, "0 1 2", kNode)),
            "not readable as dae: line 2: float_array: it announces 0 numbers and holds 9");
  EXPECT_NE(says(collada(R"(<float_array id="a" count="6">0 0 0 1 0 0</float_array>)", "0 1 2", kNode)), "");
  EXPECT_NE(
      says(collada(R"(<float_array id="a" count="9">0 0 0 1 0 0 0 nan 0</float_array>)", "0 1 2", kNode)),
      "");
  for (const char* indices :
       {"0 1A 2", "0 1 3", "0 1 -1", "0 1", "0 1 2 0", "0 1 99999999999999999999", ""}) {
    EXPECT_NE(says(collada(kArray, indices, kNode)), "") << indices;
  }
  EXPECT_EQ(
      says(collada(
          kArray, "0 1 2",
          R"(<node id="n"><instance_node url="#m"/></node><node id="m"><instance_node url="#n"/></node>)")),
      "not readable as dae: line 5: node: it instances itself, perhaps by way of others");
  EXPECT_NE(says(collada(kArray, "0 1 2", R"(<node id="n"><instance_geometry url="#nothing"/></node>)")), "");
  std::string doubling = "<library_nodes>";
  for (int i = 0; i < 40; ++i) {
    const std::string next = std::to_string(i + 1);
    doubling += "<node id=\"b" + std::to_string(i) + "\"><instance_node url=\"#b" + next +
                "\"/><instance_node url=\"#b" + next + "\"/></node>";
  }
  doubling += "<node id=\"b40\"><instance_geometry url=\"#g\"/></node></library_nodes>";
  EXPECT_NE(says(collada(kArray, "0 1 2", R"(<node id="n"><instance_node url="#b0"/></node>)", doubling)),
            "");
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<node>";
  EXPECT_NE(says(collada(kArray, "0 1 2", deep)), "");
  EXPECT_LT(begin.seconds(), 5.0);
}

TEST(MeshFiles, ColladaSurvivesBitsTurnedOver) {
  Chance chance(32);
  const Folder folder;
  const std::string whole = collada(kArray, "0 1 2", kNode);
  for (int i = 0; i < 1500; ++i) {
    std::string file = whole;
    for (std::size_t k = 1 + chance.below(3); k > 0; --k) {
      char& byte = file[chance.below(file.size())];
      byte = static_cast<char>(static_cast<unsigned char>(byte) ^ (1U << chance.below(8)));
    }
    if (chance.oneOf(10)) file.resize(chance.below(file.size()));
    try {
      if (i % 10 == 0) {
        readMesh(folder.write("part.dae", file));
      } else {
        checkCollada(file);
      }
    } catch (const std::invalid_argument& error) {
      ASSERT_STRNE(error.what(), "");
    }
  }
}

}  // namespace
}  // namespace cable_variation
