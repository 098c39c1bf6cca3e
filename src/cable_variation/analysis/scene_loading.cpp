#include <cable_variation/analysis/scene_loading.h>

#include <filesystem>
#include <stdexcept>

#include <cable_variation/scene/motion_samples.h>
#include <cable_variation/scene_file/plausibility.h>
#include <cable_variation/scene_file/scene_reader.h>
#include <cable_variation/util/error.h>

namespace cable_variation {

namespace {

std::string parentOf(const Scene& scene, const std::string& name) {
  for (const Component& component : scene.components) {
    if (component.name == name) return component.parent;
  }
  throw std::invalid_argument("no component named '" + name + "'");
}

void readBag(const BagReader& read_bag, const Scene& scene, Motion& motion) {
  if (!read_bag) {
    throw std::invalid_argument(
        "is recorded in a bag, which only the ROS nodes read; expected a file of poses, .tum");
  }
  read_bag(motion.path, motion.topic, motion.frame, parentOf(scene, motion.component), motion);
}

}  // namespace

std::string resolveAddress(const std::string& address, const PackageFinder& find_package,
                           std::uintmax_t most_bytes, const std::vector<std::string>& folders) {
  if (address.find("://") != std::string::npos) {
    try {
      return localPath(address, find_package, most_bytes, folders);
    } catch (const std::invalid_argument& error) {
      throw NotFound(error.what());
    }
  }
  try {
    requireWithin(address, folders);
  } catch (const std::invalid_argument& error) {
    throw NotFound(error.what());
  }
  const std::string obstacle = obstacleTo(address, most_bytes);
  if (!obstacle.empty()) {
    std::error_code ignored;
    const std::filesystem::path where = std::filesystem::absolute(address, ignored);
    throw NotFound("'" + where.string() + "' " + obstacle);
  }
  return address;
}

Scene loadScene(const std::string& address, const PackageFinder& find_package, const BagReader& read_bag,
                const InputLimits& limits) {
  std::string path;
  try {
    path = resolveAddress(address, find_package, limits.scene_bytes, limits.folders);
  } catch (const NotFound& error) {
    throw NotFound("scene '" + address + "': " + error.what());
  }
  Scene scene = readScene(path, find_package, limits);
  std::vector<SceneFault> faults;
  for (Motion& motion : scene.motions) {
    if (!isBag(motion.file)) continue;
    const std::string who = "motion '" + motion.name + "': ";
    try {
      readBag(read_bag, scene, motion);
    } catch (const std::exception& error) {
      faults.push_back({path, motion.line, who + error.what()});
      continue;
    }
    for (const std::string& remark : {noteOnReplaced(motion), slipOf(motion, scene)}) {
      if (!remark.empty()) scene.warnings.push_back({path, motion.line, who + remark});
    }
  }
  if (!faults.empty()) throw SceneError(faults);
  return scene;
}

std::vector<std::string> warningsOf(const Scene& scene) {
  std::vector<std::string> texts;
  for (const SceneFault& warning : scene.warnings) texts.push_back(toString(warning));
  return texts;
}

}  // namespace cable_variation
