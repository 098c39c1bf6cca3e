#pragma once

#include <optional>
#include <string>

#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/scene/scene.h>
#include <cable_variation/tracking/shape_follower.h>

namespace cable_variation {

/// The cables jump to another equilibrium while a variable goes from its nominal value to a limit.
struct SnapWithin {
  std::size_t variable = 0;  ///< index into Scene::design_variables
  double deviation = 0.0;    ///< from nominal, where it begins [its unit]
  double jump = 0.0;         ///< how far the cables go, at most [m]
  std::size_t cable = 0;     ///< that goes furthest
  double arc_length = 0.0;   ///< there, in the design [m]
};

/// A design with one variable at a limit of its tolerance.
struct AtLimit {
  Equilibrium equilibrium;  ///< unless it has converged the rest but `message` is empty
  Harness harness;
  ComponentPoses components;
  std::string message;  ///< what to know of it, for a person; empty: nothing
  std::optional<SnapWithin> snap;
};

/// Takes one variable of a design to its limits, the others nominal. The shape is followed closely: a snap is
/// seen however large the tolerance is, and told with where it begins.
class LimitFinder {
 public:
  /// All must outlive the finder. @param harness, equilibrium of the design with `values`
  /// @param solver at that equilibrium
  LimitFinder(const Scene& scene, const DesignValues& values, const ComponentPoses& moved,
              const Harness& harness, const Equilibrium& equilibrium, const EquilibriumSolver& solver);

  /// @param variable index into Scene::design_variables. Throws nothing of the design at the limit: `message`
  AtLimit find(std::size_t variable, bool upper) const;

 private:
  AtLimit leap(const SampleSpace& space, const SamplePlace& place, const std::string& why) const;

  const Scene& scene_;
  const DesignValues& values_;
  const ComponentPoses& moved_;
  const Harness& harness_;
  const Equilibrium& equilibrium_;
  const EquilibriumSolver& solver_;
  std::vector<MaterialStretch> stretches_;
  std::vector<std::string> frames_ = {"world"};
};

/// A deviation for a person: "24.6 deg", "-0.31 mm".
std::string deviationText(const DesignVariable& variable, double deviation);

}  // namespace cable_variation
