#include <cable_variation/scene_file/distribution_reader.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <stdexcept>

#include <cable_variation/scene/resource_address.h>
#include <cable_variation/util/data_lines.h>

namespace cable_variation {
namespace {

constexpr double kUsualSigma = 3.0;
constexpr Range kShare{0.0, 1.0, false};
constexpr Range kWeibullShape{0.5, 50.0, false};     // beyond, the mean or the width lose their meaning
constexpr Range kSkewShape{-1000.0, 1000.0, false};  // half a normal distribution beyond

struct Reading {
  const YamlCursor& cursor;
  const Quantity& quantity;
  DesignVariable& variable;
  const ReadContext& context;

  void parameter(const char* key, const Range& range) const {
    variable.distribution_parameters[key] = cursor.number(key, quantity::number, range);
  }
  void parameter(const char* key, const Range& range, double fallback) const {
    variable.distribution_parameters[key] = cursor.number(key, quantity::number, range, fallback);
  }
  Range tolerance() const { return {variable.lower, variable.upper, false}; }
};

void readDiscrete(const Reading& r) {
  constexpr double kSumTolerance = 1e-6;
  const auto values = r.cursor.require("values");
  if (!values) return;
  for (const YamlCursor& item : values->items()) {
    r.variable.distribution_values.push_back(item.number(r.quantity, r.tolerance()));
  }
  const std::size_t count = r.variable.distribution_values.size();
  if (values->isList() && count == 0) values->fail("the list is empty; expected a value at least");
  std::vector<double>& weights = r.variable.distribution_weights;
  const auto probabilities = r.cursor.find("probabilities");
  if (!probabilities) {
    weights.assign(count, count > 0 ? 1.0 / static_cast<double>(count) : 0.0);
    return;
  }
  for (const YamlCursor& item : probabilities->items(count)) {
    weights.push_back(item.number(quantity::number, kShare));
  }
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  if (std::abs(sum - 1.0) > kSumTolerance && !weights.empty()) {
    probabilities->fail("their sum is " + shortNumber(sum) + "; expected 1");
  }
}

// What never varies is no variable.
void requireSpread(const Reading& r) {
  const auto& values = r.variable.distribution_values;
  const auto& weights = r.variable.distribution_weights;
  std::set<double> possible;
  for (std::size_t i = 0; i < std::min(values.size(), weights.size()); ++i) {
    if (weights[i] > 0.0) possible.insert(values[i]);
  }
  if (possible.size() == 1) r.cursor.fail("all of it is at one value; expected two at least");
}

void readEmpirical(const Reading& r) {
  const auto address = r.cursor.require("file");
  std::string unit;
  if (const auto given = r.cursor.find("unit")) {
    unit = given->text();
    try {
      parseQuantity("1 " + unit, r.quantity);
    } catch (const std::invalid_argument& error) {
      given->fail(error.what());
      return;
    }
  }
  if (!address) return;
  const std::string text = address->text();
  if (text.empty()) return;
  try {
    const InputLimits& limits = r.context.limits;
    const std::string path = localPath(text, r.context.find_package, limits.samples_bytes, limits.folders);
    std::vector<double>& samples = r.variable.distribution_values;
    readDataLines(path, limits.samples_bytes, [&](const std::string& line) {
      const std::size_t first = line.find_first_not_of(" \t\r");
      const std::string value = line.substr(first, line.find_last_not_of(" \t\r") + 1 - first);
      samples.push_back(parseQuantity(unit.empty() ? value : value + " " + unit, r.quantity));
      if (samples.size() > limits.samples) {
        throw std::invalid_argument("the file has more samples; " + atMost(limits.samples, "samples"));
      }
    });
    if (samples.size() < 2) {
      throw std::invalid_argument("'" + text + "' holds " + std::to_string(samples.size()) +
                                  " samples; expected 2 or more");
    }
    if (std::all_of(samples.begin(), samples.end(), [&](double v) { return v == samples.front(); })) {
      throw std::invalid_argument("'" + text + "' holds the same sample over and over; expected others too");
    }
  } catch (const std::invalid_argument& error) {
    address->fail(error.what());
  }
}

struct DistributionType {
  std::string name;
  std::vector<std::string> keys;
  void (*read)(const Reading&);
};

const std::vector<DistributionType>& distributionTypes() {
  static const auto sigma = [](const Reading& r) { r.parameter("sigma", kSigmaRange, kUsualSigma); };
  static const std::vector<DistributionType> types{
      {"normal", {"sigma"}, sigma},
      {"truncated_normal", {"sigma"}, sigma},
      {"uniform", {}, [](const Reading&) {}},
      {"triangular",
       {"mode"},
       [](const Reading& r) {
         r.variable.distribution_parameters["mode"] = r.cursor.number("mode", r.quantity, r.tolerance(), 0.0);
       }},
      {"trapezoidal", {"plateau"}, [](const Reading& r) { r.parameter("plateau", kShare, 0.5); }},
      {"beta",
       {"alpha", "beta"},
       [](const Reading& r) {
         r.parameter("alpha", Range::positive());
         r.parameter("beta", Range::positive());
       }},
      {"weibull",
       {"shape", "scale"},
       [](const Reading& r) {
         r.parameter("shape", kWeibullShape);
         if (const auto scale = r.cursor.find("scale")) {
           r.variable.distribution_parameters["scale"] = scale->number(r.quantity, Range::positive());
         }
       }},
      {"skew_normal",
       {"shape", "sigma"},
       [](const Reading& r) {
         r.parameter("shape", kSkewShape);
         sigma(r);
       }},
      {"discrete",
       {"values", "probabilities"},
       [](const Reading& r) {
         const std::size_t before = r.cursor.faults().count();
         readDiscrete(r);
         if (r.cursor.faults().count() == before) requireSpread(r);
       }},
      {"empirical", {"file", "unit"}, readEmpirical},
  };
  return types;
}

}  // namespace

void readDistribution(const YamlCursor& cursor, const Quantity& quantity, DesignVariable& variable,
                      const ReadContext& context) {
  if (!cursor.isMap()) {
    cursor.fail("expected a map such as {type: normal, sigma: 3}");
    return;
  }
  const auto type = cursor.require("type");
  if (!type) return;
  std::vector<std::string> names;
  for (const DistributionType& known : distributionTypes()) names.push_back(known.name);
  const std::size_t before = context.faults.count();
  const DistributionType& found = distributionTypes()[type->choice(names)];
  if (context.faults.count() > before) return;
  std::vector<std::string> keys = found.keys;
  keys.insert(keys.begin(), "type");
  cursor.checkKeys(keys);
  variable.distribution = found.name;
  variable.distribution_parameters.clear();
  found.read({cursor, quantity, variable, context});
}

}  // namespace cable_variation
