// Motions as the metric and the Hessian see them.

#include <cable_variation/equilibrium/discretisation/rod_system_impl.h>

namespace cable_variation {

using element::kDofs;
using element::kFirstDof;
using element::kNodes;

void RodSystem::carryEnds(NodalField& motion) const {
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    const Vector14d ends = endMotion(i, motion.unknowns);
    motion.spans[i].leftCols<1>() = ends.head<6>();
    motion.spans[i].rightCols<1>() = ends.segment<6>(6);
  }
}

void RodSystem::gatherEnds(std::size_t span, NodalField& force) const {
  auto& nodes = force.spans[span];
  Vector14d ends = Vector14d::Zero();
  ends.head<6>() = nodes.leftCols<1>();
  ends.segment<6>(6) = nodes.rightCols<1>();
  addToUnknowns(span, ends, force.unknowns);
  nodes.leftCols<1>().setZero();
  nodes.rightCols<1>().setZero();
}

double RodSystem::curvatureAlong(const NodalField& motion) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    const Eigen::Vector2d slide = endMotion(i, motion.unknowns).tail<2>();
    for (std::size_t e = 0; e < spans_[i].elements; ++e) {
      const Element at = elementOf(i, e);
      const Batch& batch = batches_[at.batch];
      double x[kDofs];
      for (int a = 0; a < kNodes; ++a) {
        const auto column = static_cast<Eigen::Index>(3 * e) + a;
        for (int k = 0; k < 6; ++k) x[kFirstDof[a] + k] = motion.spans[i](k, column);
      }
      int entry = 0;  // of the lower triangle, row by row
      for (int row = 0; row < kDofs; ++row) {
        for (int column = 0; column < row; ++column) {
          sum += 2.0 * x[row] * x[column] * batch.factor.matrix[entry++][at.lane];
        }
        sum += x[row] * x[row] * batch.factor.matrix[entry++][at.lane];
        for (int side = 0; spans_[i].role.slides && side < 2; ++side) {
          sum += 2.0 * x[row] * slide[side] * batch.slide[side][row][at.lane];
        }
      }
    }
    if (spans_[i].role.slides) sum += slide.dot(spans_[i].slide_second * slide);
  }
  for (const auto& entry : curvature_) {
    sum += entry.value * motion.unknowns[entry.row] * motion.unknowns[entry.column];
  }
  return sum;
}

void RodSystem::applyMetric(const std::vector<Metric>& metric, const NodalField& motion,
                            NodalField& result) const {
  result = zeroField();
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    auto& nodes = result.spans[i];
    for (std::size_t e = 0; e < spans_[i].elements; ++e) {
      const Element at = elementOf(i, e);
      const double length = batches_[at.batch].input.length[at.lane];
      for (int a = 0; a < kNodes; ++a) {
        const auto column = static_cast<Eigen::Index>(3 * e) + a;
        const double share = element::kNodeShare[a] * length;
        nodes.col(column).head<3>() += share * metric[i].position * motion.spans[i].col(column).head<3>();
        nodes(3, column) += share * metric[i].twist * motion.spans[i](3, column);
        nodes.col(column).tail<2>() += share * metric[i].bend * motion.spans[i].col(column).tail<2>();
      }
    }
    gatherEnds(i, result);
    for (std::size_t station : {topology_.spans[i].left, topology_.spans[i].right}) {
      const int slide = unknowns_.slide(station);
      if (slide >= 0) result.unknowns[slide] += metric[i].slide * motion.unknowns[slide];
    }
  }
}

}  // namespace cable_variation
