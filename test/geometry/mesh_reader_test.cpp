#include <cable_variation/geometry/mesh/mesh_reader.h>

#include <stdexcept>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "test_packages.h"

namespace cable_variation {
namespace {

using Eigen::Vector3d;

std::string meshPath(const std::string& name) { return findTestPackage("test_data") + "/meshes/" + name; }

double volume(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    sum += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]])) / 6.0;
  }
  return sum;
}

Vector3d lowest(const TriangleMesh& mesh) {
  Vector3d corner = mesh.vertices.front();
  for (const Vector3d& vertex : mesh.vertices) corner = corner.cwiseMin(vertex);
  return corner;
}

Vector3d highest(const TriangleMesh& mesh) {
  Vector3d corner = mesh.vertices.front();
  for (const Vector3d& vertex : mesh.vertices) corner = corner.cwiseMax(vertex);
  return corner;
}

std::string refusal(const std::string& name) {
  try {
    readMesh(meshPath(name));
  } catch (const std::invalid_argument& error) {
    const std::string what = error.what();
    const std::string start = "mesh '" + meshPath(name) + "': ";
    EXPECT_EQ(what.substr(0, start.size()), start);
    return what.substr(start.size());
  }
  return "";
}

TEST(MeshReader, readsEachFormatWithSharedVertices) {
  for (const char* name :
       {"tetrahedron.stl", "tetrahedron_binary.stl", "tetrahedron.obj", "tetrahedron.ply"}) {
    const TriangleMesh mesh = readMesh(meshPath(name));
    EXPECT_EQ(mesh.vertices.size(), 4U) << name;
    EXPECT_EQ(mesh.triangles.size(), 4U) << name;
    EXPECT_NEAR(volume(mesh), 1.0 / 6.0, 1e-9) << name;  // positive: counter-clockwise seen from outside
  }
}

// As RViz: the file's unit and its nodes' transforms are applied, its up axis is not.
TEST(MeshReader, readsColladaAsRvizShowsIt) {
  const TriangleMesh mesh = readMesh(meshPath("shifted_millimetres_y_up.dae"));
  EXPECT_EQ(mesh.triangles.size(), 4U);
  EXPECT_NEAR((lowest(mesh) - Vector3d(0.0, 0.0, 2.0)).norm(), 0.0, 1e-6);
  EXPECT_NEAR((highest(mesh) - Vector3d(1.0, 1.0, 3.0)).norm(), 0.0, 1e-6);
}

TEST(MeshReader, scalesPerAxis) {
  const TriangleMesh mesh = readMesh(meshPath("tetrahedron.stl"), {0.001, 2.0, 3.0});
  EXPECT_NEAR((highest(mesh) - Vector3d(0.001, 2.0, 3.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(volume(mesh), 0.001, 1e-12);
}

TEST(MeshReader, mirroringKeepsTheOutsideOutside) {
  const TriangleMesh mesh = readMesh(meshPath("tetrahedron.stl"), {-1.0, 1.0, 1.0});
  EXPECT_NEAR((lowest(mesh) - Vector3d(-1.0, 0.0, 0.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(volume(mesh), 1.0 / 6.0, 1e-9);
}

TEST(MeshReader, refusesOtherFormatsByNameAndByContent) {
  EXPECT_EQ(refusal("part.off"), "extension 'off' is not a mesh's; expected stl, obj, ply or dae");
  EXPECT_EQ(refusal("off_content.stl").substr(0, 20), "not readable as stl:");
  EXPECT_EQ(refusal("other_format.stl").substr(0, 20), "not readable as stl:");
}

TEST(MeshReader, refusesMeshesWithoutASurface) {
  EXPECT_EQ(refusal("flat.stl"), "none of its triangles has an area");
  EXPECT_NE(refusal("empty.stl"), "");
  EXPECT_NE(refusal("nan_vertex.stl"), "");
  EXPECT_EQ(refusal("nothing.stl"), "does not exist");
}

}  // namespace
}  // namespace cable_variation
