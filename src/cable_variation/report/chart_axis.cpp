#include <cable_variation/report/chart_axis.h>

#include <algorithm>
#include <cmath>

#include <cable_variation/math/round_step.h>

namespace cable_variation {

ChartAxis roundAxis(double low, double high, int count) {
  if (!(high > low)) {  // something must be seen of a line that is level
    const double half = std::max(0.1 * std::abs(low), 1e-12);
    low -= half;
    high += half;
  }
  const double step = roundStep((high - low) / count);
  constexpr double kRounding = 1e-9;  // of a step
  const double first = std::floor(low / step + kRounding), last = std::ceil(high / step - kRounding);
  ChartAxis axis{first * step, last * step, {}};
  for (double k = first; k <= last + 0.5; ++k) axis.ticks.push_back(k * step);
  return axis;
}

}  // namespace cable_variation
