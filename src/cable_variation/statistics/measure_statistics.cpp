#include <cable_variation/statistics/measure_statistics.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <cable_variation/math/normal.h>
#include <cable_variation/util/count_text.h>
#include <cable_variation/util/quantity.h>

namespace cable_variation {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kLowShare = 0.00135, kHighShare = 0.99865;  // of ±3σ, as standards round them
constexpr std::array<double, 9> kShares = {kLowShare, 0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99, kHighShare};
constexpr std::size_t kHistogramBins = 48;
constexpr std::uint64_t kFewest = 32;  // samples for intervals that rest on large counts

// The variance of s², over its square: (κ - (n - 3)/(n - 1))/n.
double squareNoise(double kurtosis, double n) {
  return std::max(0.0, (kurtosis - (n - 3.0) / (n - 1.0)) / n);
}

// Of (limit - mean)/3σ, side +1, or (mean - limit)/3σ, side -1, to first order in the errors of mean and σ:
// Bissell's formula (How reliable is your capability index?, 1990) if skewness is 0 and kurtosis 3.
double indexError(double index, double side, double skewness, double kurtosis, double n) {
  const double square =
      1.0 / (9.0 * n) + side * index * skewness / (3.0 * n) + 0.25 * index * index * squareNoise(kurtosis, n);
  return std::sqrt(std::max(0.0, square));
}

double width(const ConfidenceInterval& interval) { return interval.high - interval.low; }

double halfWidth(const ConfidenceInterval& interval, double sigma) {
  return std::max(interval.high - sigma, sigma - interval.low) / sigma;
}

}  // namespace

MeasureStatistics::Estimate MeasureStatistics::bestMean() const {
  if (controlled && width(controlled->mean_interval) < width(mean_interval))
    return {controlled->mean, controlled->mean_interval, true};
  return {mean, mean_interval, false};
}

MeasureStatistics::Estimate MeasureStatistics::bestSigma() const {
  if (controlled && width(controlled->sigma_interval) < width(sigma_interval))
    return {controlled->sigma, controlled->sigma_interval, true};
  return {sigma, sigma_interval, false};
}

std::uint64_t samplesNeeded(const MeasureStatistics& statistics, double error) {
  if (!(error > 0.0 && error < 1.0)) {
    throw std::invalid_argument("relative error of sigma " + shortNumber(error) +
                                "; expected between 0 and 1");
  }
  if (statistics.count < kFewest) return 0;
  if (!(statistics.sigma > 0.0)) return statistics.count;
  double half = halfWidth(statistics.sigma_interval, statistics.sigma);
  if (statistics.controlled) {
    half = std::min(half, halfWidth(statistics.controlled->sigma_interval, statistics.controlled->sigma));
  }
  // intervals are even on a logarithmic scale
  const double ratio = std::log1p(half) / std::log1p(error);
  const double needed = std::ceil(static_cast<double>(statistics.count) * ratio * ratio);
  return std::max(kFewest, static_cast<std::uint64_t>(std::min(needed, 1e18)));
}

void MeasureAccumulator::add(double value, double linear) {
  ++added_;
  if (std::isnan(value)) {
    ++missing_;
    return;
  }
  if (lower_ && value < *lower_) ++below_;
  if (upper_ && value > *upper_) ++above_;
  if (std::isinf(value)) {
    ++infinite_;
    return;
  }
  if (!std::isfinite(linear)) {
    predicted_ = false;
    linear = 0.0;
  }
  (added_ % 2 == 0 ? even_ : odd_).add(value, linear);
  histogram_.add(value);
}

void MeasureAccumulator::merge(const MeasureAccumulator& later) {
  added_ += later.added_;
  below_ += later.below_;
  above_ += later.above_;
  infinite_ += later.infinite_;
  missing_ += later.missing_;
  predicted_ = predicted_ && later.predicted_;
  even_.merge(later.even_);
  odd_.merge(later.odd_);
  histogram_.merge(later.histogram_);
}

RunningFigures MeasureAccumulator::running() const {
  JointMoments moments = even_;
  moments.merge(odd_);
  const auto count = static_cast<double>(moments.count());
  if (moments.count() < 2) return {kNaN, kNaN};
  return {moments.meanX(), std::sqrt(moments.central(2, 0) * count / (count - 1.0))};
}

MeasureStatistics MeasureAccumulator::statistics(double confidence,
                                                 const std::optional<LinearMoments>& linear) const {
  checkConfidence(confidence);
  JointMoments moments = even_;
  moments.merge(odd_);
  MeasureStatistics result;
  result.count = moments.count();
  result.infinite = infinite_;
  result.missing = missing_;
  result.confidence = confidence;
  result.histogram = histogram_.histogram(kHistogramBins);
  result.percentile_error = histogram_.error();
  const std::vector<double> values = histogram_.quantiles({kShares.begin(), kShares.end()});
  for (std::size_t i = 0; i < kShares.size(); ++i) result.percentiles.push_back({kShares[i], values[i]});

  const auto n = static_cast<double>(result.count);
  const bool any = result.count > 0, several = result.count > 1;
  result.mean = any ? moments.meanX() : kNaN;
  result.min = any ? histogram_.min() : kNaN;
  result.max = any ? histogram_.max() : kNaN;
  const double variance = several ? moments.central(2, 0) : kNaN;
  result.sigma = std::sqrt(variance * n / (n - 1.0));
  const bool spread = variance > 0.0;
  result.skewness = spread ? moments.central(3, 0) / std::pow(variance, 1.5) : kNaN;
  result.kurtosis = spread ? moments.central(4, 0) / (variance * variance) : kNaN;
  result.mean_interval = result.sigma_interval = {kNaN, kNaN};
  if (spread) {
    result.mean_interval =
        meanInterval(result.mean, result.sigma / std::sqrt(n), result.count - 1, confidence);
    result.sigma_interval =
        sigmaInterval(result.sigma, 0.5 * std::sqrt(squareNoise(result.kurtosis, n)), confidence);
  } else if (several) {
    result.mean_interval = {result.mean, result.mean};
    result.sigma_interval = {0.0, 0.0};
  }
  if (lower_ || upper_) result.capability = capability(result, moments);

  result.no_control = reasonAgainstControl(linear);
  if (result.no_control.empty()) {
    result.controlled = controlled(even_, odd_, *linear, confidence);
    if (!std::isfinite(result.controlled->sigma_interval.high)) {
      result.controlled.reset();
      result.no_control = "the samples are too few for it";
    }
  }
  return result;
}

Capability MeasureAccumulator::capability(const MeasureStatistics& s, const JointMoments& moments) const {
  Capability result;
  const auto n = static_cast<double>(moments.count());
  const std::uint64_t with_value = added_ - missing_;
  if (with_value > 0) {
    result.below = static_cast<double>(below_) / static_cast<double>(with_value);
    result.above = static_cast<double>(above_) / static_cast<double>(with_value);
    result.outside_interval = shareInterval(below_ + above_, with_value, s.confidence);
  } else {
    result.below = result.above = kNaN;
    result.outside_interval = {kNaN, kNaN};
  }
  result.outside_at_worst =
      added_ > 0 ? static_cast<double>(below_ + above_ + missing_) / static_cast<double>(added_) : kNaN;

  const double q_low = s.percentiles.front().value, q_middle = s.percentiles[kShares.size() / 2].value,
               q_high = s.percentiles.back().value;
  const bool reached = n * kLowShare >= 0.5;
  result.cpk = kNaN;
  result.cpk_interval = {kNaN, kNaN};
  const auto consider = [&](double limit, double side) {
    const double index = side * (limit - s.mean) / (3.0 * s.sigma);
    if (index >= result.cpk) return;  // not so at first, when there is none to compare with
    result.cpk = index;
    const double reach = normalReach(s.confidence) * indexError(index, side, s.skewness, s.kurtosis, n);
    result.cpk_interval = {index - reach, index + reach};
  };
  const auto considerQuantiles = [&](double limit, double side) {
    if (!reached) return;
    const double index =
        side > 0.0 ? (limit - q_middle) / (q_high - q_middle) : (q_middle - limit) / (q_middle - q_low);
    result.cpk_quantile = std::min(index, result.cpk_quantile.value_or(index));
  };
  if (lower_) {
    consider(*lower_, -1.0);
    considerQuantiles(*lower_, -1.0);
    result.below_normal = normalShare((*lower_ - s.mean) / s.sigma);
  }
  if (upper_) {
    consider(*upper_, 1.0);
    considerQuantiles(*upper_, 1.0);
    result.above_normal = normalShare((s.mean - *upper_) / s.sigma);
  }
  if (lower_ && upper_) {
    const double width = *upper_ - *lower_;
    result.cp = width / (6.0 * s.sigma);
    result.cp_interval =
        ConfidenceInterval{width / (6.0 * s.sigma_interval.high), width / (6.0 * s.sigma_interval.low)};
    if (reached) result.cp_quantile = width / (q_high - q_low);
  }
  return result;
}

std::string MeasureAccumulator::reasonAgainstControl(const std::optional<LinearMoments>& linear) const {
  if (!linear) return "there is no linear model";
  if (!predicted_) return "there is no linear prediction of some samples";
  if (!(std::isfinite(linear->mean) && linear->sigma > 0.0)) return "the linear model does not vary";
  if (missing_ + infinite_ > 0) {
    return countText(missing_ + infinite_, "sample has", "samples have") +
           " no value: of the others the linear model's mean is not known";
  }
  if (std::min(even_.count(), odd_.count()) < kFewest / 2) return "the samples are too few for it";
  return "";
}

}  // namespace cable_variation
