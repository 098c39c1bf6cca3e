#include <cable_variation/analysis/simulation_identity.h>

#include <algorithm>
#include <charconv>
#include <system_error>
#include <stdexcept>

#include <cable_variation/util/build_identity.h>
#include <cable_variation/util/byte_stream.h>
#include <cable_variation/util/number_text.h>
#include <cable_variation/util/sha256.h>

namespace cable_variation {

namespace {

std::string exact(double number) { return numberText(number); }

template <typename Named>
std::string namesOf(const std::vector<std::size_t>& indices, const std::vector<Named>& all) {
  std::string names;
  for (const std::size_t index : indices) names += (names.empty() ? "" : " ") + all[index].name;
  return names;
}

void write(const Pose& pose, ByteWriter& bytes) {
  bytes.write(pose.position.data(), 3);
  bytes.write(pose.orientation.coeffs().data(), 4);
}

// The triangles of all parts.
std::string hashOfParts(const Scene& scene) {
  ByteWriter bytes;
  for (const Component& component : scene.components) {
    write(component.pose, bytes);
    for (const Visual& visual : component.visuals) {
      write(visual.pose, bytes);
      if (!visual.mesh) continue;
      bytes.write<std::uint64_t>(visual.mesh->vertices.size());
      for (const Eigen::Vector3d& vertex : visual.mesh->vertices) bytes.write(vertex.data(), 3);
      for (const auto& triangle : visual.mesh->triangles) bytes.write(triangle.data(), triangle.size());
    }
  }
  return sha256(bytes.take());
}

std::string hashOfMotions(const Scene& scene, const std::vector<std::size_t>& motions) {
  ByteWriter bytes;
  for (const std::size_t motion : motions) {
    for (const TimedPose& sample : scene.motions[motion].samples) {
      bytes.write(sample.time);
      write(sample.pose, bytes);
    }
  }
  return sha256(bytes.take());
}

std::string readable(const std::string& value) { return value.empty() ? "none" : value; }

std::uint64_t wholeNumber(const std::string& name, const std::string& text) {
  std::uint64_t number = 0;
  const char* const end = text.data() + text.size();
  const std::from_chars_result read = std::from_chars(text.data(), end, number);
  if (read.ec != std::errc() || read.ptr != end)
    throw std::invalid_argument(name + ": is '" + text + "', expected a whole number");
  return number;
}

double realNumber(const std::string& name, const std::string& text) {
  double number = 0.0;
  const std::from_chars_result read = readNumber(text, number);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size())
    throw std::invalid_argument(name + ": is '" + text + "', expected a number");
  return number;
}

}  // namespace

SimulationIdentity identityOf(const SimulationTask& task, const DesignSnapshot& snapshot) {
  const SimulationOptions& options = task.options;
  const Scene& scene = snapshot.design.scene;
  std::string values;
  for (const auto& [name, value] : options.values)
    values += (values.empty() ? "" : " ") + name + "=" + exact(value);
  SimulationIdentity identity{{"build", buildIdentity()},
                              {"machine", machineIdentity()},
                              {"scene", snapshot.origin.source_hash},
                              {"triangles of the parts", hashOfParts(scene)},
                              {"poses of the motions", hashOfMotions(scene, options.motions)},
                              {"variables", namesOf(options.variables, scene.design_variables)},
                              {"measures", namesOf(options.measures, scene.measures)},
                              {"motions", namesOf(options.motions, scene.motions)},
                              {"values", values},
                              {"sampler", toString(options.sampler)},
                              {"seed", std::to_string(options.seed)},
                              {"sigma_error", exact(options.sigma_error)},
                              {"confidence", exact(options.confidence)},
                              {"from_time", exact(options.from)},
                              {"to_time", exact(options.to)},
                              {"times", std::to_string(options.most_times)},
                              {"sections", std::to_string(options.sections)}};
  if (options.sampler == SamplerType::latin_hypercube)
    identity.emplace_back("samples", std::to_string(options.samples));
  return identity;
}

std::string differenceOf(const SimulationIdentity& one, const std::string& first,
                         const SimulationIdentity& other, const std::string& second) {
  std::string text;
  for (std::size_t i = 0; i < std::max(one.size(), other.size()); ++i) {
    const std::string name = i < one.size() ? one[i].first : other[i].first;
    const std::string here = i < one.size() ? one[i].second : "";
    const std::string there = i < other.size() ? other[i].second : "";
    if (here == there) continue;
    text += (text.empty() ? "" : "; ") + name + ": " + readable(here) + " " + first + ", " + readable(there) +
            " " + second;
  }
  return text;
}

std::string toText(const SimulationIdentity& identity) {
  std::string text;
  for (const auto& [name, value] : identity) {
    text += name + "=";
    for (const char c : value) text += c == '\n' ? ' ' : c;
    text += "\n";
  }
  return text;
}

SimulationIdentity identityFrom(const std::string& text) {
  SimulationIdentity identity;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = text.find('\n', start), equals = text.find('=', start);
    if (end == std::string::npos || equals == std::string::npos || equals > end)
      throw std::invalid_argument("a line without NAME=VALUE");
    identity.emplace_back(text.substr(start, equals - start), text.substr(equals + 1, end - equals - 1));
    start = end + 1;
  }
  return identity;
}

SimulationIdentity requestLines(const SimulationRequest& request) {
  SimulationIdentity lines{
      {"sigma_error", exact(request.sigma_error)},   {"confidence", exact(request.confidence)},
      {"seed", std::to_string(request.seed)},        {"sampler", request.sampler},
      {"from_time", exact(request.from_time)},       {"to_time", exact(request.to_time)},
      {"sections", std::to_string(request.sections)}};
  const auto add = [&](const char* name, const std::vector<std::string>& values) {
    for (const std::string& value : values) lines.emplace_back(name, value);
  };
  add("variables", request.variables);
  add("measures", request.measures);
  add("motions", request.motions);
  add("nominal_variables", request.nominal_variables);
  for (const double value : request.nominal_values) lines.emplace_back("nominal_values", exact(value));
  return lines;
}

SimulationRequest requestFrom(const SimulationIdentity& lines) {
  SimulationRequest request;
  for (const auto& [name, value] : lines) {
    if (name == "sigma_error") {
      request.sigma_error = realNumber(name, value);
    } else if (name == "confidence") {
      request.confidence = realNumber(name, value);
    } else if (name == "seed") {
      request.seed = wholeNumber(name, value);
    } else if (name == "sampler") {
      request.sampler = value;
    } else if (name == "from_time") {
      request.from_time = realNumber(name, value);
    } else if (name == "to_time") {
      request.to_time = realNumber(name, value);
    } else if (name == "sections") {
      request.sections = static_cast<std::uint32_t>(wholeNumber(name, value));
    } else if (name == "variables") {
      request.variables.push_back(value);
    } else if (name == "measures") {
      request.measures.push_back(value);
    } else if (name == "motions") {
      request.motions.push_back(value);
    } else if (name == "nominal_variables") {
      request.nominal_variables.push_back(value);
    } else if (name == "nominal_values") {
      request.nominal_values.push_back(realNumber(name, value));
    } else {
      throw std::invalid_argument("unknown field '" + name + "' of a simulation");
    }
  }
  return request;
}

}  // namespace cable_variation
