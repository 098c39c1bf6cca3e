#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include <cable_variation/envelope/clearance/envelope_clearance.h>
#include <cable_variation/geometry/tube_distance/distance.h>

namespace cable_variation {

/// Harnesses within the tolerances, each solved once. May be shared by threads.
class SampleShapes {
 public:
  /// Both must outlive the shapes.
  SampleShapes(const Envelope& envelope, const SampleSolver& solver);

  const Envelope& envelope() const { return envelope_; }
  /// Solves samples of the envelope, by their indices, in parallel.
  void prepare(const std::vector<std::size_t>& samples);
  /// That of the envelope's sample.
  std::shared_ptr<const SolvedSample> sample(std::size_t index);
  /// Of any deviations and time, not kept.
  std::shared_ptr<const SolvedSample> fresh(const EnvelopeSample& sample) const {
    return std::make_shared<const SolvedSample>(solver_(sample));
  }
  /// The design at a time of the motion [s], in a phase.
  std::shared_ptr<const SolvedSample> design(std::size_t phase, double time);
  /// The envelope's own sample of the design in a phase.
  std::size_t designSample(std::size_t phase) const { return designs_[phase]; }

 private:
  std::shared_ptr<const SolvedSample> solved(std::map<double, std::shared_ptr<const SolvedSample>>& known,
                                             double key, const EnvelopeSample& sample);

  const Envelope& envelope_;
  const SampleSolver& solver_;
  std::vector<std::size_t> designs_;  // per phase
  std::mutex mutex_;
  std::map<double, std::shared_ptr<const SolvedSample>> samples_, by_time_;
};

/// What is measured of a solved harness; none: nothing to measure.
using ExactDistance = std::function<std::optional<ClosestPair>(const SolvedSample&)>;

struct SampleDistance {
  double time = 0.0;           ///< [s]
  Eigen::VectorXd deviations;  ///< per variable
  std::shared_ptr<const SolvedSample> solved;
  ClosestPair pair;
};

/// Of the envelope's sample; none if it has no equilibrium.
std::optional<SampleDistance> distanceOf(SampleShapes& shapes, std::size_t sample,
                                         const ExactDistance& distance);

/// The closest that the design comes over the motion: looked for at one time of each phase, at five in those
/// where it is closest, and about the best of these in ever smaller steps.
std::optional<SampleDistance> closestDesign(SampleShapes& shapes, const ExactDistance& distance);

}  // namespace cable_variation
