#pragma once

#include <memory>
#include <string>

#include <cable_variation/SimulateVariation.h>

#include <cable_variation/simulation/simulation.h>
#include <ros_interface/context/solver_context.h>
#include <ros_interface/node/output_directory.h>
#include <ros_interface/runs/simulation_task.h>

namespace cable_variation {
class SampleCsv;
}

namespace cable_variation_ros {

/// The files of a simulation. What goes wrong with one is kept and told, and ends nothing: a disk that fills
/// must not cost the statistics.
class SimulationFiles {
 public:
  /// Opens NAME.csv. No name: no files. What is referred to must outlive this.
  /// Throws cable_variation::FileError that names the file or the folder.
  SimulationFiles(const OutputDirectory& output, const SimulationTask& task,
                  const cable_variation::Scene& scene, const DesignOrigin& origin);
  ~SimulationFiles();

  /// Takes every sample; empty if there are no files.
  cable_variation::SampleReceiver receiver();

  /// Closes the samples, which keep their .partial name if the simulation ended early or some of them are
  /// not there, and writes statistics and report of what was done; `response` gets the paths.
  void finish(const cable_variation::Simulation& simulation,
              cable_variation::SimulateVariationResponse& response);

  /// What went wrong, and with which file; empty: nothing.
  const std::string& error() const { return error_; }

 private:
  template <typename Write>
  bool attempt(const Write& write);
  std::string written(const std::string& suffix, const std::string& contents);

  const OutputDirectory& output_;
  const SimulationTask& task_;
  const cable_variation::Scene& scene_;
  const DesignOrigin& origin_;
  std::string samples_path_;
  std::unique_ptr<cable_variation::SampleCsv> samples_;
  bool samples_broken_ = false;
  std::string error_;
};

}  // namespace cable_variation_ros
