#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include <cable_variation/scene/resource_address.h>
#include <cable_variation/scene/scene.h>
#include <cable_variation/scene/scene_fault.h>
#include <cable_variation/util/input_limits.h>

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
/// @param limits of this file and those it names
Scene readScene(const std::string& path, const PackageFinder& find_package, const InputLimits& limits = {});

/// Likewise a text that is not in a file. @param source path that messages name, Scene::source
Scene readSceneText(const std::string& text, const std::string& source, const PackageFinder& find_package,
                    const InputLimits& limits = {});

/// The text of a scene file. Throws std::invalid_argument that says what is wrong with the file, without its
/// name.
std::string readSceneFile(const std::string& path, const InputLimits& limits = {});

}  // namespace cable_variation
