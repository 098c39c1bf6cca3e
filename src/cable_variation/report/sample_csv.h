#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <cable_variation/scene/scene.h>
#include <cable_variation/simulation/simulation_statistics.h>

namespace cable_variation {

/// Samples of a simulation, written as they come: one line each, with a heading; SI units, 17 significant
/// digits. Until all are there the file is named `path`.partial, and so it stays if they do not come: a file
/// of the name `path` is complete.
class SampleCsv {
 public:
  /// @param values of the design simulated, as StabilityOptions::values; variables are written with them, not
  /// as deviations. Throws FileError that names the file and what the system says, or that another
  /// run, of this process or not, writes it now.
  SampleCsv(const std::string& path, const Scene& scene, const std::vector<std::size_t>& variables,
            const std::vector<std::size_t>& measures, const DesignValues& values);

  /// Throws FileError that names the file and what the system says (the disk is full): what follows
  /// is not in the file, so leave it there.
  /// @param measured one per measure; not read without an equilibrium: nan
  void add(std::uint64_t index, SampleOutcome outcome, const double* deviations, const double* measured);

  /// All samples are there: they are brought to the disk and the file gets its name. Throws as add().
  void finish();

  /// No more samples come: those that are there are written and keep the name partialPath(). Throws as add().
  void stop();

  const std::string& partialPath() const { return partial_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  void requireOpen() const;
  void write(const std::string& line);
  [[noreturn]] static void fail(const std::string& file, int error);

  std::string path_, partial_;
  std::vector<double> nominal_;
  std::size_t measures_;
  std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace cable_variation
