#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <boost/math/tools/minima.hpp>

namespace cable_variation {

/// The largest value of a quantity along a cable.
struct Extremum {
  double value = 0.0;
  std::size_t piece = 0;
  double t = 0.0;
  bool unique = true;  ///< false: a second local maximum has the same value, to 1e-9 of it
};

/// Finds it for a quantity(piece, t) that is smooth within each of `pieces` pieces: sampled at kSteps + 1
/// places of each, and refined around the highest samples until t is known to `accuracy` (1e-8 at best).
template <std::size_t kSteps = 8, class Quantity>
Extremum largestAlong(std::size_t pieces, const Quantity& quantity, double accuracy = 1e-9) {
  constexpr std::size_t kPerPiece = kSteps + 1;
  std::vector<double> samples(pieces * kPerPiece);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i] = quantity(i / kPerPiece, static_cast<double>(i % kPerPiece) / kSteps);
  }
  // local maxima worth a closer look, the highest first; a sample is off its maximum by a curvature only
  std::vector<std::size_t> peaks;
  const double top = *std::max_element(samples.begin(), samples.end());
  const double bottom = *std::min_element(samples.begin(), samples.end());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (samples[i] < top - 0.05 * (top - bottom)) continue;
    // each piece on its own: next to where two meet, the maximum may be on either side
    const std::size_t step = i % kPerPiece;
    if (step > 0 && samples[i] < samples[i - 1]) continue;
    if (step < kSteps && samples[i] <= samples[i + 1]) continue;
    peaks.push_back(i);
  }
  std::sort(peaks.begin(), peaks.end(),
            [&](std::size_t a, std::size_t b) { return samples[a] > samples[b]; });
  constexpr std::size_t kMost = 8;
  if (peaks.size() > kMost) peaks.resize(kMost);

  const int bits = 1 + static_cast<int>(std::ceil(-std::log2(accuracy)));
  const auto refine = [&](std::size_t index) {
    const std::size_t piece = index / kPerPiece;
    const double middle = static_cast<double>(index % kPerPiece) / kSteps;
    Extremum found{samples[index], piece, middle, true};
    const double low = std::max(0.0, middle - 1.0 / kSteps), high = std::min(1.0, middle + 1.0 / kSteps);
    const auto [t, minus] = boost::math::tools::brent_find_minima(
        [&](double at) { return -quantity(piece, at); }, low, high, bits);
    // a sample is kept unless the refined value is larger by more than rounding
    if (-minus > found.value + 1e-14 * std::abs(found.value)) {
      found.value = -minus;
      found.t = t;
    }
    return found;
  };

  std::vector<Extremum> maxima;
  maxima.reserve(peaks.size());
  for (const std::size_t peak : peaks) maxima.push_back(refine(peak));
  Extremum best = maxima.front();
  for (const Extremum& other : maxima) {
    if (other.value > best.value) best = other;
  }
  const auto along = [](const Extremum& at) { return static_cast<double>(at.piece) + at.t; };
  for (const Extremum& other : maxima) {
    const bool elsewhere = std::abs(along(other) - along(best)) > 0.1;
    if (elsewhere && other.value >= best.value - 1e-9 * std::abs(best.value)) best.unique = false;
  }
  return best;
}

}  // namespace cable_variation
