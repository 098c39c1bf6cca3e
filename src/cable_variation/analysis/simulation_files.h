#pragma once

#include <memory>
#include <string>

#include <cable_variation/simulation/simulation.h>
#include <cable_variation/analysis/design_snapshot.h>
#include <cable_variation/analysis/output_directory.h>
#include <cable_variation/analysis/simulation_task.h>

namespace cable_variation {

class SampleCsv;

/// Paths; empty: not written.
struct SimulationPaths {
  std::string samples;  ///< NAME.csv; NAME.csv.partial: not all samples are in it
  std::string statistics, contributions, report;
};

/// Whether the disk has room for the samples of a simulation, as NAME.csv and as blocks, as far as their
/// number is known. Throws FileError that names the folder, what is free there and about how much it takes.
void requireSpace(const OutputDirectory& output, const SimulationTask& task, const Scene& scene);

/// The files of a simulation. What goes wrong with one is kept and told, and ends nothing: a disk that fills
/// must not cost the statistics.
class SimulationFiles {
 public:
  /// Opens NAME.csv. No name: no files. What is referred to must outlive this.
  /// Throws FileError that names the file or the folder.
  SimulationFiles(const OutputDirectory& output, const SimulationTask& task, const Scene& scene,
                  const DesignOrigin& origin);
  ~SimulationFiles();

  /// Takes every sample; empty if there are no files.
  SampleReceiver receiver();

  /// Closes the samples, which keep their .partial name if the simulation ended early or some of them are
  /// not there, and writes statistics and report of what was done.
  SimulationPaths finish(const Simulation& simulation);

  /// What went wrong, and with which file; empty: nothing.
  const std::string& error() const { return error_; }

 private:
  template <typename Write>
  bool attempt(const Write& write);
  std::string written(const std::string& suffix, const std::string& contents);

  const OutputDirectory& output_;
  const SimulationTask& task_;
  const Scene& scene_;
  const DesignOrigin& origin_;
  std::string samples_path_;
  std::unique_ptr<SampleCsv> samples_;
  bool samples_broken_ = false;
  std::string error_;
};

}  // namespace cable_variation
