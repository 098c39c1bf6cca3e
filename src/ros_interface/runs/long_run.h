#pragma once

#include <cstddef>
#include <string>

#include <cable_variation/analysis/output_directory.h>
#include <cable_variation/analysis/run_control.h>

namespace cable_variation_ros {

class SolverContext;

/// What every long run of the node may use.
struct RunLimits {
  std::size_t threads = 0;                  ///< for each run; 0: as many as there are cores
  double memory_limit = 2e9;                ///< likewise [B]
  cable_variation::OutputDirectory output;  ///< for files
  double memory_total = 8e9;                ///< for all that are at work at once [B]
};

/// A long calculation, from its request to its answer: what is to be done, not when and on which thread,
/// which is for a Runner. It is used by one thread after another, never by two at a time.
class LongRun {
 public:
  virtual ~LongRun() = default;

  /// First, while the node's thread waits: checks the request, and copies what is needed of the design in
  /// force. Throws std::invalid_argument and cable_variation::NotFound that name the field.
  virtual void prepare(const SolverContext& context) = 0;
  /// What its files are named by; empty: it writes none. Once prepared.
  virtual const std::string& name() const = 0;
  /// Then, on a thread of its own: calculates, and writes the files. Throws what goes wrong.
  /// @param control told how far it is, and asked several times a second whether it is cancelled
  virtual void calculate(cable_variation::RunControl& control) = 0;
  /// Whether a run that is cancelled has an answer too, of what was done until then; else calculate() throws
  /// cable_variation::Cancelled.
  virtual bool keepsWhatWasDone() const = 0;
  /// At last, while the node's thread waits: shows the result in RViz unless it belongs to another design
  /// than the one in force: false.
  virtual bool show(const SolverContext& context) = 0;
  /// After all: to the answer.
  virtual void warn(const std::string& warning) = 0;
};

}  // namespace cable_variation_ros
