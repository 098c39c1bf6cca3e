#pragma once

#include <string>
#include <vector>

#include <cable_variation/scene/scene_fault.h>

namespace cable_variation {

/// The faults met while one scene file is read, and what is possible but implausible.
class FaultList {
 public:
  explicit FaultList(std::string file) : file_(std::move(file)) {}

  /// The message is made readable, see readableText().
  void add(int line, const std::string& message);
  std::size_t count() const { return faults_.size(); }
  void warn(int line, const std::string& message);

  /// By line, each once.
  std::vector<SceneFault> sorted() const;
  std::vector<SceneFault> sortedWarnings() const;

 private:
  std::string file_;
  std::vector<SceneFault> faults_;
  std::vector<SceneFault> warnings_;
};

}  // namespace cable_variation
