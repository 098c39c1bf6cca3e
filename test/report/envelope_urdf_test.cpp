#include <cable_variation/report/envelope_urdf.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <stdexcept>

#include <unistd.h>

#include <gtest/gtest.h>

#include <cable_variation/geometry/body/outer_surface.h>
#include <cable_variation/geometry/body/primitives.h>
#include <cable_variation/geometry/mesh/mesh_reader.h>
#include <cable_variation/report/share_text.h>
#include <cable_variation/report/stl.h>
#include <cable_variation/scene_file/urdf_reader.h>
#include <cable_variation/util/output_file.h>

#include "geometry/closed_surface.h"

namespace cable_variation {
namespace {

using Points = std::vector<Eigen::Vector3d>;
constexpr double kSinglePrecision = 1e-7;  // of coordinates below 1 m, of 24 bits: 6e-8 m

// A folder that is gone with its object.
class Folder {
 public:
  Folder() {
    char name[] = "/tmp/envelope_urdf_test_XXXXXX";
    if (::mkdtemp(name) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~Folder() {
    for (const std::string& file : files_) std::remove(file.c_str());
    ::rmdir(path_.c_str());
  }
  std::string write(const std::string& name, const std::string& contents) {
    files_.push_back(path_ + "/" + name);
    writeFile(files_.back(), contents);
    return files_.back();
  }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  std::vector<std::string> files_;
};

EnvelopeFrame bentCable(std::size_t stretches, std::size_t phases) {
  EnvelopeFrame frame;
  for (std::size_t phase = 0; phase < phases; ++phase) {
    for (std::size_t i = 0; i < stretches; ++i) {
      Points points;
      for (int k = 0; k <= 5; ++k) {
        const double s = 0.3 * (static_cast<double>(i) + k / 5.0) / static_cast<double>(stretches);
        const Eigen::Vector3d middle(s, 0.05 * std::sin(15.0 * s), 0.002 * static_cast<double>(phase));
        for (const double off : {-0.002, 0.002}) {
          points.push_back(middle + Eigen::Vector3d(0.0, off, 0.0));
          points.push_back(middle + Eigen::Vector3d(0.0, 0.0, off));
        }
      }
      const double length = 0.3 / static_cast<double>(stretches);
      frame.pieces.push_back({0,
                              length * static_cast<double>(i),
                              length * static_cast<double>(i + 1),
                              phase,
                              0,
                              {ConvexHull(points), 0.004},
                              {}});
    }
  }
  return frame;
}

TriangleMesh surfaceOf(const EnvelopeFrame& frame) {
  std::vector<const RoundedHull*> bodies;
  for (const EnvelopePiece& piece : frame.pieces) bodies.push_back(&piece.body);
  OuterSurfaceOptions options;
  options.triangles = 5000;
  return outerSurface(bodies, options).mesh;
}

// Points of the rounded hulls' surfaces: hull vertices, moved by the radius in all directions.
Points surfacePoints(const EnvelopeFrame& frame, std::mt19937_64& random) {
  std::normal_distribution<double> coordinate;
  Points points;
  for (const EnvelopePiece& piece : frame.pieces) {
    for (const Eigen::Vector3d& vertex : piece.body.core.surface().vertices) {
      const Eigen::Vector3d direction(coordinate(random), coordinate(random), coordinate(random));
      points.push_back(vertex + piece.body.radius * direction.normalized());
    }
  }
  return points;
}

TEST(Stl, isReadBackAsItWas) {
  Folder folder;
  const TriangleMesh mesh = sphereMesh(0.05);
  const std::string bytes = binaryStl(mesh, "sphere");
  EXPECT_EQ(bytes.size(), 84 + 50 * mesh.triangles.size());  // the format's header, count and triangles
  const TriangleMesh read = readMesh(folder.write("sphere.stl", bytes));
  EXPECT_EQ(read.triangles.size(), mesh.triangles.size());
  EXPECT_EQ(read.vertices.size(), mesh.vertices.size());
  EXPECT_EQ(surfaceFault(read), "");
  EXPECT_NEAR(enclosedVolume(read), enclosedVolume(mesh), 1e-6 * enclosedVolume(mesh));
}

// No coordinate is further from what it was than is said.
TEST(Stl, tellsItsRounding) {
  for (const double away : {0.0, 0.5, 1e3, 1e6}) {
    Folder folder;
    TriangleMesh mesh = sphereMesh(0.05);
    for (Eigen::Vector3d& vertex : mesh.vertices) vertex.x() += away;
    const std::string bytes = binaryStl(mesh, "sphere");
    double largest = 0.0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        float x;
        std::memcpy(&x, bytes.data() + 84 + 50 * i + 12 * (k + 1),
                    sizeof x);  // as on this machine: little-endian
        largest =
            std::max(largest, std::abs(static_cast<double>(x) - mesh.vertices[mesh.triangles[i][k]].x()));
      }
    }
    EXPECT_LE(largest, stlRounding(mesh)) << away;
    EXPECT_GE(largest, 0.2 * stlRounding(mesh)) << away;
  }
}

TEST(Stl, refusesWhatTheFormatCannotHold) {
  EXPECT_THROW(binaryStl(sphereMesh(0.05), "solid sphere"), std::invalid_argument);
  EXPECT_THROW(binaryStl(sphereMesh(1e39), "sphere"), std::invalid_argument);
}

TEST(EnvelopeUrdf, isReadAndHoldsTheEnvelope) {
  std::mt19937_64 random(1);
  for (const auto& [stretches, phases, largest] :
       {std::tuple(20, 1, 50), std::tuple(60, 1, 20), std::tuple(40, 6, 30)}) {
    SCOPED_TRACE(stretches);
    const EnvelopeFrame frame =
        bentCable(static_cast<std::size_t>(stretches), static_cast<std::size_t>(phases));
    Folder folder;
    EnvelopeUrdfOptions options;
    options.folder = "file://" + folder.path();
    options.largest_pieces = static_cast<std::size_t>(largest);
    const EnvelopeUrdf urdf = envelopeUrdf(frame, surfaceOf(frame), options);
    EXPECT_LE(urdf.pieces, options.largest_pieces);
    ASSERT_EQ(urdf.meshes.size(), urdf.pieces + 1);

    const std::string path = folder.write("envelope.urdf", urdf.text);
    std::vector<TriangleMesh> pieces;
    for (const EnvelopeUrdf::File& file : urdf.meshes) {
      pieces.push_back(readMesh(folder.write(file.name, file.contents)));
    }
    EXPECT_EQ(surfaceFault(pieces.front()), "");
    pieces.erase(pieces.begin());

    std::vector<ConvexHull> hulls;
    for (const TriangleMesh& piece : pieces) {
      EXPECT_EQ(surfaceFault(piece), "");
      hulls.emplace_back(piece.vertices);
      EXPECT_NEAR(enclosedVolume(piece) / hulls.back().volume(), 1.0, 1e-4);  // convex: its own hull
    }
    const Points points = surfacePoints(frame, random);
    for (const Eigen::Vector3d& point : points) {
      const bool held = std::any_of(hulls.begin(), hulls.end(), [&](const ConvexHull& hull) {
        return hull.height(point) <= kSinglePrecision;
      });
      EXPECT_TRUE(held) << point.transpose();
    }
    // Nowhere further from the envelope than stated.
    for (const TriangleMesh& piece : pieces) {
      for (const Eigen::Vector3d& vertex : piece.vertices) {
        double nearest = 1.0;
        for (const EnvelopePiece& part : frame.pieces) {
          nearest = std::min(nearest, part.body.core.closest(vertex).distance - part.body.radius);
        }
        EXPECT_LE(nearest, urdf.excess + kSinglePrecision);
      }
    }

    // By urdfdom: the link shows the outer surface
    std::vector<std::string> faults, warnings, addresses;
    readUrdf(
        path, {},
        [&](const std::string& address, const Eigen::Vector3d&) {
          addresses.push_back(address);
          return LoadedMesh{std::make_shared<const TriangleMesh>(sphereMesh(1.0)), address};
        },
        faults, warnings);
    EXPECT_EQ(faults, std::vector<std::string>());
    EXPECT_EQ(addresses, std::vector<std::string>{"file://" + folder.path() + "/envelope_surface.stl"});
    std::size_t collisions = 0;
    for (std::size_t at = 0; (at = urdf.text.find("<collision>", at)) != std::string::npos; ++at)
      ++collisions;
    EXPECT_EQ(collisions, urdf.pieces);
  }
}

// A capsule's cover sticks out by the corners of the polyhedron about its balls: the circumradius of its
// largest facets is 20.9°, so they are 1/cos(20.9°) - 1 = 7.0 % of the radius outside.
TEST(EnvelopeUrdf, excessOfOneStraightStretch) {
  EnvelopeFrame frame;
  frame.pieces.push_back({0, 0.0, 0.1, 0, 0, {ConvexHull({{0.0, 0.0, 0.0}, {0.1, 0.0, 0.0}}), 0.004}, {}});
  EnvelopeUrdfOptions options;
  options.folder = "package://some/envelopes";
  options.name = "a & b";
  const EnvelopeUrdf urdf = envelopeUrdf(frame, sphereMesh(1.0), options);
  EXPECT_EQ(urdf.pieces, 1U);
  EXPECT_NEAR(urdf.excess, 0.07 * 0.004, 0.001 * 0.004);
  EXPECT_NE(urdf.text.find("package://some/envelopes/a &amp; b_surface.stl"), std::string::npos);
}

TEST(EnvelopeUrdf, tellsTheShareOfProductionHoweverCloseToAll) {
  EnvelopeUrdfOptions options;
  options.folder = "package://some/envelopes";
  options.probability = 0.999999999;
  const EnvelopeUrdf urdf = envelopeUrdf(bentCable(3, 1), sphereMesh(1.0), options);
  EXPECT_NE(urdf.text.find("99.9999999 % of production"), std::string::npos) << urdf.text.substr(0, 200);
  EXPECT_EQ(shareText(0.8), "80 %");
  EXPECT_EQ(shareText(0.9973), "99.73 %");
  EXPECT_EQ(shareText(1.0 - 1.0 / 6500.0), "99.984615 %");
  EXPECT_EQ(shareText(1.0), "100 %");
  for (double missing = 0.1; missing > 1e-12; missing *= 0.1) {
    EXPECT_NE(shareText(1.0 - missing), "100 %") << missing;
  }
}

TEST(EnvelopeUrdf, refusesWhatIsNone) {
  const EnvelopeFrame frame = bentCable(3, 1);
  EnvelopeUrdfOptions good;
  good.folder = "file:///tmp/envelopes";
  EXPECT_THROW(envelopeUrdf({}, sphereMesh(1.0), good), std::invalid_argument);
  for (int i = 0; i < 4; ++i) {
    EnvelopeUrdfOptions bad = good;
    if (i == 0) bad.folder = "/tmp/envelopes";
    if (i == 1) bad.name = "../envelope";
    if (i == 2) bad.name = "";
    if (i == 3) bad.largest_pieces = 0;
    EXPECT_THROW(envelopeUrdf(frame, sphereMesh(1.0), bad), std::invalid_argument);
  }
}

}  // namespace
}  // namespace cable_variation
