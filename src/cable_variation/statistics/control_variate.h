#pragma once

#include <cable_variation/statistics/confidence.h>
#include <cable_variation/statistics/joint_moments.h>

namespace cable_variation {

/// The exact mean and standard deviation of what a linear model predicts of a measure: nominal + J mean and
/// √(J Σ Jᵀ), see StabilityAnalysis.
struct LinearMoments {
  double mean = 0.0, sigma = 0.0;
};

/// Mean and standard deviation of a measure by control variates: its linear prediction is sampled too, and
/// its mean and standard deviation are known exactly, so what the samples miss of them corrects the
/// measure's.
struct ControlledEstimate {
  double mean = 0.0, sigma = 0.0;
  ConfidenceInterval mean_interval, sigma_interval;
  /// So many times as many samples would be needed without control.
  double mean_gain = 1.0, sigma_gain = 1.0;
  double correlation = 0.0;  ///< between measure and linear prediction
};

/// From the moments of pairs (measure, linear prediction), of every second sample each. What one half of the
/// samples deviates from the known mean and variance of the prediction corrects its estimate, with the best
/// factor of the other half: so mean and variance are unbiased for independent samples of any distribution,
/// not for large counts only (splitting; Avramidis and Wilson, A splitting scheme for control variates,
/// 1993). The standard deviation is the root of that variance and off by as little as the plain one. The
/// intervals are those of large samples.
/// @param even, odd of at least two samples each @param linear sigma > 0
ControlledEstimate controlled(const JointMoments& even, const JointMoments& odd, const LinearMoments& linear,
                              double confidence);

}  // namespace cable_variation
