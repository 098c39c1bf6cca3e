#include <cable_variation/equilibrium/descent_options.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace cable_variation {
namespace {

template <double DescentOptions::*field>
DescentNumber number(const char* name, double lower, double upper, bool lower_allowed = false,
                     bool upper_allowed = true) {
  return {name,
          lower,
          upper,
          lower_allowed,
          upper_allowed,
          [](const DescentOptions& options) { return options.*field; },
          [](DescentOptions& options, double value) { options.*field = value; }};
}

}  // namespace

const std::vector<DescentNumber>& descentNumbers() {
  static const std::vector<DescentNumber> numbers = {
      number<&DescentOptions::largest_rotation>("largest_rotation", 0.0, 1.0),
      number<&DescentOptions::largest_displacement>("largest_displacement", 0.0, 1.0),
      number<&DescentOptions::first_damping>("first_damping", 0.0, 1e6),
      number<&DescentOptions::damping_growth>("damping_growth", 1.0, 1000.0),
      number<&DescentOptions::smallest_damping>("smallest_damping", 0.0, 1.0),
      {"longest_climb", 0.0, 1000.0, true, true,
       [](const DescentOptions& options) { return static_cast<double>(options.longest_climb); },
       [](DescentOptions& options, double value) {
         options.longest_climb = static_cast<int>(std::lround(value));
       }},
      number<&DescentOptions::reuse_below>("reuse_below", 0.0, 0.1, true),
      number<&DescentOptions::contraction>("contraction", 0.0, 1.0, false, false)};
  return numbers;
}

void validate(const DescentOptions& options) {
  for (const DescentNumber& number : descentNumbers()) {
    const double value = number.get(options);
    const bool high_enough = value > number.lower || (number.lower_allowed && value == number.lower);
    const bool low_enough = value < number.upper || (number.upper_allowed && value == number.upper);
    if (high_enough && low_enough) continue;
    std::ostringstream text;
    text << "descent." << number.name << ": " << value << "; expected "
         << (number.lower_allowed ? "at least " : "more than ") << number.lower << " and "
         << (number.upper_allowed ? "at most " : "less than ") << number.upper;
    throw std::invalid_argument(text.str());
  }
}

}  // namespace cable_variation
