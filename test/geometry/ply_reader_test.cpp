// PLY in all its formats; what is cut off, changed or hostile is refused or read as what it says, never a
// crash.
#include <cable_variation/geometry/mesh/ply_reader.h>

#include <cstring>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <cable_variation/geometry/mesh/mesh_volume.h>
#include <cable_variation/geometry/body/primitives.h>
#include <geometry/distance_oracle.h>

namespace cable_variation {
namespace {

using test::Chance;

enum class Format { text, little_endian, big_endian };

/// Writes numbers as a format has them.
class Writer {
 public:
  explicit Writer(Format format) : format_(format) {}
  template <typename Number>
  void add(Number value) {
    if (format_ == Format::text) {
      char buffer[64];
      std::snprintf(buffer, sizeof buffer, "%.17g ", static_cast<double>(value));
      text += buffer;
      return;
    }
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);  // of a little-endian machine
    if (format_ == Format::big_endian) bytes.assign(bytes.rbegin(), bytes.rend());
    text += bytes;
  }
  void endLine() {
    if (format_ == Format::text) text.back() = '\n';
  }
  std::string text;

 private:
  Format format_;
};

/// A box as quadrilaterals, with properties and elements beside those needed.
std::string boxFile(Format format, const Eigen::Vector3d& size, const std::string& ending = "\n") {
  const char* names[] = {"ascii", "binary_little_endian", "binary_big_endian"};
  std::string header;
  for (const std::string& line :
       {std::string("ply"), "format " + std::string(names[static_cast<int>(format)]) + " 1.0",
        std::string("comment a box"), std::string("element camera 1"), std::string("property float f"),
        std::string("element vertex 8"), std::string("property uchar quality"),
        std::string("property double x"), std::string("property float y"),
        std::string("property list uchar short tags"), std::string("property float z"),
        std::string("element face 6"), std::string("property int flags"),
        std::string("property list uchar uint vertex_indices"), std::string("element edge 1"),
        std::string("property int vertex1"), std::string("end_header")}) {
    header += line + ending;
  }
  Writer data(format);
  data.add(35.0F);
  data.endLine();
  for (int i = 0; i < 8; ++i) {
    data.add(static_cast<std::uint8_t>(10));  // in binary the byte that ends lines
    data.add((i & 1) != 0 ? size.x() : 0.0);
    data.add(static_cast<float>((i & 2) != 0 ? size.y() : 0.0));
    data.add(static_cast<std::uint8_t>(i % 3));
    for (int k = 0; k < i % 3; ++k) data.add(static_cast<std::int16_t>(-k));
    data.add(static_cast<float>((i & 4) != 0 ? size.z() : 0.0));
    data.endLine();
  }
  for (const auto& quad :
       {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    data.add(static_cast<std::int32_t>(-1));
    data.add(static_cast<std::uint8_t>(4));
    for (const int corner : quad) data.add(static_cast<std::uint32_t>(corner));
    data.endLine();
  }
  data.add(static_cast<std::int32_t>(5));
  data.endLine();
  return header + data.text;
}

std::string refusal(const std::string& file) {
  try {
    readPly(file);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(PlyReader, ReadsEachFormatWithWhatIsBesideIt) {
  for (const Format format : {Format::text, Format::little_endian, Format::big_endian}) {
    for (const char* ending : {"\n", "\r\n"}) {
      const TriangleMesh mesh = readPly(boxFile(format, {2.0, 3.0, 4.0}, ending));
      EXPECT_EQ(mesh.vertices.size(), 8U);
      EXPECT_EQ(mesh.triangles.size(), 12U);
      EXPECT_NEAR(volumeWithin(mesh), 24.0, 1e-12);
    }
  }
}

// The first byte of data is 0x0A, which after a header of lines that end with a return alone is data too.
TEST(PlyReader, ReadsDataThatBeginsLikeALineEnd) {
  std::string header;
  for (const char* line : {"ply", "format binary_little_endian 1.0", "element vertex 3", "property uchar q",
                           "property float x", "property float y", "property float z", "element face 1",
                           "property list uchar int vertex_index", "end_header"}) {
    header += std::string(line) + "\r";
  }
  Writer data(Format::little_endian);
  for (int i = 0; i < 3; ++i) {
    data.add(static_cast<std::uint8_t>(10));
    data.add(i == 1 ? 1.0F : 0.0F);
    data.add(i == 2 ? 1.0F : 0.0F);
    data.add(0.0F);
  }
  data.add(static_cast<std::uint8_t>(3));
  for (int i = 0; i < 3; ++i) data.add(static_cast<std::int32_t>(i));
  EXPECT_EQ(readPly(header + data.text).triangles.size(), 1U);
}

// A plane polygon that is not convex is divided within itself: its area is that of the triangles.
TEST(PlyReader, DividesPolygonsThatAreNotConvex) {
  Chance chance(21);
  for (int i = 0; i < 200; ++i) {
    const int corners = 4 + static_cast<int>(chance.below(20));
    const Eigen::Quaterniond turn = chance.orientation();
    const Eigen::Vector3d from = chance.inBox(5.0);
    std::string file = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(corners) +
                       "\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
                       "property list uchar int vertex_indices\nend_header\n";
    Writer data(Format::text);
    double area = 0.0;
    std::vector<Eigen::Vector2d> star;
    for (int k = 0; k < corners; ++k) {
      const double angle = 2.0 * M_PI * k / corners, radius = chance.between(0.2, 1.0);
      star.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
      const Eigen::Vector3d at = from + turn * Eigen::Vector3d(star.back().x(), star.back().y(), 0.0);
      for (int axis = 0; axis < 3; ++axis) data.add(at[axis]);
      data.endLine();
    }
    for (int k = 0; k < corners; ++k) {
      const Eigen::Vector2d &a = star[static_cast<std::size_t>(k)],
                            &b = star[static_cast<std::size_t>((k + 1) % corners)];
      area += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
    data.add(corners);
    for (int k = 0; k < corners; ++k) data.add(k);
    data.endLine();
    const TriangleMesh mesh = readPly(file + data.text);
    EXPECT_EQ(mesh.triangles.size(), static_cast<std::size_t>(corners - 2)) << i;
    double sum = 0.0;  // without signs: none lies outside, none upon another
    for (const auto& [a, b, c] : mesh.triangles) {
      sum += 0.5 * (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm();
    }
    EXPECT_NEAR(sum, area, 1e-9) << i;
  }
}

TEST(PlyReader, RefusesWhatIsCutOffWhereverThatIs) {
  for (const Format format : {Format::text, Format::little_endian, Format::big_endian}) {
    const std::string file = boxFile(format, {0.1, 0.2, 0.3});
    for (std::size_t size = 0; size < file.size(); ++size) {
      EXPECT_THROW(readPly(file.substr(0, size)), std::invalid_argument) << size << " of " << file.size();
    }
    EXPECT_THROW(readPly(file + "1 2 3\n"), std::invalid_argument);
  }
}

// Bits turned over: a mesh, all of whose triangles name vertices, or a refusal that says why.
TEST(PlyReader, SurvivesBitsTurnedOver) {
  Chance chance(22);
  int refused = 0, read = 0;
  for (int i = 0; i < 30000; ++i) {
    std::string file = boxFile(static_cast<Format>(chance.below(3)), {0.1, 0.2, 0.3});
    for (std::size_t k = 1 + chance.below(4); k > 0; --k) {
      char& byte = file[chance.below(file.size())];
      byte = static_cast<char>(static_cast<unsigned char>(byte) ^ (1U << chance.below(8)));
    }
    try {
      const TriangleMesh mesh = readPly(file);
      ++read;
      for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) ASSERT_LT(vertex, mesh.vertices.size());
      }
      for (const Eigen::Vector3d& vertex : mesh.vertices) ASSERT_TRUE(vertex.allFinite());
    } catch (const std::invalid_argument& error) {
      ++refused;
      ASSERT_STRNE(error.what(), "");
    }
  }
  EXPECT_GT(refused, 5000);
  EXPECT_GT(read, 1000);
}

TEST(PlyReader, SaysWhatIsWrong) {
  const auto file = [](const std::string& corners, const std::string& x = "0") {
    return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
           "element face 1\nproperty list uchar int vertex_indices\nend_header\n" +
           x + " 0 0\n1 0 0\n0 1 0\n" + corners + "\n";
  };
  EXPECT_EQ(refusal(file("3 0 1 2")), "");
  EXPECT_EQ(refusal(file("3 0 1 -2")),
            "face 1 of 1: it names a vertex that is not there; expected 0 to 2, of vertices that stand "
            "before the faces");
  EXPECT_EQ(refusal(file("3 0 1 3")), refusal(file("3 0 1 -2")));
  EXPECT_EQ(refusal(file("2 0 1")), "face 1 of 1: it has 2 corners; expected three or more");
  EXPECT_EQ(refusal(file("99999999 0 1 2")),
            "face 1 of 1: a list of 99999999 entries; there are not as many in the file");
  EXPECT_EQ(refusal(file("3 0 1 2", "nan")), "vertex 1 of 3: line 10: found 'nan'; expected a finite number");
  EXPECT_EQ(refusal(file("3 0 1 2", "inf")).substr(0, 30), "vertex 1 of 3: line 10: found ");
  EXPECT_EQ(refusal(file("3 0 1 2", "1e999")).substr(0, 30), "vertex 1 of 3: line 10: found ");
  EXPECT_EQ(refusal("solid\n"), "it does not begin with ply");
  const std::string huge =
      "ply\nformat binary_little_endian 1.0\nelement vertex 18446744073709551615\n"
      "property float x\nproperty float y\nproperty float z\nelement face 1\n"
      "property list uint int vertex_indices\nend_header\n123456789012";
  EXPECT_EQ(refusal(huge), "vertex 2 of 18446744073709551615: the file is cut off");
}

}  // namespace
}  // namespace cable_variation
