#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <yaml-cpp/yaml.h>

#include <cable_variation/scene_file/fault_list.h>
#include <cable_variation/util/quantity.h>

namespace cable_variation {

/// A place in a scene file, with a name for it to use in messages. Whatever is
/// wrong is added to the fault list; a reader goes on with the value returned
/// (not a number, empty, or the fallback) and asks the list afterwards.
class YamlCursor {
 public:
  YamlCursor(const YAML::Node& node, int line, std::string label, FaultList& faults)
      : node_(node), line_(line), label_(std::move(label)), faults_(&faults) {}

  int line() const { return line_; }  ///< from 1
  bool isMap() const { return node_.IsMap(); }
  bool isList() const { return node_.IsSequence(); }
  bool isScalar() const { return node_.IsScalar(); }
  FaultList& faults() const { return *faults_; }
  /// The same place under another name.
  YamlCursor labelled(std::string label) const { return {node_, line_, std::move(label), *faults_}; }

  /// Adds "label: message" at this line.
  void fail(const std::string& message) const;
  /// Likewise, of what is possible but implausible.
  void warn(const std::string& message) const;

  /// Whether this is a map; unknown and repeated keys are faults.
  bool checkKeys(const std::vector<std::string>& allowed) const;
  std::optional<YamlCursor> find(const std::string& key) const;
  /// As find(); absence is a fault.
  std::optional<YamlCursor> require(const std::string& key) const;
  bool has(const std::string& key) const { return find(key).has_value(); }
  /// Keys of a map in the file's order, with their values; then those of maps merged into it (<<).
  std::vector<std::pair<std::string, YamlCursor>> entries() const;
  /// The items of a list; a fault unless it is one, of `count` items if given.
  std::vector<YamlCursor> items(std::optional<std::size_t> count = {}) const;

  /// Whether a list or map has no more entries than a limit of that name; else a fault.
  bool isAtMost(std::size_t most, const char* limit) const;

  /// What is there, for a message: "found '5 deg'", "found a list".
  std::string found() const;
  /// found(), and what that is as a number, unless it is written like that already: "found '1e3 MPa', which
  /// is 1e9 Pa".
  std::string foundAs(double value, const std::string& unit) const;
  /// Whether this is a number without a unit.
  bool isBareNumber() const;

  /// Values of this place. An angle of several turns without a unit is warned of: it is in degrees as a rule.
  std::string text() const;
  bool flag() const;
  double number(const Quantity& quantity, const Range& range = Range::any()) const;
  Eigen::Vector3d vector(const Quantity& quantity) const;
  /// One of `allowed`, as its index there; 0 after a fault.
  std::size_t choice(const std::vector<std::string>& allowed) const;

  /// Values of a key that must be there.
  std::string text(const std::string& key) const;
  double number(const std::string& key, const Quantity& quantity, const Range& range = Range::any()) const;
  Eigen::Vector3d vector(const std::string& key, const Quantity& quantity) const;
  std::size_t choice(const std::string& key, const std::vector<std::string>& allowed) const;

  /// Values of a key that may be left out.
  double number(const std::string& key, const Quantity& quantity, const Range& range, double fallback) const;
  Eigen::Vector3d vector(const std::string& key, const Quantity& quantity,
                         const Eigen::Vector3d& fallback) const;
  bool flag(const std::string& key, bool fallback) const;

 private:
  void mergeInto(std::vector<std::pair<std::string, YamlCursor>>& entries) const;

  YAML::Node node_;
  int line_;
  std::string label_;
  FaultList* faults_;
};

}  // namespace cable_variation
