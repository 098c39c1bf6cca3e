#pragma once

#include <functional>
#include <string>

#include <cable_variation/harness/equilibrium.h>
#include <cable_variation/scene/design.h>

namespace cable_variation_ros {

/// The scene, the design in force and its shape: what the solver's services share.
class SolverContext {
 public:
  /// The harness need not have an equilibrium: equilibrium() tells.
  explicit SolverContext(cable_variation::Scene scene);

  const cable_variation::Design& design() const { return design_; }
  const cable_variation::Harness& harness() const { return harness_; }  ///< in force
  const cable_variation::Equilibrium& equilibrium() const { return equilibrium_; }
  const cable_variation::ComponentPoses& moved() const { return moved_; }

  /// Called whenever the harness or its shape has changed.
  void onChange(std::function<void()> callback) { changed_ = std::move(callback); }

  // Each throws, and leaves all as it was, when the harness is invalid
  // (std::invalid_argument) or has no equilibrium (RequestError).

  /// Another scene, solved from nothing.
  void load(cable_variation::Scene scene);
  /// The scene as loaded, solved from nothing.
  void reset();
  /// An edited design; the shape is followed to it, or solved from nothing if it cannot be.
  void adopt(cable_variation::Design design);

  /// Components have moved: the shape follows. Whether it could, equilibrium() tells.
  void move(const cable_variation::ComponentPoses& moved);

  /// An equilibrium beside the one in force, with its harness.
  struct Trial {
    cable_variation::Harness harness;
    cable_variation::Equilibrium equilibrium;
  };
  /// `follow`: from the shape in force, else from nothing.
  Trial solve(const cable_variation::DesignValues& values, const cable_variation::ComponentPoses& moved,
              bool follow) const;

 private:
  cable_variation::EquilibriumSolver newSolver(const cable_variation::Scene& scene) const;
  void take(cable_variation::EquilibriumSolver solver, cable_variation::Design design,
            cable_variation::Harness harness, cable_variation::Equilibrium equilibrium);
  void notify() const;

  cable_variation::Scene loaded_;  ///< for reset()
  cable_variation::Design design_;
  cable_variation::ComponentPoses moved_;
  cable_variation::Harness harness_;
  cable_variation::EquilibriumSolver solver_;
  cable_variation::Equilibrium equilibrium_;
  std::function<void()> changed_;
};

}  // namespace cable_variation_ros
