#include <command/scene_options.h>

#include <filesystem>
#include <map>
#include <stdexcept>
#include <system_error>

#include <cable_variation/analysis/design_trial.h>
#include <cable_variation/analysis/design_values.h>
#include <cable_variation/analysis/name_lookup.h>
#include <cable_variation/analysis/scene_loading.h>
#include <cable_variation/scene/package_finder.h>
#include <cable_variation/scene_file/scene_reader.h>
#include <cable_variation/scene_file/scene_writer.h>
#include <cable_variation/util/quantity.h>
#include <cable_variation/util/unit.h>

namespace cable_variation_command {

using cable_variation::DesignVariable;
using cable_variation::Scene;

namespace {

double valueOf(const std::string& text, const DesignVariable& variable) {
  const cable_variation::Dimension dimension = cable_variation::parseUnit(variable.unit).dimension;
  const cable_variation::Quantity quantity{"a value", variable.unit.c_str(), "5", dimension, ""};
  try {
    return cable_variation::parseQuantity(text, quantity);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("design variable '" + variable.name + "': " + error.what());
  }
}

}  // namespace

void SceneOption::declare(Options& options) {
  options.word("SCENE", scene,
               "a scene file: its path, or a package:// or file:// address; before the options");
}

std::string SceneOption::findPackage(const std::string& package) const {
  return cable_variation::findPackageNear(package, scene);
}

std::string SceneOption::edited(const Scene& loaded, const Scene& wanted) const {
  const auto find = [&](const std::string& package) { return findPackage(package); };
  const cable_variation::InputLimits limits;
  const std::string path = cable_variation::resolveAddress(scene, find, limits.scene_bytes, limits.folders);
  const std::string text = editedSceneText(cable_variation::readSceneFile(path, limits), loaded, wanted);
  requireSame(cable_variation::readSceneText(text, scene, find, limits), wanted);
  return text;
}

Scene SceneOption::load(cable_variation::RunControl& control) const {
  control.report({"reading"});
  std::map<std::string, std::string> known;  // looking for one takes a while
  const auto find = [&](const std::string& package) {
    const auto [place, is_new] = known.emplace(package, "");
    if (is_new) place->second = findPackage(package);
    return place->second;
  };
  return cable_variation::loadScene(scene, find, nullptr);
}

void FileOptions::declare(Options& options) {
  options.text("output_directory", "FOLDER", output_directory,
               "where files go; default: the working directory");
  options.text("author", "TEXT", author, "who the report says it is by");
}

cable_variation::OutputDirectory FileOptions::output() const {
  return cable_variation::OutputDirectory(output_directory.empty() ? std::filesystem::current_path().string()
                                                                   : output_directory);
}

void keepInputs(const std::vector<std::string>& inputs, const std::string& output) {
  for (const std::string& input : inputs) {
    std::error_code none;
    if (std::filesystem::equivalent(input, output, none))
      throw UsageError("'" + output +
                       "' is read, and would be written over; expected another name for the output");
  }
}

void LimitOptions::declare(Options& options) {
  options.count("threads", "COUNT", threads, "default: as many as there are cores");
  options.number("memory_limit", "BYTES", "", memory_limit, "that the calculation may take; default: 2e9");
}

void declareMotion(std::string& motion, double& time, Options& options) {
  options.text("motion", "NAME", motion, "components at this motion's pose at --time");
  options.number("time", "TIME", "s", time, "of the motion");
}

cable_variation::ComponentPoses placesAt(const cable_variation::Design& design, const std::string& motion,
                                         double time) {
  if (!motion.empty()) return placesDuring(design, motion, time);
  if (time != 0.0) throw UsageError("--time: is given without --motion, whose time it is");
  return {};
}

void ValueOptions::declare(const char* names, const char* values, Options& options) {
  names_option_ = names;
  values_option_ = values;
  options.texts(names, "NAME", names_, "design variables off their nominal values");
  options.texts(values, "VALUE", values_, "one each, SI or with a unit, as 5deg");
  options.texts("set", "NAME=VALUE", pairs_, "both in one");
}

cable_variation::DesignValues ValueOptions::values(const Scene& scene) const {
  std::vector<std::string> names;
  std::vector<double> given;
  resolve(scene, names, given);
  return toDesignValues(scene, names, given);
}

void ValueOptions::resolve(const Scene& scene, std::vector<std::string>& names,
                           std::vector<double>& values) const {
  if (names_.size() != values_.size()) {
    throw UsageError("--" + names_option_ + " has " + std::to_string(names_.size()) + " names, --" +
                     values_option_ + " " + std::to_string(values_.size()) +
                     " values: expected one value each");
  }
  const auto add = [&](const std::string& name, const std::string& value) {
    const std::size_t index = indexOf(name, scene.design_variables, "design variable");
    names.push_back(name);
    values.push_back(valueOf(value, scene.design_variables[index]));
  };
  for (std::size_t i = 0; i < names_.size(); ++i) add(names_[i], values_[i]);
  for (const std::string& pair : pairs_) {
    const std::size_t equals = pair.find('=');
    if (equals == std::string::npos) throw UsageError("--set: is '" + pair + "', expected NAME=VALUE");
    add(pair.substr(0, equals), pair.substr(equals + 1));
  }
}

}  // namespace cable_variation_command
