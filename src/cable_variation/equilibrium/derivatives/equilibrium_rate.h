#pragma once  // internal to equilibrium/

#include <cable_variation/equilibrium/derivatives/linear_response.h>
#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/rod/profile.h>

namespace cable_variation {

/// What a variable of the harness does to its stations at `configuration`.
HarnessChange changeOf(const Harness& harness, const Topology& topology, const StationUnknowns& unknowns,
                       const Configuration& configuration, const HarnessRate& rate);

/// The largest of what a change and its response do: turns [rad], shifts over `length`, and relative changes.
double sizeOf(const HarnessChange& change, const HarnessResponse& response, double length);

/// Tells how the solved cables change from how the discretised harness does.
class ShapeRates {
 public:
  /// @param shapes of the equilibrium itself. Keeps references.
  ShapeRates(const Harness& harness, const Topology& topology, const std::vector<CableShape>& shapes);

  EquilibriumRate of(const HarnessChange& change, const HarnessResponse& response) const;

 private:
  const Harness& harness_;
  const Topology& topology_;
  const std::vector<CableShape>& shapes_;
  std::vector<std::vector<RodProperties>> properties_;  // per cable and point
};

}  // namespace cable_variation
