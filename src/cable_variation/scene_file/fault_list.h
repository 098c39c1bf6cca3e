#pragma once

#include <string>
#include <vector>

#include <cable_variation/scene/scene_fault.h>
#include <cable_variation/util/input_limits.h>

namespace cable_variation {

/// The faults met while one scene file is read, and what is possible but implausible.
class FaultList {
 public:
  /// Thrown when nothing is to be read on, and caught by who began to read. It is no std::exception, which
  /// readers catch.
  struct Full {};

  explicit FaultList(std::string file, std::size_t most = InputLimits().faults)
      : file_(std::move(file)), most_(most) {}

  /// The message is made readable, see readableText(). Throws Full when there are `most` of them, the last
  /// of which says so.
  void add(int line, const std::string& message);
  std::size_t count() const { return faults_.size(); }
  /// No more than as many are kept.
  void warn(int line, const std::string& message);

  /// By line, each once.
  std::vector<SceneFault> sorted() const;
  std::vector<SceneFault> sortedWarnings() const;

 private:
  std::string file_;
  std::size_t most_;
  std::vector<SceneFault> faults_;
  std::vector<SceneFault> warnings_;
};

}  // namespace cable_variation
