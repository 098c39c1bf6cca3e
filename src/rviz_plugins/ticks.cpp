#include <rviz_plugins/ticks.h>

#include <algorithm>
#include <cmath>

#include <cable_variation/math/round_step.h>

namespace cable_variation_rviz {

namespace {

QString roundLabel(double value, double step) {
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  const double size = std::max(std::abs(value), step);
  if (size >= 1e5 || decimals > 4) return QString::number(value, 'g', 4);
  return QString::number(value, 'f', decimals);
}

}  // namespace

std::vector<Tick> ticks(double minimum, double maximum, int most) {
  std::vector<Tick> result{{minimum, QString::number(minimum, 'g', 4)}};
  if (!(maximum > minimum)) return result;
  const double step = cable_variation::roundStep((maximum - minimum) / std::max(most, 1));
  // Counted in whole steps: sums of steps would drift.
  const double first = std::floor(minimum / step), last = std::ceil(maximum / step);
  for (double count = first; count <= last; ++count) {
    const double value = count * step;
    if (value < minimum + 0.5 * step || value > maximum - 0.5 * step) continue;
    result.push_back({value, roundLabel(value, step)});
  }
  result.push_back({maximum, QString::number(maximum, 'g', 4)});
  return result;
}

}  // namespace cable_variation_rviz
