#pragma once  // internal to equilibrium/

// What RodSystem is made of; for its own sources only.

#include <cmath>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

#include <cable_variation/equilibrium/discretisation/rod_system.h>
#include <cable_variation/rod/kernel/chain_kernel.h>

namespace cable_variation {

struct RodSystem::Batch {
  element::Input input;
  element::InputSlope slope;
  element::Energy energy;
  element::Factor factor;
  element::ArcLength arc_length;
  int lanes = 0;                                                 ///< in use
  alignas(64) double slide[2][element::kDofs][element::kLanes];  ///< coupling to the span's two arc lengths
  alignas(64) double scratch[element::kDofs][element::kLanes];   ///< right-hand side, then solution
};

struct RodSystem::SpanData {
  std::size_t first_element = 0;
  std::size_t elements = 0;
  element::ChainRole role;  ///< slides: one of its stations' arc lengths is unknown
  double left_arc_length = 0.0, right_arc_length = 0.0;  ///< [m] that the batches hold
  double bending_stiffness = 0.0;                        ///< smallest EI along the span [N m²]
  double gyration = 0.0;                                 ///< sqrt(EI/EA) [m]
  double radius = 0.0;                                   ///< largest [m]
  double stretch_stiffness = 0.0;                        ///< largest EA [N]
  double stretch_limit = INFINITY;                       ///< of EA and GA [N], see soften()
  element::Front<1> front{};                             ///< of the elimination of the nodes between the ends
  std::vector<element::Link<1>> links;                   ///< one per node between, from the near end
  Matrix14d reduced;                                     ///< left, right, arc lengths of left and right
  Eigen::Vector2d slide_gradient;
  Eigen::Matrix2d slide_second;
  Eigen::Matrix<double, 6, Eigen::Dynamic> nodes;  ///< scratch: chain nodes from near to far

  /// The element that is number j from the near end.
  std::size_t element(std::size_t j) const { return role.reversed ? elements - 1 - j : j; }
  /// The chain's node at a boundary of elements, counted from the left.
  Eigen::Index node(Eigen::Index boundary) const {
    return role.reversed ? static_cast<Eigen::Index>(elements) - boundary : boundary;
  }
  double (*nodeRows(std::size_t node))[1] {
    return reinterpret_cast<double(*)[1]>(nodes.col(static_cast<Eigen::Index>(node)).data());
  }
  void condense(Eigen::Vector2d& slide);
  void expand(const Eigen::Vector2d& slide);

  double length() const { return right_arc_length - left_arc_length; }
};

/// The equations of the stations' unknowns: dense when few, sparse when many; with dead moments unsymmetric.
struct RodSystem::StationSolver {
  static constexpr int kDense = 64;

  Eigen::MatrixXd dense;
  Eigen::LDLT<Eigen::MatrixXd> dense_factor;
  Eigen::PartialPivLU<Eigen::MatrixXd> unsymmetric_factor;
  Eigen::SparseMatrix<double> sparse;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> sparse_factor;
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<Eigen::Triplet<double>> moment_entries;  ///< the skew part of dead moments
  Eigen::VectorXd shift;                               ///< diagonal of the metric of arc lengths
  bool analysed = false;

  int factorise(int count);
  Eigen::VectorXd solve(const Eigen::VectorXd& rhs) const;
};

}  // namespace cable_variation
