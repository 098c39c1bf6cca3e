#pragma once

#include <memory>
#include <string>
#include <vector>

#include <cable_variation/harness/equilibrium.h>
#include <cable_variation/harness/sensitivity.h>
#include <cable_variation/scene/design_rate.h>
#include <cable_variation/scene/scene.h>

namespace cable_variation {

/// A measure's value, and where it was found.
struct MeasureValue {
  double value = 0.0;       ///< in the measure's SI unit
  std::string note;         ///< what a person must know of it: pierced, not unique; empty: nothing
  bool unique = true;       ///< false: another place has the same value, the derivative is one-sided
  bool has_place = false;   ///< the following are given
  std::size_t cable = 0;    ///< index
  double arc_length = 0.0;  ///< on that cable [m]
  Eigen::Vector3d point =
      Eigen::Vector3d::Zero();  ///< there: distance and similarity: on the cable's surface [m, world]
  bool has_other = false;
  Eigen::Vector3d other = Eigen::Vector3d::Zero();  ///< distance: the closest point of the part or other
                                                    ///< cable; similarity: of the nominal shape [m, world]
};

/// A harness at rest with all that a measure may look at.
struct SolvedScene {
  const Harness& harness;
  const Equilibrium& equilibrium;
  const ComponentPoses& components;  ///< of all components, world (componentPosesAt())
};

/// Evaluates measures of one scene. Keeps what is costly to prepare (the parts'
/// geometry, the nominal shape); const members may be called by several threads.
class MeasureEvaluator {
 public:
  /// @param nominal the shape that similarity compares with
  MeasureEvaluator(const Scene& scene, const SolvedScene& nominal);
  ~MeasureEvaluator();
  MeasureEvaluator(MeasureEvaluator&&) noexcept;
  MeasureEvaluator& operator=(MeasureEvaluator&&) noexcept;

  /// The same scene's, or an edited one's with the same components, with another nominal shape. Quick: the
  /// parts' geometry is shared, not prepared again.
  MeasureEvaluator with(const Scene& scene, const SolvedScene& nominal) const;

  /// The values of `measures` (indices into Scene::measures). `near`: values of the same measures at a
  /// similar shape, which make the search faster and change nothing else.
  std::vector<MeasureValue> evaluate(const SolvedScene& at, const std::vector<std::size_t>& measures) const;

  /// Derivatives of the measures by the design variables (rows: measures, columns: `design`), in SI units. Of
  /// a similarity at the nominal shape itself: the one-sided limit, max over s of |(I - t tᵀ) ∂φ/∂x|, with
  /// the whole vector at the ends of cables; not of an eigenvalue (its row is left 0, see
  /// EquilibriumSolver::eigenvalueRates).
  Eigen::MatrixXd jacobian(const SolvedScene& at, const std::vector<std::size_t>& measures,
                           const std::vector<MeasureValue>& values, const std::vector<DesignRate>& design,
                           const std::vector<EquilibriumRate>& rates) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cable_variation
