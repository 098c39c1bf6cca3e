#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <cable_variation/equilibrium/descent_options.h>
#include <cable_variation/equilibrium/sensitivity.h>
#include <cable_variation/harness/harness.h>
#include <cable_variation/math/curve_piece.h>

namespace cable_variation {

/// One section of a solved cable.
struct ShapePoint {
  double arc_length = 0.0;  ///< undeformed [m]
  Pose pose;                ///< section frame in the world, x the director normal to the section
  Eigen::Vector3d tangent = Eigen::Vector3d::Zero();  ///< ∂φ/∂s, world; its length is the stretch
  Eigen::Vector3d second_derivative = Eigen::Vector3d::Zero();  ///< ∂²φ/∂s², world [1/m]
  Eigen::Vector3d darboux = Eigen::Vector3d::Zero();  ///< Ω, Darboux vector: rate of rotation of the section
                                                      ///< frame along s, in it [1/m]
  Eigen::Vector3d force =
      Eigen::Vector3d::Zero();  ///< section force, of the part s+ on the part s- [N], world
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< section moment, likewise [N m], world
  Eigen::Vector3d strain = Eigen::Vector3d::Zero();  ///< Γ - Γ₀, section frame: stretch, shear y, shear z
  Eigen::Vector3d curvature =
      Eigen::Vector3d::Zero();  ///< Ω - Ω₀, section frame [1/m]: torsion, bending y, bending z
};

/// A solved cable: sections at the solver's own grid, ends included. At a clip
/// or joint two points share the arc length, since force and moment may jump.
struct CableShape {
  std::string cable;
  double radius = 0.0;  ///< largest along the cable [m]
  std::vector<ShapePoint> points;

  /// The centreline at `arc_length` [m, clamped], interpolated to the grid's own accuracy.
  Eigen::Vector3d position(double arc_length) const;
  /// Position and orientation at `arc_length`.
  Pose pose(double arc_length) const;
  /// `count` >= 2 poses at equal steps of arc length, ends included.
  std::vector<Pose> sample(std::size_t count) const;
};

/// The centreline between two neighbouring points of a shape, a before b.
CurvePiece curveBetween(const ShapePoint& a, const ShapePoint& b);

/// What a clip or joint does to the cable it holds.
struct Reaction {
  std::string name;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< on the cable (joint: on the child) [N], world
  Eigen::Vector3d moment =
      Eigen::Vector3d::Zero();  ///< on the cable, about the held section's centre [N m], world
  double arc_length = 0.0;      ///< held now [m]; differs from the clip's when it slides
  Pose section;                 ///< the held section in the world
};

/// A place where a cable touches a part.
struct ContactForce {
  double arc_length = 0.0;    ///< [m]
  Eigen::Vector3d on_part;    ///< on the part's surface [m, world]
  Eigen::Vector3d direction;  ///< unit, from the part to the cable
  double force = 0.0;         ///< that the part presses the cable with, along `direction` [N]
};

/// A stretch of a cable that touches a part all along, or in one place.
struct ContactInterval {
  std::size_t cable = 0;          ///< index into Harness::cables
  std::size_t contact = 0;        ///< index into Harness::contacts
  std::string part;               ///< its name
  double start = 0.0, end = 0.0;  ///< arc lengths of the first and the last place that touches [m]
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< resultant, on the cable [N], world
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< of all forces about the origin [N m], world
  double total = 0.0;                                ///< sum of the forces' amounts [N]
  std::vector<ContactForce> places;                  ///< by arc length: what the resultant is of
};

struct EnergyTerms {
  double elastic = 0.0;  ///< stretch, shear, bending, torsion [J]
  double gravity = 0.0;  ///< -∫ρA g·φ ds [J]
  double springs = 0.0;  ///< of sprung clips [J]
  double loads = 0.0;    ///< minus the work potential of point forces [J]
  double contact = 0.0;  ///< of gaps that are not quite closed or opened; next to nothing at rest [J]
  double total() const { return elastic + gravity + springs + loads + contact; }
};

enum class EquilibriumStatus {
  converged,      ///< a stable equilibrium, to the accuracy asked for
  not_converged,  ///< the iteration ended short of an equilibrium
  unstable,       ///< stationary, but not a minimum
  impossible      ///< the clips are further apart than the cable can reach
};

const char* toString(EquilibriumStatus status);

/// A stable equilibrium that was met but not chosen.
struct Alternative {
  double energy = 0.0;            ///< total [J]
  double largest_distance = 0.0;  ///< between its centrelines and the chosen ones [m]
};

/// The gap where there is nothing to touch [m].
constexpr double kNoGap = std::numeric_limits<double>::infinity();

struct Equilibrium {
  EquilibriumStatus status = EquilibriumStatus::not_converged;
  std::string message;             ///< for a person; names the cable or clip when status is not converged
  std::vector<std::string> notes;  ///< what a person should know of a converged one: twist that was asked for
                                   ///< and became loops; forces that are known less well than asked for
  int iterations = 0;              ///< Newton steps, all starts and grids together
  double residual = 0.0;  ///< largest out-of-balance force [N] (moments over the cable's radius of gyration)
  double discretisation_error = 0.0;  ///< estimate of the centreline's distance from the continuum [m]
  EnergyTerms energy;
  double smallest_eigenvalue = 0.0;       ///< of the constrained Hessian [N/m], see EquilibriumSolver
  double solve_time = 0.0;                ///< [s]
  std::vector<CableShape> shapes;         ///< one per cable, in the harness's order
  std::vector<Reaction> clip_reactions;   ///< one per clip
  std::vector<Reaction> joint_reactions;  ///< one per joint
  std::vector<ContactInterval> contacts;  ///< by cable and arc length; none unless the harness has contact
  double smallest_gap = kNoGap;           ///< of the cables to parts that they have contact with, exact [m]
  std::vector<Alternative> alternatives;  ///< other stable equilibria, by energy

  bool converged() const { return status == EquilibriumStatus::converged; }
};

struct EquilibriumOptions {
  double accuracy = 1e-4;  ///< of every centreline [m], above 0; the grid adapts to it
  /// Of forces and moments at clips, joints and loads, over the largest in their cable, and five times as
  /// many radians of sections' directions; the grid adapts to it. Above 0.
  double force_accuracy = 1e-3;
  bool multi_start = true;  ///< look for the lowest of several stable equilibria when solving from nothing
  bool eigenvalue = true;   ///< compute smallest_eigenvalue (stability itself is always checked)
  /// Of smallest_eigenvalue, relative to itself or to a hundredth of the softest bending stiffness; the grid
  /// adapts to it. Above 0.
  double eigenvalue_accuracy = 1e-3;
  int max_iterations = 400;  ///< Newton steps of a descent, from a start or on a finer grid; at least 1
  DescentOptions descent;
};

/// Throws std::invalid_argument that names the field, its value and the range, of the first that is out of
/// it.
void validate(const EquilibriumOptions& options);

struct Problem;

/// Finds the shape that a harness takes.
///
/// Which one, when several are stable: solve() takes the one of lowest energy
/// among those that a fixed list of starts leads to; with `via` or `twist`
/// hints, the one that the hinted start leads to. update() follows the shape it
/// has. The others met are in Equilibrium::alternatives.
///
/// smallest_eigenvalue: min over admissible motions v of (vᵀHv) / ‖v‖², where
/// ‖v‖ is the root-mean-square motion of the cables' surface. Pushing the cable
/// along its softest shape by a distance a costs ½ λ a². Negative: unstable. Where
/// cables touch parts: among the motions that open no gap which presses; not a number
/// where they touch other than with their ends or across sharp edges: not yet known.
class EquilibriumSolver {
 public:
  explicit EquilibriumSolver(const EquilibriumOptions& options = {});
  ~EquilibriumSolver();
  /// A copy has the shape of the original to follow and goes its own way from there.
  EquilibriumSolver(const EquilibriumSolver& other);
  EquilibriumSolver& operator=(const EquilibriumSolver& other);
  EquilibriumSolver(EquilibriumSolver&&) noexcept;
  EquilibriumSolver& operator=(EquilibriumSolver&&) noexcept;

  /// Of the calls from now on; the shape to follow stays.
  void setOptions(const EquilibriumOptions& options);

  /// From nothing but the harness. Throws std::invalid_argument (validate()).
  Equilibrium solve(const Harness& harness);

  /// From the shape of the last converged call, for a harness that differs from
  /// it in numbers only (poses, lengths, stiffness, loads); else as solve().
  Equilibrium update(const Harness& harness);

  /// From given shapes, one per cable, of another harness of the same cables: the equilibrium that the
  /// harness comes to rest in when it is let go there. A stable one that is reached by going down in energy;
  /// which one, the shapes decide, no other is looked for. Clips and joints first pull what they hold into
  /// place; of a sliding clip, `arc_length` says which section that is. Throws std::invalid_argument for
  /// shapes of other cables, and as solve().
  Equilibrium solveFrom(const Harness& harness, const std::vector<CableShape>& shapes);

  /// How the equilibrium of the last converged call changes with variables of the
  /// harness, to first order: exact derivatives of the discrete equilibrium, by
  /// implicit differentiation with one factorisation for all. Gaps that press stay
  /// closed and others do not count: where a touch begins or ends, only one side's.
  /// Throws std::logic_error when there is no such equilibrium.
  std::vector<EquilibriumRate> differentiate(const std::vector<HarnessRate>& variables);

  /// Derivatives of the smallest eigenvalue, one per variable [N/m per unit], valid
  /// while it is simple. As differentiate(); throws std::invalid_argument where a
  /// cable touches a part: they are not yet known there.
  std::vector<double> eigenvalueRates(const std::vector<HarnessRate>& variables);

 private:
  friend class BatchSolver;
  const Problem& problem() const;  // throws std::logic_error when there is no equilibrium
  const EquilibriumOptions& options() const;
  /// A copy whose shape is brought to a `share` of the errors that the options allow.
  EquilibriumSolver refined(double share) const;

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cable_variation
