#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include <cable_variation/scene/resource_address.h>
#include <cable_variation/scene/scene.h>
#include <cable_variation/scene/scene_fault.h>

namespace cable_variation {

/// Every fault that a scene file has; what() lists them, one per line, as `file:line: message`.
class SceneError : public std::invalid_argument {
 public:
  explicit SceneError(std::vector<SceneFault> faults);
  const std::vector<SceneFault>& faults() const { return faults_; }

 private:
  std::vector<SceneFault> faults_;
};

/// Reads and checks a scene file (YAML); Scene::warnings has what is possible but implausible. Throws
/// SceneError.
Scene readScene(const std::string& path, const PackageFinder& find_package);

/// Likewise a text that is not in a file. @param source path that messages name, Scene::source
Scene readSceneText(const std::string& text, const std::string& source, const PackageFinder& find_package);

/// The text of a scene file. Throws std::invalid_argument that says what is wrong with the file, without its
/// name.
std::string readSceneFile(const std::string& path);

}  // namespace cable_variation
