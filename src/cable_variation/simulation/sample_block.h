#pragma once  // internal to simulation/

#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include <cable_variation/simulation/design_instant.h>
#include <cable_variation/simulation/simulation.h>
#include <cable_variation/tolerances/sampler.h>

namespace cable_variation {

/// What is kept of samples: mergeable, of a size that does not depend on their number.
struct SampleFigures {
  SimulationAccumulator measures;
  std::vector<std::vector<ArcVariation>> arcs;  ///< per instant and cable
  std::vector<std::vector<KeptShape>> shapes;   ///< per instant
  std::vector<std::uint64_t> worst;  ///< per instant: so often was a measure's value the worst there
  std::uint64_t solved_again = 0;
  double discretisation_error = 0.0;  ///< [m]
  std::uint64_t undecided = 0;        ///< equilibria at which a cable may be inside of an open part or not

  void merge(SampleFigures&& later);
};

/// Consecutive samples with all their values.
struct SampleBlock {
  std::uint64_t first = 0;
  Eigen::MatrixXd deviations;  ///< variables by samples
  Eigen::MatrixXd values;      ///< measures by samples
  std::vector<SampleOutcome> outcomes;
  SampleFigures figures;
  bool complete = false;  ///< false: left before its end
};

/// Adds samples of a block, with their outcomes and values, to what its figures have of measures.
/// @param instants of the simulation @param linear room for a number per measure
void addToMeasures(SampleBlock& block, std::size_t at, std::size_t count,
                   const std::vector<std::unique_ptr<const DesignInstant>>& instants,
                   std::vector<double>& linear);

/// Solves blocks of samples. One per thread.
class BlockWorker {
 public:
  using Instants = std::vector<std::unique_ptr<const DesignInstant>>;

  /// All must outlive the worker. @param measures of `scene`, indices @param empty figures of no sample
  /// @param kept_shapes samples before this index leave their shapes
  BlockWorker(const Scene& scene, const std::vector<std::size_t>& measures, const Sampler& sampler,
              const Instants& instants, const SampleFigures& empty, std::uint64_t kept_shapes);

  /// Samples `first` to `first + count`. @param goes_on asked every few samples; false: leave the block
  template <typename GoesOn>
  SampleBlock solve(std::uint64_t first, std::size_t count, const GoesOn& goes_on) {
    SampleBlock block = start(first, count);
    for (std::size_t at = 0; at < count; at += InstantSolver::kSamples) {
      if (!goes_on()) return block;
      solveSome(block, at, std::min(InstantSolver::kSamples, count - at));
    }
    block.complete = true;
    return block;
  }

 private:
  SampleBlock start(std::uint64_t first, std::size_t count) const;
  void solveSome(SampleBlock& block, std::size_t at, std::size_t count);
  void takeWorst(SampleBlock& block, std::size_t sample, std::size_t instant, const SampleSolution& solved);
  void addShapes(SampleBlock& block, std::size_t sample, std::size_t instant,
                 const SampleSolution& solved) const;

  const Scene* scene_;
  const std::vector<std::size_t>* measures_;
  const Sampler* sampler_;
  const BlockWorker::Instants* instants_;
  const SampleFigures* empty_;
  std::uint64_t kept_shapes_;
  std::vector<InstantSolver> workers_;  // per instant
  std::vector<double> linear_;          // per measure
  std::vector<std::vector<std::size_t>>
      at_;  // per sample of some, per measure: the instant of its worst value
};

}  // namespace cable_variation
