#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include <cable_variation/scene/scene.h>

namespace cable_variation {

/// One fault of a scene file.
struct SceneFault {
  std::string file;
  int line = 0;         ///< from 1; 0: the file as a whole
  std::string message;  ///< what is there and what was expected
};

/// Every fault that a scene file has; what() lists them, one per line, as `file:line: message`.
class SceneError : public std::invalid_argument {
 public:
  explicit SceneError(std::vector<SceneFault> faults);
  const std::vector<SceneFault>& faults() const { return faults_; }

 private:
  std::vector<SceneFault> faults_;
};

/// Finds the folder of a package for package:// addresses; empty: not found.
using PackageFinder = std::function<std::string(const std::string& package)>;

/// Reads and checks a scene file (YAML). Throws SceneError.
Scene readScene(const std::string& path, const PackageFinder& find_package);

}  // namespace cable_variation
