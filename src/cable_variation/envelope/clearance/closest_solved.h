#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <cable_variation/envelope/clearance/clearance_samples.h>
#include <cable_variation/tracking/material_stretch.h>

namespace cable_variation {

class ClipOffsets;

/// Of all harnesses that are solved while an envelope is made, the one that comes closest, for each cable and
/// component and for each two cables: measured exactly when it is solved, so that none need be kept.
/// May be told by several threads; what is found does not depend on their order.
class ClosestSolved {
 public:
  /// @param parts those that are not prepared are prepared @param solver has the design's shape to follow
  /// All but the options must outlive it. Throws as clearances().
  ClosestSolved(const Scene& scene, const EnvelopeOptions& options, const ComponentParts& parts,
                const EquilibriumSolver& solver, const ClearanceOptions& clearance_options = {});
  ~ClosestSolved();

  /// Where stretches that do not count against components end, for EnvelopeOptions::cuts: pieces that end
  /// there need not count as a whole.
  const std::vector<MaterialCut>& cuts() const;

  void take(const SamplePlace& place, const Harness& harness, const Equilibrium& equilibrium);
  /// take(), as generateEnvelope() asks for it.
  SolvedWitness witness();

  std::size_t taken() const;  ///< harnesses
  /// The closest to a component (its index), or to another cable; none if nothing was measured.
  std::optional<SampleDistance> toComponent(std::size_t cable, std::size_t component) const;
  std::optional<SampleDistance> toCable(std::size_t cable, std::size_t other) const;
  /// How far the cables' material was from the clips that hold it.
  const ClipOffsets& offsets() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cable_variation
