#include <cable_variation/equilibrium/discretisation/span_chain.h>

namespace cable_variation {

int Ldlt6::compute(const Matrix6d& matrix) {
  l_ = matrix;
  int negative = 0;
  for (int k = 0; k < 6; ++k) {
    const double pivot = l_(k, k);
    if (!(pivot > 0.0)) ++negative;
    inverse_d_[k] = 1.0 / pivot;
    for (int i = k + 1; i < 6; ++i) {
      const double factor = l_(i, k) * inverse_d_[k];
      for (int j = i; j < 6; ++j) l_(j, i) -= factor * l_(j, k);
    }
    for (int i = k + 1; i < 6; ++i) l_(i, k) *= inverse_d_[k];
  }
  return negative;
}

int SpanChain::factorise(std::size_t count, const ElementSource& source, const Options& options) {
  options_ = options;
  ChainElement next;
  source(0, next);
  nodes_.resize(count - 1);
  int negative = 0;

  Matrix6d near_near = next.near_near;
  Matrix6d diagonal = next.far_far;     // of the node at hand
  Matrix6d to_near = next.far_near;     // node at hand × near end
  Matrix62d to_slide = next.far_slide;  // node at hand × slides
  Matrix62d near_slide = next.near_slide;
  Eigen::Matrix2d slide_slide = Eigen::Matrix2d::Zero();

  for (std::size_t i = 1; i < count; ++i) {
    source(i, next);
    Node& node = nodes_[i - 1];
    negative += node.pivot.compute(diagonal + next.near_near);
    node.to_far = next.far_near;
    diagonal = next.far_far;
    Matrix6d y = next.far_near.transpose();
    node.pivot.solveInPlace(y);
    diagonal.noalias() -= next.far_near * y;
    if (!options.near_held) {
      node.to_near = to_near.transpose();
      near_near.noalias() -= node.to_near * [&] {
        Matrix6d z = to_near;
        node.pivot.solveInPlace(z);
        return z;
      }();
      to_near = -(y.transpose() * to_near).eval();
    }
    if (options.slides) {
      node.to_slide = to_slide + next.near_slide;
      Matrix62d z = node.to_slide;
      node.pivot.solveInPlace(z);
      slide_slide.noalias() -= node.to_slide.transpose() * z;
      if (!options.near_held) near_slide.noalias() -= node.to_near * z;
      to_slide = next.far_slide - next.far_near * z;
    }
  }
  reduced_.setZero();
  reduced_.block<6, 6>(0, 0) = near_near;
  reduced_.block<6, 6>(6, 6) = diagonal;
  if (!options.near_held) {
    reduced_.block<6, 6>(6, 0) = to_near;
    reduced_.block<6, 6>(0, 6) = to_near.transpose();
  }
  if (options.slides) {
    reduced_.block<6, 2>(0, 12) = near_slide;
    reduced_.block<6, 2>(6, 12) = to_slide;
    reduced_.block<2, 6>(12, 0) = near_slide.transpose();
    reduced_.block<2, 6>(12, 6) = to_slide.transpose();
    reduced_.block<2, 2>(12, 12) = slide_slide;
  }
  return negative;
}

void SpanChain::condense(Eigen::Matrix<double, 6, Eigen::Dynamic>& rhs, Eigen::Vector2d& slide) const {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Node& node = nodes_[i];
    const auto column = static_cast<Eigen::Index>(i) + 1;
    Vector6d y = rhs.col(column);
    node.pivot.solveInPlace(y);
    rhs.col(column + 1).noalias() -= node.to_far * y;
    if (!options_.near_held) rhs.col(0).noalias() -= node.to_near * y;
    if (options_.slides) slide.noalias() -= node.to_slide.transpose() * y;
  }
}

void SpanChain::expand(Eigen::Matrix<double, 6, Eigen::Dynamic>& solution,
                       const Eigen::Vector2d& slide) const {
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    const Node& node = nodes_[i];
    const auto column = static_cast<Eigen::Index>(i) + 1;
    Vector6d y = solution.col(column) - node.to_far.transpose() * solution.col(column + 1);
    if (!options_.near_held) y.noalias() -= node.to_near.transpose() * solution.col(0);
    if (options_.slides) y.noalias() -= node.to_slide * slide;
    node.pivot.solveInPlace(y);
    solution.col(column) = y;
  }
}

}  // namespace cable_variation
