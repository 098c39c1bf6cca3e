#pragma once

// Scenes of data/faults: each once got a wrong answer, or none.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <cable_variation/scene_file/scene_reader.h>

#include "test_packages.h"
#include "envelope/envelope_scenes.h"

namespace cable_variation::test {

inline Scene sceneOfFile(const std::string& folder, const std::string& name) {
  return readScene(findTestPackage("test_data") + "/faults/" + folder + "/" + name + ".yaml",
                   findTestPackage);
}

/// The scene that these lines of YAML say.
inline Scene sceneOfLines(const std::vector<std::string>& lines) {
  const TemporaryFile file("scene.yaml", lines);
  return readScene(file.path(), findTestPackage);
}

inline std::vector<std::string> warningsOf(const Scene& scene) {
  std::vector<std::string> messages;
  for (const SceneFault& warning : scene.warnings) messages.push_back(warning.message);
  return messages;
}

/// What reading the lines ends with: every fault's message in a line; "" if there are none.
inline std::string refusalOf(const std::vector<std::string>& lines) {
  try {
    sceneOfLines(lines);
  } catch (const SceneError& error) {
    std::string all;
    for (const SceneFault& fault : error.faults()) all += fault.message + "\n";
    return all;
  }
  return "";
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// A scene, its design and the shape of that.
struct SolvedFile {
  explicit SolvedFile(Scene of)
      : scene(std::move(of)), solver(solverOf(scene)), solved(solveAt(scene, {}, solver)) {}

  MeasureValue value(std::size_t measure) const {
    const MeasureEvaluator evaluator(scene, solved.view());
    return evaluator.evaluate(solved.view(), {measure})[0];
  }
  const Equilibrium& answer() const { return solved.equilibrium; }
  Eigen::Vector3d tip() const { return answer().shapes[0].position(solved.harness.cables[0].length); }
  Eigen::Vector3d middle() const {
    return answer().shapes[0].position(0.5 * solved.harness.cables[0].length);
  }

  Scene scene;
  EquilibriumSolver solver;
  Solved solved;
};

}  // namespace cable_variation::test
