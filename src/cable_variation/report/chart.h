#pragma once  // internal to report/

#include <optional>
#include <string>
#include <vector>

namespace cable_variation {

struct Bar {
  std::string label;
  double value = 0.0;  ///< >= 0
  std::string text;    ///< the value as written beside its bar
};

/// Horizontal bars, the longest for the largest value; an SVG element.
std::string barChart(const std::vector<Bar>& bars);

/// A value at the lower limit, the nominal and the upper limit of one variable.
struct LowHighLine {
  std::string label;
  double low = 0.0, high = 0.0;  ///< not a number: no value there
};

/// Lines from low over the common nominal value to high, one per variable, labelled at their higher
/// end; specification limits as dashed lines. An SVG element.
std::string lowHighChart(double nominal, const std::vector<LowHighLine>& lines,
                         const std::optional<double>& lower, const std::optional<double>& upper);

}  // namespace cable_variation
