#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/equilibrium/sensitivity.h>
#include <cable_variation/geometry/tube_distance/distance.h>
#include <cable_variation/measures/component_parts.h>
#include <cable_variation/scene/design_rate.h>
#include <cable_variation/scene/scene.h>

namespace cable_variation {

/// A measure's value, and where it was found.
struct MeasureValue {
  double value = 0.0;       ///< in the measure's SI unit
  std::string note;         ///< what a person must know of it: pierced, not unique; empty: nothing
  bool undecided = false;   ///< distance: it is not known whether a cable is inside of an open part
  bool unique = true;       ///< false: another place has the same value, the derivative is one-sided
  bool has_place = false;   ///< the following are given
  std::size_t cable = 0;    ///< index
  double arc_length = 0.0;  ///< on that cable [m]
  Eigen::Vector3d point =
      Eigen::Vector3d::Zero();  ///< there: distance and similarity: on the cable's surface [m, world]
  bool has_other = false;
  Eigen::Vector3d other = Eigen::Vector3d::Zero();  ///< distance: the closest point of the part or other
                                                    ///< cable; similarity: of the nominal shape [m, world]

  /// Where exactly: what derivatives and later searches start from.
  struct Trace {
    Centreline::Place place;        ///< on `cable`, among the pieces between points of its shape
    std::size_t other_cable = 0;    ///< distance between cables: the other's index
    Centreline::Place other_place;  ///< on it; similarity: on the nominal shape
    bool from_nominal = false;      ///< similarity: the place furthest away is that of the nominal shape
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();  ///< distance, similarity: along which the value
                                                          ///< grows when the cable at the place moves
    std::size_t component = 0;  ///< distance to a component: that one, of a robot the link that is closest
    std::vector<std::optional<ClosestPair>> pairs;  ///< distance to a component: per body, and of each per
                                                    ///< cable looked at
  } trace;
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
  /// @param scene must outlive the evaluator @param nominal the shape that similarity compares with
  MeasureEvaluator(const Scene& scene, const SolvedScene& nominal);
  ~MeasureEvaluator();
  MeasureEvaluator(MeasureEvaluator&&) noexcept;
  MeasureEvaluator& operator=(MeasureEvaluator&&) noexcept;

  /// The same scene's, or an edited one's with the same components, with another nominal shape. Quick: the
  /// parts' geometry is shared, not prepared again.
  MeasureEvaluator with(const Scene& scene, const SolvedScene& nominal) const;

  /// Makes ready for many shapes near the nominal one: the distances of those that are nowhere further from
  /// it than `departure` [m], seen from the component, are found faster with `near`. Changes nothing else.
  /// @param values of `measures` at `nominal`, the shape that similarity compares with
  void expectNear(const SolvedScene& nominal, const std::vector<std::size_t>& measures,
                  const std::vector<MeasureValue>& values, double departure);

  /// The components that measures look at.
  const ComponentParts& parts() const;

  /// The values of `measures` (indices into Scene::measures). `near`: values of the same measures at a
  /// similar shape, which make the search faster and change nothing else.
  /// Both throw std::invalid_argument: an index out of range, a component without a pose or a mesh.
  std::vector<MeasureValue> evaluate(const SolvedScene& at, const std::vector<std::size_t>& measures,
                                     const std::vector<MeasureValue>* near = nullptr) const;

  /// Derivatives of the measures by the design variables (rows: measures, columns: `design`), in SI units. Of
  /// a similarity at the nominal shape itself: the one-sided limit, max over s of |(I - t tᵀ) ∂φ/∂x|, with
  /// the whole vector at the ends of cables; not of an eigenvalue (its row is left 0, see
  /// EquilibriumSolver::eigenvalueRates).
  Eigen::MatrixXd jacobian(const SolvedScene& at, const std::vector<std::size_t>& measures,
                           const std::vector<MeasureValue>& values, const std::vector<DesignRate>& design,
                           const std::vector<EquilibriumRate>& rates) const;

 private:
  struct Impl;
  explicit MeasureEvaluator(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace cable_variation
