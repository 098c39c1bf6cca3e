#pragma once

#include <cstdint>
#include <vector>

namespace cable_variation {

/// Counts in bins of equal width.
struct Histogram {
  double low = 0.0;                   ///< where the first bin begins
  double width = 0.0;                 ///< of each
  std::vector<std::uint64_t> counts;  ///< empty: no values
};

/// Quantiles and histogram of a stream of values in bounded memory: exact up to 4,096 values, then counts in
/// up to 32,768 bins whose width is a power of two and whose edges are multiples of it, made twice as wide
/// as often as the range of the values asks for. Two of them merge without loss, and the result depends on
/// the values alone, not on their order.
class SampleHistogram {
 public:
  void add(double value);  ///< finite
  void merge(const SampleHistogram& other);

  std::uint64_t count() const { return count_; }
  double min() const { return min_; }
  double max() const { return max_; }
  /// No quantile is further from that of the values themselves [their unit]; 0: exact.
  double error() const;

  /// Hazen's rule, as EmpiricalDistribution. Not a number without values.
  /// @param probabilities in [0, 1]
  std::vector<double> quantiles(const std::vector<double>& probabilities) const;

  /// At most `most` >= 2 bins, from the smallest value to the largest; width 0: all values are alike.
  Histogram histogram(std::size_t most) const;

 private:
  bool exact() const { return bins_.empty(); }
  void startBins();
  /// Makes room for values from min_ to max_, bins at least 2^exponent wide.
  void reach(int exponent);
  std::int64_t binOf(double value) const;
  double valueOfRank(std::uint64_t rank) const;

  std::uint64_t count_ = 0;
  double min_ = 0.0, max_ = 0.0;
  std::vector<double> values_;  // while exact
  int exponent_ = 0;            // bins are 2^exponent_ wide
  std::int64_t first_ = 0;      // bins_[0] begins at first_ 2^exponent_
  std::vector<std::uint64_t> bins_;
};

}  // namespace cable_variation
