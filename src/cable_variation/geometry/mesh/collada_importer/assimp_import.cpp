#include <cable_variation/geometry/mesh/collada_importer/assimp_import.h>

#include <limits>
#include <memory>
#include <sstream>
#include <stdexcept>

#include <assimp/BaseImporter.h>
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

namespace cable_variation {
namespace {

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
      throw std::logic_error("a mesh importer could not be unregistered");
    }
  }
}

// Collects the triangles of a tree of nodes.
class Collector {
 public:
  Collector(const aiScene& scene, std::size_t most) : scene_(scene), most_(most) {}

  void add(const aiNode& node, const aiMatrix4x4& parent) {
    const aiMatrix4x4 transform = parent * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) add(*scene_.mMeshes[node.mMeshes[i]], transform);
    for (unsigned i = 0; i < node.mNumChildren; ++i) add(*node.mChildren[i], transform);
  }

  ImportedMesh mesh;

 private:
  void add(const aiMesh& source, const aiMatrix4x4& transform) {
    const std::size_t first = mesh.points.size();
    if (source.mNumFaces > most_ - mesh.triangles.size() || source.mNumVertices > 3 * most_ - first ||
        first + source.mNumVertices > std::numeric_limits<std::uint32_t>::max()) {
      throw std::invalid_argument("it has more triangles than the " + std::to_string(most_) +
                                  " of the limit triangles");
    }
    for (unsigned i = 0; i < source.mNumVertices; ++i) {
      const aiVector3D p = transform * source.mVertices[i];
      mesh.points.push_back({static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)});
    }
    for (unsigned i = 0; i < source.mNumFaces; ++i) {
      const aiFace& face = source.mFaces[i];
      if (face.mNumIndices != 3) continue;  // points and lines bound nothing
      std::array<std::uint32_t, 3> corners{};
      for (std::size_t k = 0; k < 3; ++k) corners[k] = static_cast<std::uint32_t>(first + face.mIndices[k]);
      mesh.triangles.push_back(corners);
    }
  }

  const aiScene& scene_;
  std::size_t most_;
};

}  // namespace

ImportedMesh importCollada(const std::string& document, std::size_t most_triangles) {
  Assimp::Importer importer;
  keepOnly("dae", importer);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS, aiComponent_NORMALS | aiComponent_COLORS |
                                                          aiComponent_TEXCOORDS | aiComponent_TEXTURES |
                                                          aiComponent_MATERIALS);
  const aiScene* scene = importer.ReadFileFromMemory(
      document.data(), document.size(), aiProcess_RemoveComponent | aiProcess_Triangulate, "dae");
  if (!scene || !scene->mRootNode) {
    throw std::invalid_argument(std::string("not readable as dae: ") + importer.GetErrorString());
  }
  Collector collector(*scene, most_triangles);
  collector.add(*scene->mRootNode, aiMatrix4x4());
  return std::move(collector.mesh);
}

}  // namespace cable_variation
