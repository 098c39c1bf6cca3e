#pragma once  // internal to report/

#include <optional>
#include <string>

#include <cable_variation/statistics/sample_histogram.h>

namespace cable_variation {

/// What a histogram is seen against, in its unit.
struct HistogramMarks {
  double nominal = 0.0, mean = 0.0;    ///< lines; not a number: none
  double sigma = 0.0;                  ///< of the normal curve about the mean; 0: none
  std::optional<double> lower, upper;  ///< specification limits: dashed; bins beyond in their colour
};

/// Bars with the normal curve of the same mean and standard deviation; an SVG element.
std::string histogramChart(const Histogram& histogram, const HistogramMarks& marks);

}  // namespace cable_variation
