#pragma once

#include <array>
#include <limits>
#include <utility>
#include <vector>

#include <Eigen/SparseCore>

#include <cable_variation/rod/profile.h>
#include <hunt/discrete_shape.h>

namespace cable_variation::hunt {

/// What of the rod is changed on the way to its shape.
struct RodModel {
  /// EA, GA are lowered in proportion to EA ≤ cap·EI/h², so that a slender rod can be found as a softer one
  /// first.
  double cap = std::numeric_limits<double>::infinity();
  /// The Hessian's geometric part from DiscreteShape::Piece::force, not from the strain at hand: Newton's
  /// method then needs as few steps for stiff rods as for soft ones (Magisano, Leonetti and Garcea 2017).
  bool given_force = false;
  /// Sliding clips stay where they are on their cable.
  bool hold_slides = false;
};

/// Energy, gradient and Hessian of a harness whose cables are discretised on a staggered grid, positions at
/// vertices and frames at segments (Lang, Linn and Arnold 2011): of second order, and of no kin to the
/// solver's elements. Stations have a frame of their own, half a segment away from the next. All constraints
/// are kept by the choice of unknowns. Dead moments have no energy: they are left out.
class DiscreteRod {
 public:
  DiscreteRod(const Harness& harness, DiscreteLayout layout);

  struct Energy {
    double stretch = 0.0, bending = 0.0, gravity = 0.0, springs = 0.0, loads = 0.0;
    double elastic() const { return stretch + bending; }
    double total() const { return elastic() + gravity + springs + loads; }
  };

  Energy energy(const DiscreteShape& shape, const RodModel& model = {}) const;
  /// Gradient, and the Hessian's lower triangle.
  Energy assemble(const DiscreteShape& shape, const RodModel& model, Eigen::VectorXd& gradient,
                  Eigen::SparseMatrix<double>& hessian) const;
  /// Moves the shape; updates `force` by its first-order prediction.
  void move(const Eigen::VectorXd& step, const RodModel& model, DiscreteShape& shape) const;
  /// Poses of stations from offsets, rotation vectors, hinge angles and parents.
  void place(DiscreteShape& shape) const;

  int unknowns() const { return count_; }
  /// Diagonal of a metric [m]: the share of the cables' length that moves with an unknown; a rotation counts
  /// by the cable's radius.
  const Eigen::VectorXd& surfaceMetric() const { return surface_metric_; }
  /// Stiffness of the scale of bending over a cable's length per unknown, to regularise with.
  const Eigen::VectorXd& bendingMetric() const { return bending_metric_; }
  /// The factor ≤ 1 that brings `step` to at most `turn` [rad] and `shift` of a cable's length, and lets no
  /// sliding clip use up more than half of its room.
  double largestShare(const Eigen::VectorXd& step, const DiscreteShape& shape, double turn,
                      double shift) const;
  /// Largest share of a cable's length or of a radian in a step.
  double size(const Eigen::VectorXd& step) const;
  /// Largest absolute axial strain.
  double largestStretch(const DiscreteShape& shape, double* sign_of = nullptr) const;
  /// The shortest piece beside a sliding clip, as a share of its cable; 1: there is none.
  double smallestRoom(const DiscreteShape& shape) const;

  const Harness& harness() const { return harness_; }
  const DiscreteLayout& layout() const { return layout_; }
  bool slides(std::size_t station) const { return unknown_[station].slide >= 0; }
  /// Whether the station's position, its orientation is given by its clip alone.
  bool positionKnown(std::size_t station) const;
  bool orientationKnown(std::size_t station) const;

 private:
  struct StationUnknowns {
    std::array<int, 3> translation{-1, -1, -1}, rotation{-1, -1, -1};
    bool chart = false;  ///< rotations are components of theta, not increments
    int hinge = -1, slide = -1;
  };
  using Row = std::vector<std::pair<int, double>>;  // how a raw freedom moves with the unknowns
  struct Sink;
  class Assembler;

  void number();
  void measure();
  std::vector<Row> rows(const DiscreteShape& shape, const RodModel& model) const;
  Eigen::Quaterniond turned(const DiscreteShape& shape, std::size_t station,
                            const std::array<std::pair<int, double>, 2>& by) const;
  std::vector<int> turningUnknowns(std::size_t station) const;
  template <class Add>
  void forEachSpring(const DiscreteShape& shape, Add add) const;
  Energy collect(const DiscreteShape& shape, const RodModel& model, Assembler* assembler) const;
  void addChartCurvature(const DiscreteShape& shape, Assembler& assembler) const;
  void predictForces(const std::vector<Row>& rows, const Eigen::VectorXd& step, const RodModel& model,
                     DiscreteShape& shape) const;
  double softened(const RodProperties& rod, std::size_t piece, double share, const RodModel& model) const;

  int rawStation(std::size_t station) const { return static_cast<int>(7 * station); }
  int rawVertex(std::size_t piece, std::size_t k) const;
  int rawSegment(std::size_t piece, std::size_t k) const {
    return first_raw_[piece] + 3 * static_cast<int>(layout_.pieces[piece].segments() - 1 + k);
  }

  Harness harness_;
  DiscreteLayout layout_;
  std::vector<RodProfile> profiles_;
  std::vector<StationUnknowns> unknown_;
  std::vector<int> first_raw_, first_unknown_;
  int raw_count_ = 0, count_ = 0;
  double load_scale_ = 0.0;  ///< weight and loads [N]
  Eigen::VectorXd surface_metric_, bending_metric_, extent_;
};

}  // namespace cable_variation::hunt
