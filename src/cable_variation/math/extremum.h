#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
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

/// Finds it for a quantity(piece, t) that is smooth within each of `pieces` pieces: sampled at every second
/// of kSteps + 1 places of each, at all of them in the pieces that come near the largest, and refined around
/// the highest samples until t is known to `accuracy` (1e-8 at best).
template <std::size_t kSteps = 8, class Quantity>
Extremum largestAlong(std::size_t pieces, const Quantity& quantity, double accuracy = 1e-9) {
  static_assert(kSteps % 2 == 0, "every second place includes both ends");
  constexpr std::size_t kPerPiece = kSteps + 1;
  // a sample is off its maximum by a curvature only, those at twice the distance by four times that
  constexpr double kOff = 0.05;
  std::vector<double> samples(pieces * kPerPiece, -std::numeric_limits<double>::infinity());
  double top = -std::numeric_limits<double>::infinity(), bottom = -top;
  const auto sample = [&](std::size_t i) {
    samples[i] = quantity(i / kPerPiece, static_cast<double>(i % kPerPiece) / kSteps);
    top = std::max(top, samples[i]);
    bottom = std::min(bottom, samples[i]);
  };
  for (std::size_t first = 0; first < samples.size(); first += kPerPiece) {
    for (std::size_t step = 0; step <= kSteps; step += 2) sample(first + step);
  }
  const double near = top - 4.0 * kOff * (top - bottom);
  for (std::size_t first = 0; first < samples.size(); first += kPerPiece) {
    const auto piece = samples.begin() + static_cast<std::ptrdiff_t>(first);
    if (*std::max_element(piece, piece + static_cast<std::ptrdiff_t>(kPerPiece)) < near) continue;
    for (std::size_t step = 1; step < kSteps; step += 2) sample(first + step);
  }
  // local maxima worth a closer look, the highest first
  std::vector<std::size_t> peaks;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (samples[i] < top - kOff * (top - bottom)) continue;
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
