#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <cable_variation/statistics/confidence.h>
#include <cable_variation/statistics/control_variate.h>
#include <cable_variation/statistics/sample_histogram.h>

namespace cable_variation {

/// How a measure's spread fits between its specification limits.
struct Capability {
  std::optional<double> cp;  ///< (upper - lower) / 6σ, with both limits
  double cpk = 0.0;          ///< distance from the mean to the nearer limit, over 3σ
  std::optional<ConfidenceInterval> cp_interval;
  ConfidenceInterval
      cpk_interval;  ///< Bissell's, with the measured skewness and kurtosis instead of a normal one's
  /// The same over the quantiles at 0.135, 50 and 99.865 %, which are those of ±3σ if the measure is normal:
  /// right for any distribution (ISO 22514-2). None below 371 samples, which do not reach these quantiles.
  std::optional<double> cp_quantile, cpk_quantile;
  /// Shares outside, observed: of the samples that have a value.
  double below = 0.0, above = 0.0;
  ConfidenceInterval outside_interval;  ///< of below + above
  /// Of all samples, those without a value counted as outside.
  double outside_at_worst = 0.0;
  /// Shares outside of a normal distribution with this mean and σ.
  double below_normal = 0.0, above_normal = 0.0;
};

struct Percentile {
  double share = 0.0;  ///< in (0, 1)
  double value = 0.0;
};

/// What samples tell of one measure, in its SI unit. Figures that the count does not allow are not numbers.
struct MeasureStatistics {
  std::uint64_t count = 0;     ///< samples with a finite value: what mean and all below are of
  std::uint64_t infinite = 0;  ///< a straight cable's bend radius; against the limits they count
  std::uint64_t missing = 0;   ///< without an equilibrium, or where the measure has no value
  double confidence = 0.95;    ///< of all intervals

  double mean = 0.0, sigma = 0.0;  ///< σ over n - 1
  double skewness = 0.0;           ///< normal: 0
  double kurtosis = 0.0;           ///< normal: 3
  double min = 0.0, max = 0.0;
  ConfidenceInterval mean_interval;
  ConfidenceInterval sigma_interval;  ///< from the measured kurtosis
  std::vector<Percentile> percentiles;
  double percentile_error = 0.0;  ///< at most; 0: exact
  Histogram histogram;
  std::optional<Capability> capability;          ///< with a specification limit
  std::optional<ControlledEstimate> controlled;  ///< see `no_control`
  std::string no_control;                        ///< why `controlled` is not there

  double range() const { return max - min; }

  /// The estimate to show where there is room for one: the controlled one if its interval is the narrower.
  struct Estimate {
    double value;
    ConfidenceInterval interval;
    bool controlled;
  };
  Estimate bestMean() const;
  Estimate bestSigma() const;
};

/// So many samples, in all, make sigma_interval (or the controlled one, if narrower) at most `error` times σ
/// to each side. Half-widths fall with the root of the count.
/// @param error in (0, 1), else std::invalid_argument. 0: not known yet, fewer than 32 samples
std::uint64_t samplesNeeded(const MeasureStatistics& statistics, double error);

/// Of a measure's values so far; σ over n - 1. Not a number: too few.
struct RunningFigures {
  double mean = 0.0, sigma = 0.0;
};

/// Collects the values of one measure: streaming, in bounded memory, mergeable. The same order of calls gives
/// the same numbers bit for bit: of several threads, let each fill one for a fixed block of samples, and
/// merge in the order of the blocks.
class MeasureAccumulator {
 public:
  MeasureAccumulator(const std::optional<double>& lower, const std::optional<double>& upper)
      : lower_(lower), upper_(upper) {}

  /// @param value not a number: missing @param linear what the linear model predicts; not a number: none
  void add(double value, double linear);
  void merge(const MeasureAccumulator& later);

  std::uint64_t count() const { return even_.count() + odd_.count(); }
  RunningFigures running() const;

  /// @param linear moments of the linear predictions added
  /// Throws std::invalid_argument: a confidence outside (0, 1).
  MeasureStatistics statistics(double confidence, const std::optional<LinearMoments>& linear = {}) const;

 private:
  Capability capability(const MeasureStatistics& statistics, const JointMoments& moments) const;
  std::string reasonAgainstControl(const std::optional<LinearMoments>& linear) const;

  std::optional<double> lower_, upper_;
  std::uint64_t added_ = 0, below_ = 0, above_ = 0, infinite_ = 0, missing_ = 0;
  bool predicted_ = true;    // all values so far came with a linear prediction
  JointMoments even_, odd_;  // of value and prediction, in turns
  SampleHistogram histogram_;
};

}  // namespace cable_variation
