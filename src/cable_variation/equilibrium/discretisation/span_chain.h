#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

namespace cable_variation {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Matrix62d = Eigen::Matrix<double, 6, 2>;
using Matrix14d = Eigen::Matrix<double, 14, 14>;
using Vector14d = Eigen::Matrix<double, 14, 1>;

/// A symmetric 6 × 6 matrix factorised as L D Lᵀ without pivoting, so that the
/// signs of D tell its inertia.
class Ldlt6 {
 public:
  /// Returns the number of pivots that are not positive. Reads the lower triangle.
  int compute(const Matrix6d& matrix);

  template <class Derived>
  void solveInPlace(Eigen::MatrixBase<Derived>& rhs) const {
    for (int k = 0; k < 6; ++k) {
      for (int i = k + 1; i < 6; ++i) rhs.row(i) -= l_(i, k) * rhs.row(k);
    }
    for (int k = 5; k >= 0; --k) {
      rhs.row(k) *= inverse_d_[k];
      for (int i = k + 1; i < 6; ++i) rhs.row(k) -= l_(i, k) * rhs.row(i);
    }
  }

 private:
  Matrix6d l_;
  Vector6d inverse_d_;
};

/// One element of a chain after its inner nodes are eliminated: stiffness
/// between its near and far end nodes, and the coupling to the arc lengths of
/// the span's two stations (columns: left, right).
struct ChainElement {
  Matrix6d near_near, far_near, far_far;
  Matrix62d near_slide, far_slide;
};

/// The elements of a span in a row, reduced to its two ends: a block
/// tridiagonal elimination of the nodes between. The near end is where the
/// elimination starts; when it is held, nothing about it is carried along.
class SpanChain {
 public:
  struct Options {
    bool near_held = false;
    bool slides = false;
  };

  /// Fills in an element, counted from the near end.
  using ElementSource = std::function<void(std::size_t index, ChainElement& element)>;

  /// Returns the number of pivots that are not positive.
  int factorise(std::size_t count, const ElementSource& source, const Options& options);

  /// What is left: order near 6, far 6, arc length of the left and the right
  /// station. The (slide, slide) part is only what the elimination subtracts.
  const Matrix14d& reduced() const { return reduced_; }

  /// Eliminates the inner nodes from a right-hand side: columns are the nodes
  /// from near to far; changed in place. `slide` is added to.
  void condense(Eigen::Matrix<double, 6, Eigen::Dynamic>& rhs, Eigen::Vector2d& slide) const;

  /// Given the first and the last column and the slides, and the inner columns
  /// as left by condense(), the solution in the inner columns.
  void expand(Eigen::Matrix<double, 6, Eigen::Dynamic>& solution, const Eigen::Vector2d& slide) const;

 private:
  struct Node {
    Ldlt6 pivot;
    Matrix6d to_far;   // rows: the next node towards the far end
    Matrix6d to_near;  // rows: the near end
    Matrix62d to_slide;
  };

  Options options_;
  std::vector<Node> nodes_;
  Matrix14d reduced_;
};

}  // namespace cable_variation
