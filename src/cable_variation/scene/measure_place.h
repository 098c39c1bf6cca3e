#pragma once

namespace cable_variation {

/// Whether a place [m] that a measure names is the end of a cable of that length [m]: it stays there when the
/// length changes.
inline bool isEnd(double arc_length, double length) {
  constexpr double kEnd = 1.0 - 1e-9;  // of the length
  return arc_length >= kEnd * length;
}

}  // namespace cable_variation
