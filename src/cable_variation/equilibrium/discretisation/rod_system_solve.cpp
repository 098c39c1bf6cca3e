#include <algorithm>

#include <cable_variation/equilibrium/discretisation/rod_system_impl.h>
#include <cable_variation/math/so3.h>

namespace cable_variation {

using element::kDofs;
using element::kFirstDof;
using element::kInner;
using element::kLanes;
using element::kNodes;

namespace {

int packed(int row, int column) { return row * (row + 1) / 2 + column; }

}  // namespace

int RodSystem::StationSolver::factorise(int count) {
  if (count == 0) return 0;
  if (!moment_entries.empty()) {
    dense.setZero(count, count);
    for (const auto* part : {&entries, &moment_entries}) {
      for (const auto& entry : *part) dense(entry.row(), entry.col()) += entry.value();
    }
    unsymmetric_factor.compute(dense);
    return unsymmetric_factor.determinant() > 0.0 ? 0 : 1;
  }
  if (count <= kDense) {
    dense.setZero(count, count);
    for (const auto& entry : entries) dense(entry.row(), entry.col()) += entry.value();
    dense_factor.compute(dense);
    return static_cast<int>((dense_factor.vectorD().array() <= 0.0).count());
  }
  sparse.resize(count, count);
  sparse.setFromTriplets(entries.begin(), entries.end());
  if (!analysed) sparse_factor.analyzePattern(sparse);
  analysed = true;
  sparse_factor.factorize(sparse);
  if (sparse_factor.info() != Eigen::Success) return count;
  return static_cast<int>((sparse_factor.vectorD().array() <= 0.0).count());
}

Eigen::VectorXd RodSystem::StationSolver::solve(const Eigen::VectorXd& rhs) const {
  if (rhs.size() == 0) return rhs;
  if (!moment_entries.empty()) return unsymmetric_factor.solve(rhs);
  if (rhs.size() <= kDense) return dense_factor.solve(rhs);
  return sparse_factor.solve(rhs);
}

int RodSystem::factorise(double shift, const std::vector<Metric>& metric, bool symmetric) {
  const element::Kernel& kernel = element::kernel();
  for (Batch& batch : batches_) std::fill(&batch.scratch[0][0], &batch.scratch[0][0] + kDofs * kLanes, 0.0);
  if (shift != 0.0) {
    for (std::size_t i = 0; i < spans_.size(); ++i) {
      for (std::size_t e = 0; e < spans_[i].elements; ++e) {
        const Element at = elementOf(i, e);
        Batch& batch = batches_[at.batch];
        for (int a = 0; a < kNodes; ++a) {
          const double share = shift * element::kNodeShare[a] * batch.input.length[at.lane];
          for (int k = 0; k < 3; ++k) batch.scratch[kFirstDof[a] + k][at.lane] = share * metric[i].position;
          batch.scratch[kFirstDof[a] + 3][at.lane] = share * metric[i].twist;
          for (int k = 4; k < 6; ++k) batch.scratch[kFirstDof[a] + k][at.lane] = share * metric[i].bend;
        }
      }
    }
  }
  int negative = 0;
  for (Batch& batch : batches_) {
    int lanes[kLanes];
    kernel.factorise(batch.factor, batch.scratch, lanes);
    for (int lane = 0; lane < batch.lanes; ++lane) negative += lanes[lane];
    if (has_slides_) {
      kernel.condense(batch.factor, batch.slide[0]);
      kernel.condense(batch.factor, batch.slide[1]);
    }
  }
  stations_->shift.setZero(unknowns_.count());
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    reduceSpan(i, negative);
    for (std::size_t station : {topology_.spans[i].left, topology_.spans[i].right}) {
      const int slide = unknowns_.slide(station);
      if (slide >= 0) stations_->shift[slide] += shift * metric[i].slide;
    }
  }
  assembleStations(symmetric);
  const int of_stations = stations_->factorise(unknowns_.count());
  return stations_->moment_entries.empty() ? negative + of_stations : (negative + of_stations) % 2;
}

void RodSystem::assembleStations(bool symmetric) {
  auto& entries = stations_->entries;
  entries.clear();
  struct Column {
    int unknown;
    Vector14d motion;
  };
  std::vector<Column> columns;
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    columns.clear();
    for (int end = 0; end < 2; ++end) {
      const std::size_t station = end == 0 ? topology_.spans[i].left : topology_.spans[i].right;
      for (const UnknownEffect& effect : effects_[station]) {
        Column column{effect.unknown, Vector14d::Zero()};
        column.motion.segment<3>(6 * end) = effect.displacement;
        column.motion.segment<3>(6 * end + 3) = effect.rotation;
        columns.push_back(column);
      }
      const int slide = unknowns_.slide(station);
      if (slide >= 0) columns.push_back({slide, Vector14d::Unit(12 + end)});
    }
    for (const Column& c : columns) {
      const Vector14d force = spans_[i].reduced * c.motion;
      for (const Column& r : columns) entries.emplace_back(r.unknown, c.unknown, r.motion.dot(force));
    }
  }
  for (const auto& entry : curvature_) entries.emplace_back(entry.row, entry.column, entry.value);
  for (int k = 0; k < unknowns_.count(); ++k) entries.emplace_back(k, k, stations_->shift[k]);

  auto& moments = stations_->moment_entries;
  moments.clear();
  if (symmetric || conservative()) return;
  for (std::size_t i = 0; i < effects_.size(); ++i) {
    for (const UnknownEffect& r : effects_[i]) {
      for (const UnknownEffect& c : effects_[i]) {
        // half of -[m]×: the elastic moment, which balances m, supplies the other half
        moments.emplace_back(r.unknown, c.unknown, -0.5 * r.rotation.dot(dead_moment_[i].cross(c.rotation)));
      }
    }
  }
}

Vector14d RodSystem::endMotion(std::size_t span, const Eigen::VectorXd& unknowns) const {
  Vector14d motion = Vector14d::Zero();
  for (int end = 0; end < 2; ++end) {
    const std::size_t station = end == 0 ? topology_.spans[span].left : topology_.spans[span].right;
    for (const UnknownEffect& effect : effects_[station]) {
      motion.segment<3>(6 * end) += unknowns[effect.unknown] * effect.displacement;
      motion.segment<3>(6 * end + 3) += unknowns[effect.unknown] * effect.rotation;
    }
    const int slide = unknowns_.slide(station);
    if (slide >= 0) motion[12 + end] = unknowns[slide];
  }
  return motion;
}

// Of an element with its inner nodes eliminated: the force at one end (0 left, 1 right) by the motion of
// another.
Matrix6d RodSystem::endStiffness(const Element& element, int row_end, int column_end) const {
  Matrix6d block;
  const auto& matrix = batches_[element.batch].factor.matrix;
  for (int c = 0; c < 6; ++c) {
    for (int r = 0; r < 6; ++r) {
      const int row = kInner + 6 * row_end + r, column = kInner + 6 * column_end + c;
      block(r, c) = matrix[row >= column ? packed(row, column) : packed(column, row)][element.lane];
    }
  }
  return block;
}

// The chain knows nothing of a held end: its motion acts as a force on the next node.
void RodSystem::pushByHeldEnd(std::size_t span, const Vector14d& carried) {
  SpanData& data = spans_[span];
  const int near = data.role.reversed ? 1 : 0;
  const Vector6d motion = carried.segment<6>(6 * near);
  if (!data.role.near_held || motion.isZero(0.0)) return;
  const Element first = elementOf(span, data.element(0));
  data.nodes.col(1) -= endStiffness(first, 1 - near, near) * motion;
}

// condense() of no force.
void RodSystem::condenseForceless(const std::vector<Vector14d>& carried, std::vector<Vector14d>& reduced) {
  for (Batch& batch : batches_) std::fill(&batch.scratch[0][0], &batch.scratch[0][0] + kDofs * kLanes, 0.0);
  reduced.assign(spans_.size(), Vector14d::Zero());
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    SpanData& data = spans_[i];
    data.nodes.setZero();
    pushByHeldEnd(i, carried[i]);
    if (data.nodes.isZero(0.0)) continue;
    Eigen::Vector2d slide = Eigen::Vector2d::Zero();
    data.condense(slide);
    reduced[i] << data.nodes.col(data.node(0)), data.nodes.col(data.node(data.nodes.cols() - 1)), slide;
  }
}

void RodSystem::condense(const NodalField& force, const std::vector<Vector14d>& carried,
                         std::vector<Vector14d>& reduced) {
  const element::Kernel& kernel = element::kernel();
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    for (std::size_t e = 0; e < spans_[i].elements; ++e) {
      const Element at = elementOf(i, e);
      auto& rhs = batches_[at.batch].scratch;
      const auto inner = static_cast<Eigen::Index>(3 * e + 1);
      for (int k = 0; k < 6; ++k) {
        rhs[k][at.lane] = force.spans[i](k, inner);
        rhs[6 + k][at.lane] = force.spans[i](k, inner + 1);
        rhs[kInner + k][at.lane] = rhs[kInner + 6 + k][at.lane] = 0.0;
      }
    }
  }
  for (Batch& batch : batches_) kernel.condense(batch.factor, batch.scratch);
  reduced.resize(spans_.size());
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    SpanData& data = spans_[i];
    const auto count = static_cast<Eigen::Index>(data.elements);
    Eigen::Vector2d slide = Eigen::Vector2d::Zero();
    for (Eigen::Index k = 0; k <= count; ++k) {
      const bool end = k == 0 || k == count;
      data.nodes.col(data.node(k)) = end ? Vector6d(Vector6d::Zero()) : Vector6d(force.spans[i].col(3 * k));
    }
    for (std::size_t e = 0; e < data.elements; ++e) {
      const Element at = elementOf(i, e);
      const Batch& batch = batches_[at.batch];
      const auto left = static_cast<Eigen::Index>(e);
      for (int k = 0; k < 6; ++k) {
        data.nodes(k, data.node(left)) += batch.scratch[kInner + k][at.lane];
        data.nodes(k, data.node(left + 1)) += batch.scratch[kInner + 6 + k][at.lane];
      }
      if (!data.role.slides) continue;
      for (int k = 0; k < kInner; ++k) {
        const double y = batch.factor.inverse_pivot[k][at.lane] * batch.scratch[k][at.lane];
        slide -= y * Eigen::Vector2d(batch.slide[0][k][at.lane], batch.slide[1][k][at.lane]);
      }
    }
    if (!carried.empty()) pushByHeldEnd(i, carried[i]);
    data.condense(slide);
    reduced[i].head<6>() = data.nodes.col(data.node(0));
    reduced[i].segment<6>(6) = data.nodes.col(data.node(count));
    reduced[i].tail<2>() = slide;
  }
}

void RodSystem::expand(const std::vector<Vector14d>& ends, NodalField& motion) {
  const element::Kernel& kernel = element::kernel();
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    SpanData& data = spans_[i];
    const auto count = static_cast<Eigen::Index>(data.elements);
    const Eigen::Vector2d slide = ends[i].tail<2>();
    data.nodes.col(data.node(0)) = ends[i].head<6>();
    data.nodes.col(data.node(count)) = ends[i].segment<6>(6);
    data.expand(slide);
    for (std::size_t e = 0; e < data.elements; ++e) {
      const Element at = elementOf(i, e);
      Batch& batch = batches_[at.batch];
      const auto left = static_cast<Eigen::Index>(e);
      for (int k = 0; k < 6; ++k) {
        batch.scratch[kInner + k][at.lane] = data.nodes(k, data.node(left));
        batch.scratch[kInner + 6 + k][at.lane] = data.nodes(k, data.node(left + 1));
      }
      if (!data.role.slides) continue;
      for (int k = 0; k < kInner; ++k) {
        batch.scratch[k][at.lane] -=
            batch.slide[0][k][at.lane] * slide[0] + batch.slide[1][k][at.lane] * slide[1];
      }
    }
  }
  for (Batch& batch : batches_) kernel.expand(batch.factor, batch.scratch);
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    const SpanData& data = spans_[i];
    const auto count = static_cast<Eigen::Index>(data.elements);
    for (std::size_t e = 0; e < data.elements; ++e) {
      const Element at = elementOf(i, e);
      const auto& x = batches_[at.batch].scratch;
      const auto first = static_cast<Eigen::Index>(3 * e);
      for (int k = 0; k < 6; ++k) {
        motion.spans[i](k, first) = x[kInner + k][at.lane];
        motion.spans[i](k, first + 1) = x[k][at.lane];
        motion.spans[i](k, first + 2) = x[6 + k][at.lane];
      }
    }
    motion.spans[i].col(3 * count) = ends[i].segment<6>(6);
  }
}

void RodSystem::solve(const NodalField& force, NodalField& motion) {
  motion = force;
  std::vector<Vector14d> ends;
  condense(motion, {}, ends);
  for (std::size_t i = 0; i < spans_.size(); ++i) addToUnknowns(i, ends[i], motion.unknowns);
  motion.unknowns = stations_->solve(motion.unknowns);
  for (std::size_t i = 0; i < spans_.size(); ++i) ends[i] = endMotion(i, motion.unknowns);
  expand(ends, motion);
}

Vector6d RodSystem::endForceAfter(const NodalField& motion, std::size_t span, int end) const {
  const std::size_t e = end == 0 ? 0 : spans_[span].elements - 1;
  const Element at = elementOf(span, e);
  const Batch& batch = batches_[at.batch];
  alignas(64) double force[kDofs][kLanes] = {};  // of the inner nodes, which carry it to the ends
  for (int k = 0; k < kInner; ++k) force[k][at.lane] = -batch.energy.gradient[k][at.lane];
  element::kernel().condense(batch.factor, force);
  const auto left = static_cast<Eigen::Index>(3 * e);
  Vector6d after = endForce(span, end) + endStiffness(at, end, 0) * motion.spans[span].col(left) +
                   endStiffness(at, end, 1) * motion.spans[span].col(left + 3);
  for (int k = 0; k < 6; ++k) after[k] -= force[kInner + 6 * end + k][at.lane];
  for (int side = 0; side < 2; ++side) {
    const int slide = unknowns_.slide(side == 0 ? topology_.spans[span].left : topology_.spans[span].right);
    if (slide < 0) continue;
    for (int k = 0; k < 6; ++k)
      after[k] += batch.slide[side][kInner + 6 * end + k][at.lane] * motion.unknowns[slide];
  }
  return after;
}

void RodSystem::follow(const Eigen::Matrix<double, 6, Eigen::Dynamic>& carried, NodalField& motion) {
  motion = zeroField();
  solveCarried(carried, motion, true);
}

void RodSystem::solveCarried(const Eigen::Matrix<double, 6, Eigen::Dynamic>& carried, NodalField& motion,
                             bool forceless) {
  std::vector<Vector14d> given(spans_.size(), Vector14d::Zero());
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    given[i].head<6>() = carried.col(static_cast<Eigen::Index>(topology_.spans[i].left));
    given[i].segment<6>(6) = carried.col(static_cast<Eigen::Index>(topology_.spans[i].right));
  }
  std::vector<Vector14d> ends;
  if (forceless) {
    condenseForceless(given, ends);
  } else {
    condense(motion, given, ends);
  }
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    addToUnknowns(i, ends[i] - spans_[i].reduced * given[i], motion.unknowns);
  }
  motion.unknowns = stations_->solve(motion.unknowns);
  for (std::size_t i = 0; i < spans_.size(); ++i) ends[i] = given[i] + endMotion(i, motion.unknowns);
  expand(ends, motion);
}

}  // namespace cable_variation
