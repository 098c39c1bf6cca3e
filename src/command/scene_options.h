#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <cable_variation/analysis/output_directory.h>
#include <cable_variation/analysis/run_control.h>
#include <cable_variation/scene/design.h>
#include <command/options.h>

namespace cable_variation_command {

/// The scene that a verb is about.
struct SceneOption {
  std::string scene;

  void declare(Options& options);
  /// Reads it. Throws as cable_variation::loadScene().
  cable_variation::Scene load(cable_variation::RunControl& control) const;
  /// The text of the file with the values of another scene, made from it by edits; comments and order stay.
  /// Throws as editedSceneText() and requireSame().
  std::string edited(const cable_variation::Scene& loaded, const cable_variation::Scene& wanted) const;

 private:
  std::string findPackage(const std::string& package) const;
};

/// Where files go, as the parameters of the solver's node say it.
struct FileOptions {
  std::string output_directory;  ///< empty: the working directory
  std::string author;

  void declare(Options& options);
  cable_variation::OutputDirectory output() const;
};

/// Throws UsageError if a file that would be written is one of those that are read.
void keepInputs(const std::vector<std::string>& inputs, const std::string& output);

/// What a calculation may use, likewise.
struct LimitOptions {
  std::uint64_t threads = 0;
  double memory_limit = 2e9;  ///< [B]

  void declare(Options& options);
};

/// Design variables off their nominal values: names and values, as two lists or as NAME=VALUE.
class ValueOptions {
 public:
  /// @param names,values of the two options
  void declare(const char* names, const char* values, Options& options);

  /// Into a request. Values are SI, or have a unit that fits the variable. Throws NotFound for a name that is
  /// none, and std::invalid_argument for a value that is none of the variable and for a count that is
  /// another.
  void resolve(const cable_variation::Scene& scene, std::vector<std::string>& names,
               std::vector<double>& values) const;
  /// Likewise, as the core takes them.
  cable_variation::DesignValues values(const cable_variation::Scene& scene) const;

 private:
  std::vector<std::string> names_, values_, pairs_;
  std::string names_option_, values_option_;
};

/// A recorded motion that has its component somewhere at a time.
void declareMotion(std::string& motion, double& time, Options& options);
/// Where that is; nowhere else without a motion. Throws as cable_variation::placesDuring(), and UsageError
/// for a time without a motion.
cable_variation::ComponentPoses placesAt(const cable_variation::Design& design, const std::string& motion,
                                         double time);

}  // namespace cable_variation_command
