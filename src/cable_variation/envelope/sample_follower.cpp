#include <cable_variation/envelope/sample_follower.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include <cable_variation/equilibrium/require_converged.h>

namespace cable_variation {
namespace {

constexpr int kSteps = 4;  // from one phase's reference to the next one's

EnvelopeOptions optionsOf(EnvelopeOptions options, const Envelope& envelope) {
  options.variables = envelope.variables;
  return options;
}

}  // namespace

SampleFollower::SampleFollower(const Scene& scene, const EnvelopeOptions& options, const Envelope& envelope,
                               const EquilibriumSolver& solver)
    : options_(optionsOf(options, envelope)), space_(scene, options_) {
  std::vector<double> references(envelope.phases.size(), std::numeric_limits<double>::quiet_NaN());
  for (const EnvelopeSample& sample : envelope.samples) {
    double& reference = references.at(sample.phase);
    if (std::isnan(reference)) reference = sample.time;  // the first of each phase is the design
  }
  EquilibriumSolver following = solver;
  double before = options_.from;
  phases_.reserve(references.size());
  for (const double reference : references) {
    for (int step = 1; step < kSteps && !phases_.empty(); ++step)
      following.update(space_.harness(space_.designAt(before + (reference - before) * step / kSteps)));
    before = reference;
    const Harness harness = space_.harness(space_.designAt(reference));
    const Equilibrium equilibrium = following.update(harness);
    requireConverged(equilibrium, "the design has no equilibrium");
    if (stretches_.empty()) {
      for (std::size_t cable = 0; cable < harness.cables.size(); ++cable) {
        const CableView view(harness.cables[cable], equilibrium.shapes[cable]);
        const auto own = cutIntoStretches(cable, view, harness.cables[cable].length);
        stretches_.insert(stretches_.end(), own.begin(), own.end());
      }
    }
    phases_.emplace_back(reader_, following, harness, equilibrium, reference);
  }
}

SolvedSample SampleFollower::solve(const EnvelopeSample& sample) const {
  const SamplePlace place{sample.deviations, sample.time};
  FollowedShape followed = phases_.at(sample.phase).follow(place, false);
  if (!followed.converged) followed.equilibrium.status = EquilibriumStatus::not_converged;
  return {std::move(followed.harness), std::move(followed.equilibrium), space_.components(place)};
}

SolvedSample solveSample(const Scene& scene, const EnvelopeOptions& options, const Envelope& envelope,
                         const EnvelopeSample& sample, const EquilibriumSolver& solver) {
  EnvelopeOptions own = options;
  own.variables = envelope.variables;
  const SampleSpace space(scene, own);
  const SamplePlace place{sample.deviations, sample.time};
  EquilibriumSolver following = solver;
  SolvedSample solved{space.harness(place), {}, space.components(place)};
  solved.equilibrium = following.update(solved.harness);
  return solved;
}

}  // namespace cable_variation
