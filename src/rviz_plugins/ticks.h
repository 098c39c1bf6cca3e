#pragma once

#include <QString>
#include <vector>

namespace cable_variation_rviz {

/// A number beside a colour bar.
struct Tick {
  double value;
  QString label;
};

/// Ticks from `minimum` to `maximum`: both bounds to four digits, and between them at most `most` round
/// values (1, 2 or 5 times a power of ten apart) that keep half a step away from the bounds. One tick if the
/// bounds are equal.
std::vector<Tick> ticks(double minimum, double maximum, int most);

}  // namespace cable_variation_rviz
