#pragma once  // internal to envelope/

#include <cstdint>
#include <functional>
#include <vector>

#include <cable_variation/envelope/envelope_generator.h>
#include <cable_variation/envelope/envelope_verification.h>
#include <cable_variation/tolerances/sampler.h>

namespace cable_variation {

constexpr int kMostLooks = 4;

/// What an envelope of a share of production is made and verified with.
struct StatisticalPlan {
  double probability = 0.0;      ///< share of production, in (0, 1)
  std::size_t learnt = 0;        ///< shapes whose most usual ones span the hulls
  std::size_t added = 0;         ///< others, of which those that stick out are taken in but for the furthest
  std::size_t calibration = 0;   ///< others that the inflation is chosen by
  std::size_t verification = 0;  ///< others yet that it is verified with, at each of kMostLooks looks

  std::uint64_t samples() const;  ///< all together, at most
};

/// @param verification 0: as many as it takes to tell a share that is well above the probability from it
/// @param stretches of the cables: more take more memory per shape
/// Throws std::invalid_argument: probability not in (0, 1); so few shapes that even none outside would not
/// show it, or more than kMostSamples.
StatisticalPlan planFor(double probability, std::size_t verification, std::size_t stretches);

struct StatisticalResult {
  double inflation = 0.0;            ///< [m]
  Containment containment;           ///< of the last look
  ProductionDraws draws;             ///< likewise
  std::vector<RandomShape> snapped;  ///< of the last look
  int looks = 0;                     ///< at fresh shapes
  bool shown = false;                ///< that at least the probability is held, with 95 % confidence
};

/// Fills the hulls of a phase with the whole shapes of a share of production, by split conformal prediction
/// (Vovk, Gammerman and Shafer, Algorithmic learning in a random world, 2005):
///
/// 1. Shapes are drawn from the variables' joint distribution and ordered by the largest Mahalanobis distance
///    of any end of a stretch from its mean, across the cable; the usual ones go into the hulls. Then others
///    that stick out, but for those that stick out most. As many stay out as may be outside in the end, lest
///    the hulls alone hold far more than is asked for.
/// 2. Of other shapes it is known how far they stick out of the hulls. The inflation is such that so few
///    stick out of it that verification is likely to succeed: an order statistic.
/// 3. Yet others are held against the inflated hulls. The share outside has an upper bound by Clopper and
///    Pearson; unless it is at most 1 - probability, the shapes join those of step 2, and fresh ones are
///    looked at. The k-th look has the error probability 0.04 / 5^(k-1): less than 0.05 together, however
///    many there are.
///
/// Whether the hulls are well chosen decides how tight the envelope is, not whether the share is true. Shapes
/// without an equilibrium count as outside.
///
/// @param searches of one phase, with nothing in it but its reference
/// @param sampler of plan.samples() at least
/// @param witness told of verified shapes that are held
/// @param progress told how many of all shapes are done, by any thread; may throw
/// Throws NotConverged: more of the harnesses have no equilibrium than may be outside.
StatisticalResult holdShareOfProduction(std::vector<PhaseSearch>& searches, const Sampler& sampler,
                                        const StatisticalPlan& plan, const SolvedWitness& witness,
                                        const std::function<void(double share, std::size_t done)>& progress);

/// Draws the harnesses of production that an envelope is made of.
/// @param options variables, seed @param count samples() of its plan
Sampler productionSampler(const Scene& scene, const EnvelopeOptions& options, std::uint64_t count);

/// Sample of production, by its number.
SamplePlace productionPlace(const Sampler& sampler, std::uint64_t index, double time);

}  // namespace cable_variation
