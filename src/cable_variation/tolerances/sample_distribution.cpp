#include <cable_variation/tolerances/sample_distribution.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cable_variation {

DiscreteDistribution::DiscreteDistribution(const std::vector<double>& values,
                                           const std::vector<double>& weights) {
  for (std::size_t i = 0; i < values.size(); ++i) values_.push_back({values[i], weights[i], 0.0});
  std::sort(values_.begin(), values_.end(),
            [](const Value& a, const Value& b) { return a.deviation < b.deviation; });
  double sum = 0.0;
  for (Value& value : values_) value.cumulative = sum += value.weight;
}

double DiscreteDistribution::mean() const {
  double sum = 0.0;
  for (const Value& value : values_) sum += value.weight * value.deviation;
  return sum;
}

double DiscreteDistribution::standardDeviation() const {
  const double centre = mean();
  double sum = 0.0;
  for (const Value& value : values_)
    sum += value.weight * (value.deviation - centre) * (value.deviation - centre);
  return std::sqrt(sum);
}

double DiscreteDistribution::cdf(double deviation) const {
  double share = 0.0;
  for (const Value& value : values_) {
    if (value.deviation <= deviation) share = value.cumulative;
  }
  return share;
}

double DiscreteDistribution::quantile(double probability) const {
  for (const Value& value : values_) {
    if (value.weight > 0.0 && value.cumulative >= probability) return value.deviation;
  }
  // the sum of the weights is 1 but for rounding
  return std::find_if(values_.rbegin(), values_.rend(), [](const Value& value) { return value.weight > 0.0; })
      ->deviation;
}

EmpiricalDistribution::EmpiricalDistribution(std::vector<double> samples) : samples_(std::move(samples)) {
  std::sort(samples_.begin(), samples_.end());
}

double EmpiricalDistribution::mean() const {
  return std::accumulate(samples_.begin(), samples_.end(), 0.0) / static_cast<double>(samples_.size());
}

// The variance of the samples, less step²/6n for each linear piece between two of them.
double EmpiricalDistribution::standardDeviation() const {
  const double centre = mean();
  double sum = 0.0;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    sum += (samples_[i] - centre) * (samples_[i] - centre);
    if (i > 0) sum -= (samples_[i] - samples_[i - 1]) * (samples_[i] - samples_[i - 1]) / 6.0;
  }
  return std::sqrt(std::max(0.0, sum) / static_cast<double>(samples_.size()));
}

double EmpiricalDistribution::cdf(double deviation) const {
  const auto above = std::upper_bound(samples_.begin(), samples_.end(), deviation);
  if (above == samples_.begin()) return 0.0;
  if (above == samples_.end()) return 1.0;
  const double low = *(above - 1);
  const auto below = static_cast<double>(above - samples_.begin());
  return (below - 0.5 + (deviation - low) / (*above - low)) / static_cast<double>(samples_.size());
}

double EmpiricalDistribution::quantile(double probability) const {
  const double last = static_cast<double>(samples_.size()) - 1.0;
  const double place = std::clamp(probability * static_cast<double>(samples_.size()) - 0.5, 0.0, last);
  const auto index = static_cast<std::size_t>(std::min(std::floor(place), last - 1.0));
  const double share = place - static_cast<double>(index);
  return (1.0 - share) * samples_[index] + share * samples_[index + 1];
}

}  // namespace cable_variation
