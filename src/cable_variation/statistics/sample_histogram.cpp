#include <cable_variation/statistics/sample_histogram.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cable_variation {

namespace {

constexpr std::size_t kExact = 4096;
constexpr std::int64_t kBins = 32768;

// The number of bins of width 2^exponent from that of `low` to that of `high`, less one.
double spanOf(double low, double high, int exponent) {
  return std::floor(std::ldexp(high, -exponent)) - std::floor(std::ldexp(low, -exponent));
}

}  // namespace

void SampleHistogram::add(double value) {
  min_ = count_ == 0 ? value : std::min(min_, value);
  max_ = count_ == 0 ? value : std::max(max_, value);
  ++count_;
  if (exact()) {
    values_.push_back(value);
    if (values_.size() > kExact) startBins();
    return;
  }
  reach(exponent_);
  ++bins_[static_cast<std::size_t>(binOf(value) - first_)];
}

void SampleHistogram::merge(const SampleHistogram& other) {
  if (other.count_ == 0) return;
  if (other.exact()) {
    for (const double value : other.values_) add(value);
    return;
  }
  if (exact()) {
    const std::vector<double> own = std::move(values_);
    *this = other;
    for (const double value : own) add(value);
    return;
  }
  min_ = std::min(min_, other.min_);
  max_ = std::max(max_, other.max_);
  count_ += other.count_;
  reach(other.exponent_);
  const int shift = std::min(exponent_ - other.exponent_, 63);
  for (std::size_t i = 0; i < other.bins_.size(); ++i) {
    if (other.bins_[i] == 0) continue;
    const std::int64_t bin = other.first_ + static_cast<std::int64_t>(i);
    bins_[static_cast<std::size_t>((bin >> shift) - first_)] += other.bins_[i];
  }
}

void SampleHistogram::startBins() {
  int exponent = 0;
  std::frexp(std::max(std::abs(min_), std::abs(max_)), &exponent);
  exponent_ = exponent - 52;  // finer bins than a double tells apart are of no use
  bins_.resize(static_cast<std::size_t>(kBins), 0);
  while (spanOf(min_, max_, exponent_) >= kBins) ++exponent_;
  first_ = binOf(min_);
  for (const double value : values_) ++bins_[static_cast<std::size_t>(binOf(value) - first_)];
  std::vector<double>().swap(values_);
}

void SampleHistogram::reach(int exponent) {
  exponent = std::max(exponent, exponent_);
  while (spanOf(min_, max_, exponent) >= kBins) ++exponent;
  if (exponent == exponent_ && binOf(min_) >= first_ && binOf(max_) < first_ + kBins) return;
  const int shift = std::min(exponent - exponent_, 63);  // beyond, all that is left is the sign
  const std::vector<std::uint64_t> before = std::move(bins_);
  const std::int64_t first_before = first_;
  exponent_ = exponent;
  bins_.assign(static_cast<std::size_t>(kBins), 0);
  first_ = binOf(min_) - (kBins - 1 - (binOf(max_) - binOf(min_))) / 2;  // as much room below as above
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (before[i] == 0) continue;
    const std::int64_t bin = (first_before + static_cast<std::int64_t>(i)) >> shift;  // rounds down
    bins_[static_cast<std::size_t>(bin - first_)] += before[i];
  }
}

std::int64_t SampleHistogram::binOf(double value) const {
  return static_cast<std::int64_t>(std::floor(std::ldexp(value, -exponent_)));
}

double SampleHistogram::error() const { return exact() ? 0.0 : std::ldexp(1.0, exponent_); }

// The rank-th smallest value, from 1; the values in a bin spread evenly over it.
double SampleHistogram::valueOfRank(std::uint64_t rank) const {
  std::uint64_t below = 0;
  std::size_t i = 0;
  while (below + bins_[i] < rank) below += bins_[i++];
  const double within = (static_cast<double>(rank - below) - 0.5) / static_cast<double>(bins_[i]);
  const double value =
      std::ldexp(static_cast<double>(first_ + static_cast<std::int64_t>(i)) + within, exponent_);
  return std::clamp(value, min_, max_);
}

std::vector<double> SampleHistogram::quantiles(const std::vector<double>& probabilities) const {
  std::vector<double> result(probabilities.size(), std::numeric_limits<double>::quiet_NaN());
  if (count_ == 0) return result;
  std::vector<double> sorted = values_;
  std::sort(sorted.begin(), sorted.end());
  const auto at = [&](std::uint64_t rank) { return exact() ? sorted[rank - 1] : valueOfRank(rank); };
  const auto n = static_cast<double>(count_);
  for (std::size_t i = 0; i < probabilities.size(); ++i) {
    const double place = std::clamp(probabilities[i] * n + 0.5, 1.0, n);
    const double whole = std::floor(place), rest = place - whole;
    const auto rank = static_cast<std::uint64_t>(whole);
    result[i] = rest > 0.0 ? (1.0 - rest) * at(rank) + rest * at(rank + 1) : at(rank);
  }
  return result;
}

Histogram SampleHistogram::histogram(std::size_t most) const {
  Histogram result;
  if (count_ == 0) return result;
  if (exact()) {
    const double range = max_ - min_;
    result.low = min_;
    // values that are all alike: one bin
    result.width = range > 0.0 ? range / static_cast<double>(most) : 0.0;
    result.counts.assign(range > 0.0 ? most : 1, 0);
    for (const double value : values_) {
      const double place = range > 0.0 ? (value - min_) / result.width : 0.0;
      ++result.counts[std::min(static_cast<std::size_t>(place), result.counts.size() - 1)];
    }
    return result;
  }
  const std::int64_t low = binOf(min_), high = binOf(max_);
  const std::int64_t group = (high - low) / static_cast<std::int64_t>(most) + 1;
  result.low = std::ldexp(static_cast<double>(low), exponent_);
  result.width = std::ldexp(static_cast<double>(group), exponent_);
  result.counts.assign(static_cast<std::size_t>((high - low) / group + 1), 0);
  for (std::int64_t bin = low; bin <= high; ++bin) {
    result.counts[static_cast<std::size_t>((bin - low) / group)] +=
        bins_[static_cast<std::size_t>(bin - first_)];
  }
  return result;
}

}  // namespace cable_variation
