#include <cable_variation/geometry/mesh/mesh_reader.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>

#include <assimp/BaseImporter.h>
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <cable_variation/geometry/mesh/collada_check.h>
#include <cable_variation/geometry/mesh/obj_reader.h>
#include <cable_variation/geometry/mesh/ply_reader.h>
#include <cable_variation/geometry/mesh/stl_reader.h>
#include <cable_variation/util/error.h>

namespace cable_variation {
namespace {

std::string lowerExtension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

bool reads(const aiImporterDesc& importer, const std::string& extension) {
  std::istringstream extensions(importer.mFileExtensions);
  for (std::string word; extensions >> word;) {
    if (word == extension) return true;
  }
  return false;
}

// Leaves one importer registered, so that a file's content cannot choose another.
void keepOnly(const std::string& extension, Assimp::Importer& importer) {
  for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
    if (reads(*importer.GetImporterInfo(i), extension)) continue;
    std::unique_ptr<Assimp::BaseImporter> removed(importer.GetImporter(i));
    if (importer.UnregisterLoader(removed.get()) != aiReturn_SUCCESS) {
      removed.release();
      throw InternalError("a mesh importer could not be unregistered");
    }
  }
}

// Collects the triangles of a tree of nodes, merging equal vertices.
class MeshBuilder {
 public:
  explicit MeshBuilder(const aiScene& scene) : scene_(scene) {}

  void add(const aiNode& node, const aiMatrix4x4& parent) {
    const aiMatrix4x4 transform = parent * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) add(*scene_.mMeshes[node.mMeshes[i]], transform);
    for (unsigned i = 0; i < node.mNumChildren; ++i) add(*node.mChildren[i], transform);
  }

  TriangleMesh mesh;

 private:
  void add(const aiMesh& source, const aiMatrix4x4& transform) {
    std::vector<std::uint32_t> index(source.mNumVertices);
    for (unsigned i = 0; i < source.mNumVertices; ++i) {
      const aiVector3D p = transform * source.mVertices[i];
      const Eigen::Vector3d point(static_cast<double>(p.x), static_cast<double>(p.y),
                                  static_cast<double>(p.z));
      if (!point.allFinite()) throw std::invalid_argument("a vertex is not finite");
      const auto [it, is_new] = indices_.try_emplace({point.x(), point.y(), point.z()},
                                                     static_cast<std::uint32_t>(mesh.vertices.size()));
      if (is_new) mesh.vertices.push_back(point);
      index[i] = it->second;
    }
    for (unsigned i = 0; i < source.mNumFaces; ++i) {
      const aiFace& face = source.mFaces[i];
      if (face.mNumIndices != 3) continue;  // points and lines bound nothing
      const std::array<std::uint32_t, 3> t{index[face.mIndices[0]], index[face.mIndices[1]],
                                           index[face.mIndices[2]]};
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) mesh.triangles.push_back(t);
    }
  }

  const aiScene& scene_;
  std::map<std::array<double, 3>, std::uint32_t> indices_;
};

double area(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3d a = mesh.vertices[t[1]] - mesh.vertices[t[0]];
    const Eigen::Vector3d b = mesh.vertices[t[2]] - mesh.vertices[t[0]];
    const Eigen::Vector3d normal(a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
                                 a.x() * b.y() - a.y() * b.x());
    sum += 0.5 * normal.norm();
  }
  return sum;
}

TriangleMesh readCollada(const std::string& path, const std::string& contents) {
  checkCollada(contents);
  Assimp::Importer importer;
  keepOnly("dae", importer);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS, aiComponent_NORMALS | aiComponent_COLORS |
                                                          aiComponent_TEXCOORDS | aiComponent_TEXTURES |
                                                          aiComponent_MATERIALS);
  const aiScene* scene = importer.ReadFile(path, aiProcess_RemoveComponent | aiProcess_Triangulate);
  if (!scene || !scene->mRootNode) {
    throw std::invalid_argument(std::string("not readable as dae: ") + importer.GetErrorString());
  }
  MeshBuilder builder(*scene);
  builder.add(*scene->mRootNode, aiMatrix4x4());
  return std::move(builder.mesh);
}

std::string contentsOf(const std::string& path) {
  constexpr std::uintmax_t kLargest = std::uintmax_t{1} << 31U;  // bytes
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) throw std::invalid_argument("no such file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error || size > kLargest) {
    throw std::invalid_argument(error ? error.message() : "it is larger than 2 GiB");
  }
  std::string contents(size, '\0');
  std::ifstream file(path, std::ios::binary);
  if (!file.read(contents.data(), static_cast<std::streamsize>(size))) {
    throw std::invalid_argument("it cannot be read");
  }
  return contents;
}

TriangleMesh readUnscaled(const std::string& path) {
  const std::string extension = lowerExtension(path);
  const std::vector<std::string> allowed{"stl", "obj", "ply", "dae"};
  if (std::find(allowed.begin(), allowed.end(), extension) == allowed.end()) {
    throw std::invalid_argument("extension '" + extension +
                                "' is not a mesh's; expected stl, obj, ply or dae");
  }
  const std::string contents = contentsOf(path);
  if (extension == "ply") return readPly(contents);
  if (extension == "stl") return readStl(contents);
  if (extension == "obj") return readObj(contents);
  return readCollada(path, contents);
}

}  // namespace

TriangleMesh scaled(const TriangleMesh& mesh, const Eigen::Vector3d& scale) {
  TriangleMesh result = mesh;
  for (Eigen::Vector3d& vertex : result.vertices) vertex = vertex.cwiseProduct(scale);
  if (scale.prod() < 0.0) {
    for (auto& triangle : result.triangles) std::swap(triangle[1], triangle[2]);
  }
  return result;
}

TriangleMesh readMesh(const std::string& path, const Eigen::Vector3d& scale) {
  try {
    TriangleMesh mesh = scaled(readUnscaled(path), scale);
    for (const Eigen::Vector3d& vertex : mesh.vertices) {
      if (!vertex.allFinite()) throw std::invalid_argument("a vertex is not finite");
    }
    if (mesh.triangles.empty()) throw std::invalid_argument("it holds no triangle");
    if (!(area(mesh) > 0.0)) throw std::invalid_argument("none of its triangles has an area");
    return mesh;
  } catch (const std::exception& error) {
    throw std::invalid_argument("mesh '" + path + "': " + error.what());
  }
}

}  // namespace cable_variation
