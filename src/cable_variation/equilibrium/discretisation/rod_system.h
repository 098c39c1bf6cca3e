#pragma once  // internal to equilibrium/

#include <array>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include <cable_variation/equilibrium/discretisation/configuration.h>
#include <cable_variation/equilibrium/discretisation/end_motion.h>
#include <cable_variation/equilibrium/discretisation/station_unknowns.h>
#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/rod/kernel/element_kernel.h>
#include <cable_variation/rod/profile.h>

namespace cable_variation {

/// A motion of a configuration to first order, or a force against it: the
/// stations' unknowns, and per span its nodes (columns; displacement in the
/// world above rotation vector in the section frame).
struct NodalField {
  Eigen::VectorXd unknowns;
  std::vector<Eigen::Matrix<double, 6, Eigen::Dynamic>> spans;

  double dot(const NodalField& other) const;
  void addScaled(double factor, const NodalField& other);
  void scale(double factor);
};

class ContactSystem;

/// The discretised harness: energy, its gradient, and its Hessian, factorised in
/// time linear in the number of elements. Inner nodes of an element, then those
/// of a span, then the stations are eliminated; L D Lᵀ without pivoting gives
/// the inertia along the way.
class RodSystem {
 public:
  /// Keeps references to harness and topology.
  RodSystem(const Harness& harness, const Topology& topology, const Grid& grid);
  /// To be called when the harness has changed in numbers (see sameStructure()).
  void harnessChanged();
  ~RodSystem();

  const Harness& harness() const { return harness_; }
  const Topology& topology() const { return topology_; }
  const Grid& grid() const { return grid_; }
  const StationUnknowns& unknowns() const { return unknowns_; }
  std::size_t elementCount(std::size_t span) const { return grid_[span].size() - 1; }

  /// What evaluate() computes beside energy and gradient: no Hessian, the Hessian (to be factorised), or the
  /// Hessian with the geometric part of predictStress() or relaxStress().
  enum class Hessian { none, exact, predicted };
  void evaluate(const Configuration& configuration, Hessian hessian);

  /// Before a move: the section forces and moments after it, to first order.
  void predictStress(const NodalField& motion);
  /// No section forces and moments.
  void relaxStress();
  /// Those at the configuration evaluated last, to be kept while the configuration or the stiffness changes.
  void holdStress();
  /// Those that `other`, the same harness on another grid, holds.
  void takeStress(const RodSystem& other);

  /// Stretch and shear no stiffer than leaves each span a slenderness EA ℓ²/EI of `slenderness`, unless it
  /// is not far from that, the loads would stretch it noticeably then, or its clips hold it taut at
  /// `configuration`. Infinite: as the cables are. Returns whether this makes any span softer than its cable
  /// is.
  bool soften(double slenderness, const Configuration& configuration);

  /// Whether an arc length is unknown.
  bool slides() const { return has_slides_; }

  /// The gaps to parts, evaluated with the system; null unless the harness has contact.
  ContactSystem* contact() { return contact_.get(); }
  const ContactSystem* contact() const { return contact_.get(); }
  /// The forces of contact that are known on another grid of the same harness.
  void takeContacts(const RodSystem& from);
  /// What presses on another grid, where it does and as stiff: ContactSystem::freeze().
  void freezeContacts(const RodSystem& from);

  const EnergyTerms& energy() const { return energy_; }
  const NodalField& gradient() const { return gradient_; }
  /// Largest out-of-balance force: forces, moments over the section's radius of
  /// gyration, and configurational forces [N].
  double residual() const;
  /// What a span's moments are measured over in a residual [m].
  double gyration(std::size_t span) const;
  /// The smallest EI along a span [N m²].
  double bendingStiffness(std::size_t span) const;
  /// The span with the largest out-of-balance force at its inner nodes.
  std::size_t worstSpan() const;
  /// The size of the forces that must cancel in it, with rounding: a residual below this is noise.
  double residualNoise() const;
  /// The shift in the metric of bending that is as large as the rounding of the Hessian.
  double stiffnessNoise() const;
  /// Whether a span is so slender that small errors of its shape, or a small turn, change its stiffness.
  bool slender() const;
  /// Whether the factors stay valid for solve() after an evaluation without Hessian, and steps with them come
  /// closer to rest.
  bool keepsFactors() const { return !has_slides_ && !slender(); }

  /// A diagonal metric of motions.
  struct Metric {
    double position = 0.0;  ///< weight of |δφ|² per undeformed length
    double twist = 0.0;     ///< of the rotation about the tangent
    double bend = 0.0;      ///< of the rotations about the other axes
    double slide = 0.0;     ///< of a slid length
  };
  /// One metric per span: what makes a shift of 1 as stiff as the span's first bending mode.
  std::vector<Metric> bendingMetric() const;
  /// The mean square motion of the cables' surface.
  std::vector<Metric> surfaceMetric() const;

  /// Factorises Hessian + shift × metric, after evaluate() with a Hessian; once per evaluation. Returns the
  /// number of pivots that are not positive: none for a minimum.
  ///
  /// A dead moment on a section that turns about more than one axis has no potential, its stiffness has a
  /// skew part. It is taken into account among the stations' unknowns unless only the symmetric part is asked
  /// for. Then not the pivots are counted but whether the determinant is negative (1) or not (0): along a
  /// growing load it changes its sign where the equilibrium diverges.
  int factorise(double shift, const std::vector<Metric>& metric, bool symmetric = false);

  /// Solves with the factorised matrix. Held stations do not move.
  void solve(const NodalField& force, NodalField& motion);
  /// The first-order motion of everything when stations are carried along by
  /// `carried` (6 × stations), other forces being absent.
  void follow(const Eigen::Matrix<double, 6, Eigen::Dynamic>& carried, NodalField& motion);

  /// Whether all loads of `harness`, of the same structure as the system's, have a potential: no dead moment
  /// on a section that turns about more than one axis.
  bool conservative(const Harness& harness) const;
  bool conservative() const { return conservative(harness_); }

  /// Sets a motion's columns at the spans' ends to what its unknowns do there, after evaluate().
  void carryEnds(NodalField& motion) const;
  /// Turns the force on a span's ends into one on the unknowns, after evaluate().
  void gatherEnds(std::size_t span, NodalField& force) const;
  /// Hessian, on both sides multiplied by a motion; after evaluate() with the exact Hessian, before
  /// factorise().
  double curvatureAlong(const NodalField& motion) const;

  /// Metric times motion.
  void applyMetric(const std::vector<Metric>& metric, const NodalField& motion, NodalField& result) const;
  NodalField zeroField() const;

  /// Whether no slide has carried a station past, or nearly onto, its neighbour.
  bool arcLengthsInOrder(const Configuration& configuration) const;

  /// Moves `configuration`. Returns the work of dead moments along the way [J].
  double move(const NodalField& motion, Configuration& configuration) const;

  /// Derivative of the elastic and gravity energy by the motion of a span's
  /// left (0) or right (1) end: what the station does to the span there.
  Vector6d endForce(std::size_t span, int end) const {
    return end_force_[span][static_cast<std::size_t>(end)];
  }

  /// Elastic and gravity energy of one element [J].
  double elementEnergy(std::size_t span, std::size_t element) const;

  /// Force in the world and moment in the section frame that the part s- of a
  /// span needs at an element boundary `node` (0 to elementCount): from the element on its left, or the
  /// first.
  Vector6d sectionForce(std::size_t span, std::size_t boundary) const;

  /// After solve(): endForce() once its motion is made, to first order.
  Vector6d endForceAfter(const NodalField& motion, std::size_t span, int end) const;

 private:
  friend class LinearResponse;

  struct Element {
    std::size_t batch;
    int lane;
  };
  struct SpanData;
  struct Batch;
  struct StationSolver;

  Element elementOf(std::size_t span, std::size_t element) const;
  void refreshProperties(const Configuration& configuration);
  double loadScale() const;
  void gather(const Configuration& configuration);
  void addContact(const Configuration& configuration, bool hessian);
  void assembleGradient(const Configuration& configuration);
  double residual(std::size_t span) const;  // at its inner nodes
  void assembleStations(bool symmetric);
  void assembleArcLength();
  void reduceSpan(std::size_t span, int& negative);
  /// `carried`: motion of the spans' ends that is given, not solved for.
  void condense(const NodalField& force, const std::vector<Vector14d>& carried,
                std::vector<Vector14d>& reduced);
  void condenseForceless(const std::vector<Vector14d>& carried, std::vector<Vector14d>& reduced);
  void pushByHeldEnd(std::size_t span, const Vector14d& carried);
  Matrix6d endStiffness(const Element& element, int row_end, int column_end) const;
  void expand(const std::vector<Vector14d>& ends, NodalField& motion);
  /// From the force in `motion` to the motion, stations being carried along. `forceless`: the force on the
  /// spans' nodes is known to be zero.
  void solveCarried(const Eigen::Matrix<double, 6, Eigen::Dynamic>& carried, NodalField& motion,
                    bool forceless);
  Vector14d endMotion(std::size_t span, const Eigen::VectorXd& unknowns) const;
  void addToUnknowns(std::size_t span, const Vector14d& force, Eigen::VectorXd& unknowns) const;

  const Harness& harness_;
  const Topology& topology_;
  Grid grid_;
  StationUnknowns unknowns_;
  std::vector<RodProfile> profiles_;
  std::vector<SpanData> spans_;
  std::vector<Batch> batches_;
  std::vector<std::vector<UnknownEffect>> effects_;
  std::vector<StationUnknowns::Curvature> curvature_;
  std::vector<Eigen::Vector3d> dead_moment_;  // per station, in the section frame
  std::vector<std::array<Vector6d, 2>> end_force_;
  std::unique_ptr<StationSolver> stations_;
  std::unique_ptr<ContactSystem> contact_;
  EnergyTerms energy_;
  NodalField gradient_;
  double reach_ = 0.0;  // largest distance of a clip from the origin, rounding grows with it [m]
  bool has_slides_ = false;
};

}  // namespace cable_variation
