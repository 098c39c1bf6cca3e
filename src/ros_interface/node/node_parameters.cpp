#include <ros_interface/node/node_parameters.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include <ros/node_handle.h>

#include <cable_variation/util/name_list.h>

namespace cable_variation_ros {

namespace {

/// Reads parameters one by one and keeps what is wrong with them.
class ParameterReader {
 public:
  explicit ParameterReader(const ros::NodeHandle& node) : node_(node) {}

  void required(const std::string& name, std::string& value) {
    if (!node_.hasParam(name)) {
      fault(name, "is missing");
    } else if (!node_.getParam(name, value)) {
      fault(name, "expected a string");
    } else if (value.empty()) {
      fault(name, "is empty");
    }
  }

  void optional(const std::string& name, bool& value) {
    if (node_.hasParam(name) && !node_.getParam(name, value)) fault(name, "expected true or false");
  }

  void optional(const std::string& name, std::string& value) {
    if (node_.hasParam(name)) required(name, value);
  }

  void optionalOrEmpty(const std::string& name, std::string& value) {
    if (node_.hasParam(name) && !node_.getParam(name, value)) fault(name, "expected a string");
  }

  void optionalPositive(const std::string& name, double& value, double upper, double lower = 0.0) {
    if (!node_.hasParam(name)) return;
    if (!node_.getParam(name, value)) {
      fault(name, "expected a number");
    } else if (!(value > 0.0 && value >= lower && value <= upper)) {
      std::ostringstream text;
      text << "is " << value << ", expected " << (lower > 0.0 ? "at least " : "above ") << lower
           << ", at most " << upper;
      fault(name, text.str());
    }
  }

  void optionalCount(const std::string& name, std::size_t& value, int upper) {
    if (!node_.hasParam(name)) return;
    int count = 0;
    if (!node_.getParam(name, count)) {
      fault(name, "expected a whole number");
    } else if (count < 0 || count > upper) {
      fault(name, "is " + std::to_string(count) + ", expected 0 to " + std::to_string(upper));
    } else {
      value = static_cast<std::size_t>(count);
    }
  }

  /// ~limits: a map from the names of bounds to whole numbers, and `folders`.
  void optionalLimits(cable_variation::InputLimits& limits) {
    XmlRpc::XmlRpcValue given;
    if (!node_.getParam("limits", given)) return;
    if (given.getType() != XmlRpc::XmlRpcValue::TypeStruct) {
      fault("limits", "expected a map from names to bounds");
      return;
    }
    for (auto& [name, value] : given) {
      if (name == "folders") {
        readFolders(value, limits.folders);
      } else {
        readLimit(name, value, limits);
      }
    }
  }

  void finish() const {
    if (!faults_.empty()) throw std::invalid_argument("parameters:" + faults_);
  }

 private:
  void readLimit(const std::string& name, XmlRpc::XmlRpcValue& value, cable_variation::InputLimits& limits) {
    constexpr double kMost = 1e15;
    std::vector<std::string> known;
    for (const cable_variation::InputLimitRow& row : cable_variation::inputLimitRows()) {
      known.emplace_back(row.name);
      if (name != row.name) continue;
      const bool whole = value.getType() == XmlRpc::XmlRpcValue::TypeInt;
      if (!whole && value.getType() != XmlRpc::XmlRpcValue::TypeDouble) {
        fault("limits/" + name, "expected a number");
        return;
      }
      const double bound = whole ? static_cast<double>(static_cast<int>(value)) : static_cast<double>(value);
      if (!(bound >= 1.0 && bound <= kMost)) {
        std::ostringstream text;
        text << "is " << bound << ", expected 1 to " << kMost;
        fault("limits/" + name, text.str());
        return;
      }
      limits.*row.value = static_cast<std::size_t>(bound);
      return;
    }
    fault("limits/" + name, "is no limit" + cable_variation::didYouMean(name, known));
  }

  void readFolders(XmlRpc::XmlRpcValue& value, std::vector<std::string>& folders) {
    const bool list = value.getType() == XmlRpc::XmlRpcValue::TypeArray;
    for (int i = 0; list && i < value.size(); ++i) {
      if (value[i].getType() != XmlRpc::XmlRpcValue::TypeString) continue;
      folders.push_back(static_cast<std::string>(value[i]));
      if (folders.back().empty() || folders.back().front() != '/') {
        fault("limits/folders", "has '" + folders.back() + "', expected absolute paths");
      }
    }
    if (!list || folders.size() != static_cast<std::size_t>(value.size())) {
      fault("limits/folders", "expected a list of paths");
    }
  }

  void fault(const std::string& name, const std::string& what) {
    faults_ += "\n  " + node_.resolveName(name) + " " + what;
  }

  const ros::NodeHandle& node_;
  std::string faults_;
};

constexpr double kHighestRate = 1000.0;  // [Hz]; beyond what ROS timers and tf keep up with
constexpr double kHighestSpeed = 1e4;
constexpr double kLongestTimeout = 1e9;  // [s]
constexpr double kMostMemory = 1e15;     // [B]
constexpr int kMostThreads = 1024;       // more than any machine has cores for them

/// A node's parameters, as `read` reads them.
template <typename Parameters, typename Read>
Parameters readParameters(const ros::NodeHandle& node, const Read& read) {
  Parameters parameters;
  ParameterReader reader(node);
  read(reader, parameters);
  reader.finish();
  return parameters;
}

/// Of a node that can do without a scene while it waits for a cable_solver's.
template <typename Parameters>
void readSceneOrFollow(ParameterReader& reader, Parameters& parameters) {
  reader.optional("follow", parameters.follow);
  if (parameters.follow) {
    reader.optional("scene", parameters.scene);
  } else {
    reader.required("scene", parameters.scene);
  }
}

}  // namespace

StaticGeometryParameters readStaticGeometryParameters(const ros::NodeHandle& node) {
  return readParameters<StaticGeometryParameters>(
      node, [](ParameterReader& reader, StaticGeometryParameters& parameters) {
        readSceneOrFollow(reader, parameters);
        reader.optionalLimits(parameters.limits);
      });
}

MovingGeometryParameters readMovingGeometryParameters(const ros::NodeHandle& node) {
  return readParameters<MovingGeometryParameters>(
      node, [](ParameterReader& reader, MovingGeometryParameters& parameters) {
        readSceneOrFollow(reader, parameters);
        reader.optionalLimits(parameters.limits);
        reader.optionalPositive("rate", parameters.rate_hz, kHighestRate);
        reader.optional("loop", parameters.loop);
        reader.optionalPositive("speed", parameters.speed, kHighestSpeed);
        reader.optional("joint_states", parameters.joint_states);
      });
}

CableSolverParameters readCableSolverParameters(const ros::NodeHandle& node) {
  return readParameters<CableSolverParameters>(node, [](ParameterReader& reader,
                                                        CableSolverParameters& parameters) {
    reader.required("scene", parameters.scene);
    reader.optional("live", parameters.live);
    reader.optionalPositive("live_rate", parameters.live_rate_hz, kHighestRate);
    reader.optionalPositive("tf_timeout", parameters.tf_timeout, kLongestTimeout);
    reader.optional("interactive", parameters.interactive);
    reader.optional("live_topics", parameters.live_topics);
    reader.optionalCount("threads", parameters.threads, kMostThreads);
    reader.optionalPositive("memory_limit", parameters.memory_limit, kMostMemory);
    parameters.memory_total = std::max(parameters.memory_total, parameters.memory_limit);
    reader.optionalPositive("memory_total", parameters.memory_total, kMostMemory, parameters.memory_limit);
    reader.optional("output_directory", parameters.output_directory);
    reader.optionalOrEmpty("state_file", parameters.state_file);
    if (!parameters.state_file.empty()) {
      // a relative one is in the output directory
      parameters.state_file = std::filesystem::absolute(parameters.output_directory) / parameters.state_file;
    }
    reader.optional("author", parameters.author);
    reader.optionalLimits(parameters.limits);
  });
}

}  // namespace cable_variation_ros
