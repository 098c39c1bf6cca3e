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

}  // namespace cable_variation
