#pragma once  // internal to envelope/

#include <vector>

#include <cable_variation/envelope/envelope.h>
#include <cable_variation/envelope/envelope_generator.h>
#include <cable_variation/tracking/shape_follower.h>

namespace cable_variation {

/// Solves harnesses of an envelope again as the envelope did: the design is followed from phase to phase, and
/// from its shape there, in steps where needed, to the deviations. const: may be shared by threads.
class SampleFollower {
 public:
  /// Scene and envelope must outlive it. @param options as the envelope was made with
  /// @param solver the design's shape to follow
  /// Throws as requireConverged(): no equilibrium of the design.
  SampleFollower(const Scene& scene, const EnvelopeOptions& options, const Envelope& envelope,
                 const EquilibriumSolver& solver);

  SolvedSample solve(const EnvelopeSample& sample) const;

 private:
  EnvelopeOptions options_;
  SampleSpace space_;
  std::vector<std::string> frames_{"world"};
  std::vector<MaterialStretch> stretches_;
  StretchReader reader_{space_, stretches_, frames_};
  std::vector<ShapeFollower> phases_;
};

}  // namespace cable_variation
