#pragma once  // internal to report/

#include <vector>

namespace cable_variation {

/// A scale of a chart from a round number to a round number, with ticks at steps of 1, 2 or 5 times a power
/// of ten.
struct ChartAxis {
  double low = 0.0, high = 1.0;
  std::vector<double> ticks;  ///< rising, the ends among them

  /// 0 at `low`, 1 at `high`.
  double share(double value) const { return (value - low) / (high - low); }
};

/// An axis that holds low to high, which must be finite, in about `count` steps.
ChartAxis roundAxis(double low, double high, int count);

}  // namespace cable_variation
