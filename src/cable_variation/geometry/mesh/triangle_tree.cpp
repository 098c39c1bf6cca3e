#include <cable_variation/geometry/mesh/triangle_tree.h>

#include <stdexcept>
#include <string>

#include <cable_variation/geometry/mesh/fcl_model.h>
#include <cable_variation/util/error.h>

namespace cable_variation {
namespace {

using Model = fcl::BVHModel<fcl_types::Box>;
constexpr int kLeaf = 4;  // triangles: some boxes less to test, few triangles more

void check(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) throw std::invalid_argument("part: a mesh without triangles");
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    if (!mesh.vertices[i].allFinite()) {
      throw std::invalid_argument("part: vertex " + std::to_string(i) + " is not finite");
    }
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const std::uint32_t vertex : mesh.triangles[i]) {
      if (vertex >= mesh.vertices.size()) {
        throw std::invalid_argument("part: triangle " + std::to_string(i) + " names vertex " +
                                    std::to_string(vertex) + " of " + std::to_string(mesh.vertices.size()));
      }
    }
  }
}

void build(const TriangleMesh& mesh, Model& model) {
  std::vector<fcl::Triangle> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) triangles.emplace_back(a, b, c);
  if (const int fault = fill(model, mesh.vertices, triangles); fault != fcl::BVH_OK) {
    throw InternalError("part: FCL cannot build its hierarchy, code " + std::to_string(fault));
  }
}

}  // namespace

TriangleTree::TriangleTree(const TriangleMesh& mesh) {
  check(mesh);
  Model model;
  build(mesh, model);
  triangles.reserve(mesh.triangles.size());
  number.reserve(mesh.triangles.size());

  const auto takeTriangles = [&](int from, auto& self) -> void {
    const auto& source = model.getBV(from);
    if (!source.isLeaf()) {
      self(source.leftChild(), self);
      self(source.rightChild(), self);
      return;
    }
    const auto triangle = static_cast<std::uint32_t>(source.primitiveId());
    const auto& [a, b, c] = mesh.triangles[triangle];
    triangles.emplace_back(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]);
    number.push_back(triangle);
  };
  struct Copy {
    int from;
    std::size_t to;
  };
  nodes.emplace_back();
  std::vector<Copy> open = {{0, 0}};
  while (!open.empty()) {
    const Copy copy = open.back();
    open.pop_back();
    const auto& source = model.getBV(copy.from);
    if (source.isLeaf() || source.num_primitives <= kLeaf) {
      Node leaf;
      leaf.first = static_cast<std::uint32_t>(triangles.size());
      takeTriangles(copy.from, takeTriangles);
      leaf.count = static_cast<std::uint32_t>(triangles.size()) - leaf.first;
      for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
        for (const Eigen::Vector3d& corner : triangles[i].corners) leaf.box.add(corner);
      }
      nodes[copy.to] = leaf;
      continue;
    }
    nodes[copy.to].first = static_cast<std::uint32_t>(nodes.size());
    const std::size_t left = nodes.size();
    nodes.resize(nodes.size() + 2);
    open.push_back({source.rightChild(), left + 1});
    open.push_back({source.leftChild(), left});
  }
  // children come after their parents
  for (std::size_t i = nodes.size(); i-- > 0;) {
    Node& node = nodes[i];
    if (node.count > 0) continue;
    node.box.add(nodes[node.first].box);
    node.box.add(nodes[node.first + 1].box);
  }
}

}  // namespace cable_variation
