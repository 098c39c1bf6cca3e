#include <algorithm>
#include <cmath>

#include <cable_variation/equilibrium/discretisation/lane_system_impl.h>

namespace cable_variation {

using element::kDofs;
using element::kFirstDof;
using element::kInner;
using element::kNodeDofs;
using element::kNodes;

namespace {

int packed(int row, int column) { return row * (row + 1) / 2 + column; }
int packedOf(int row, int column) { return row >= column ? packed(row, column) : packed(column, row); }

Vector6d column(const NodeRows& rows, int lane) {
  Vector6d values;
  for (int k = 0; k < kNodeDofs; ++k) values[k] = rows.of[k][lane];
  return values;
}

void put(const Vector6d& values, int lane, NodeRows& rows) {
  for (int k = 0; k < kNodeDofs; ++k) rows.of[k][lane] = values[k];
}

}  // namespace

// An element's inner nodes.
void LaneSystem::factorise(const SpanLanes& span, Element& at) {
  alignas(64) double shift[kDofs][kLanes];
  for (int a = 0; a < kNodes; ++a) {
    for (int lane = 0; lane < kLanes; ++lane) {
      const double share = kNeutralShift * element::kNodeShare[a] * at.input.length[lane];
      for (int k = 0; k < 3; ++k) shift[kFirstDof[a] + k][lane] = share * span.metric.position;
      shift[kFirstDof[a] + 3][lane] = share * span.metric.twist;
      for (int k = 4; k < 6; ++k) shift[kFirstDof[a] + k][lane] = share * span.metric.bend;
    }
  }
  int negative[kLanes];
  element::kernel().factorise(at.factor, shift, negative);
  for (std::size_t lane = 0; lane < kLanes; ++lane) negative_[lane] += negative[lane];
}

void LaneSystem::factoriseChain(SpanLanes& span) {
  const element::Elimination<kLanes>& elimination = element::chainKernel().lanes;
  elimination.start(elements_[span.element(0)].factor, 0, nullptr, span.role, span.front);
  for (std::size_t j = 1; j < span.count; ++j) {
    elimination.eliminate(elements_[span.element(j)].factor, 0, nullptr, span.role, span.front,
                          span.links[j - 1], negative_.data());
  }
}

// The gradient in the stations' unknowns, and with `hessian` their equations.
void LaneSystem::evaluateStations(int index, bool hessian) {
  Lane& lane = *lanes_[static_cast<std::size_t>(index)];
  if (lane.unknowns.count() == 0) return;
  const Topology& topology = problem_.topology;
  lane.effects = lane.unknowns.effects(lane.configuration);
  std::vector<Vector6d> force(topology.stations.size(), Vector6d::Zero());
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    force[topology.spans[i].left] += endForce(i, 0, index);
    force[topology.spans[i].right] += endForce(i, 1, index);
  }
  lane.gradient.setZero();
  for (std::size_t i = 0; i < force.size(); ++i) {
    for (std::size_t load : topology.stations[i].loads) {
      const PointLoad& of = lane.harness.loads[load];
      force[i].head<3>() -= of.force;
      force[i].tail<3>() -= lane.configuration.stations[i].pose.orientation.conjugate() * of.moment;
    }
    for (const UnknownEffect& effect : lane.effects[i]) {
      lane.gradient[effect.unknown] +=
          force[i].head<3>().dot(effect.displacement) + force[i].tail<3>().dot(effect.rotation);
    }
  }
  lane.curvature.clear();
  lane.unknowns.addSprings(lane.configuration, lane.gradient, &lane.curvature);
  double& residual = residual_[static_cast<std::size_t>(index)];
  for (std::size_t i = 0; i < force.size(); ++i) {
    const double gyration = spans_[topology.cable_spans[topology.stations[i].cable].front()].gyration[0];
    for (const UnknownEffect& effect : lane.effects[i]) {
      const double of = std::abs(lane.gradient[effect.unknown]);
      residual = std::max(residual, effect.displacement.isZero(0.0) ? of / gyration : of);
    }
  }
  if (!hessian) return;
  std::vector<Eigen::Vector3d> moment;
  moment.reserve(force.size());
  for (const Vector6d& of : force) moment.emplace_back(of.tail<3>());
  lane.unknowns.addCurvature(lane.configuration, lane.effects, std::move(moment), lane.curvature);
  factoriseStations(index);
}

void LaneSystem::factoriseStations(int index) {
  Lane& lane = *lanes_[static_cast<std::size_t>(index)];
  lane.matrix.setZero(lane.unknowns.count(), lane.unknowns.count());
  struct Column {
    int unknown;
    Eigen::Matrix<double, 12, 1> motion, force;
  };
  std::vector<Column> columns;
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    if (spans_[i].far_held) continue;
    const Eigen::Matrix<double, 12, 12> stiffness = reduced(i, index);
    columns.clear();
    for (int end = 0; end < 2; ++end) {
      const Span& span = problem_.topology.spans[i];
      for (const UnknownEffect& effect : lane.effects[end == 0 ? span.left : span.right]) {
        Column& column = columns.emplace_back();
        column.unknown = effect.unknown;
        column.motion.setZero();
        column.motion.segment<3>(6 * end) = effect.displacement;
        column.motion.segment<3>(6 * end + 3) = effect.rotation;
        column.force.noalias() =
            stiffness.middleCols<6>(6 * end).lazyProduct(column.motion.segment<6>(6 * end));
      }
    }
    for (const Column& c : columns) {
      for (const Column& r : columns) lane.matrix(r.unknown, c.unknown) += r.motion.dot(c.force);
    }
  }
  for (const auto& entry : lane.curvature) lane.matrix(entry.row, entry.column) += entry.value;
  lane.factor.compute(lane.matrix);
  negative_[static_cast<std::size_t>(index)] +=
      static_cast<int>((lane.factor.vectorD().array() <= 0.0).count());
}

// What a span's ends, left and right, feel of each other, all between eliminated; nothing of a held near end.
Eigen::Matrix<double, 12, 12> LaneSystem::reduced(std::size_t index, int lane) const {
  const SpanLanes& span = spans_[index];
  const auto left = [&](int row, int column) {
    return span.front.matrix[span.front.at(std::max(row, column), std::min(row, column))][lane];
  };
  Eigen::Matrix<double, 12, 12> matrix = Eigen::Matrix<double, 12, 12>::Zero();
  const int far = span.role.reversed ? 0 : 6, near = 6 - far;
  for (int r = 0; r < kNodeDofs; ++r) {
    for (int c = 0; c < kNodeDofs; ++c) {
      matrix(far + r, far + c) = left(element::kFarRow + r, element::kFarRow + c);
      if (span.role.near_held) continue;
      matrix(near + r, near + c) = left(element::kBorderRow + r, element::kBorderRow + c);
      matrix(near + r, far + c) = matrix(far + c, near + r) =
          left(element::kBorderRow + r, element::kFarRow + c);
    }
  }
  return matrix;
}

// Forces, from the elements' inner nodes to their ends, by the factors of `by`.
void LaneSystem::condenseElements(const LaneSystem& by) {
  const element::Kernel& kernel = element::kernel();
  for (SpanLanes& span : spans_) {
    for (std::size_t j = 0; j < span.count; ++j) {
      Element& at = elements_[span.element(j)];
      kernel.condense(by.elements_[span.element(j)].factor, at.rows);
      for (int end = 0; end < 2; ++end) {
        NodeRows& node = span.endOf(j, end);
        for (int k = 0; k < kNodeDofs; ++k) {
          for (int lane = 0; lane < kLanes; ++lane) {
            node.of[k][lane] += at.rows[kInner + kNodeDofs * end + k][lane];
          }
        }
      }
    }
  }
}

// Forces, from the elements' ends to those of the spans.
void LaneSystem::condenseChains(const LaneSystem& by) {
  const element::Elimination<kLanes>& elimination = element::chainKernel().lanes;
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    SpanLanes& span = spans_[i];
    const int border = span.role.border();
    for (std::size_t j = 1; j < span.count; ++j) {
      elimination.condense(by.spans_[i].links[j - 1], border, span.node(j).of, span.node(j + 1).of,
                           span.near.of);
    }
  }
}

// The chain knows nothing of a held end: its motion acts as a force on the next node.
void LaneSystem::pushByHeldEnds(const LaneSystem& by) {
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    SpanLanes& span = spans_[i];
    if (!span.role.near_held) continue;
    const auto& matrix = by.elements_[span.element(0)].factor.matrix;
    const int near = kInner + (span.role.reversed ? kNodeDofs : 0);
    const int far = kInner + (span.role.reversed ? 0 : kNodeDofs);
    const auto station = static_cast<Eigen::Index>(span.role.reversed ? problem_.topology.spans[i].right
                                                                      : problem_.topology.spans[i].left);
    NodeRows carried;
    for (int lane = 0; lane < kLanes; ++lane) {
      put(lanes_[static_cast<std::size_t>(lane)]->carried.col(station), lane, carried);
    }
    for (int r = 0; r < kNodeDofs; ++r) {
      for (int c = 0; c < kNodeDofs; ++c) {
        const double* entry = matrix[packedOf(far + r, near + c)];
        for (int lane = 0; lane < kLanes; ++lane) {
          span.node(1).of[r][lane] -= entry[lane] * carried.of[c][lane];
        }
      }
    }
  }
}

// From the condensed forces on the spans' ends to the ends' motion.
void LaneSystem::solveStations(const LaneSystem& by, bool carried) {
  const Topology& topology = problem_.topology;
  for (int index = 0; index < kLanes; ++index) {
    Lane& lane = *lanes_[static_cast<std::size_t>(index)];
    const auto carriedBy = [&](std::size_t station) -> Vector6d {
      if (!carried) return Vector6d::Zero();
      return lane.carried.col(static_cast<Eigen::Index>(station));
    };
    if (lane.unknowns.count() > 0) {
      // of the ends' own force, the gradient tells; what is condensed comes on top
      Eigen::VectorXd rhs = -lane.gradient;
      for (std::size_t i = 0; i < spans_.size(); ++i) {
        if (spans_[i].far_held) continue;
        const Span& span = topology.spans[i];
        Eigen::Matrix<double, 12, 1> force;
        force << column(spans_[i].left(), index) + endForce(i, 0, index),
            column(spans_[i].right(), index) + endForce(i, 1, index);
        if (carried) {
          Eigen::Matrix<double, 12, 1> given;
          given << carriedBy(span.left), carriedBy(span.right);
          force -= by.reduced(i, index) * given;
        }
        for (int end = 0; end < 2; ++end) {
          for (const UnknownEffect& effect : lane.effects[end == 0 ? span.left : span.right]) {
            rhs[effect.unknown] += force.segment<3>(6 * end).dot(effect.displacement) +
                                   force.segment<3>(6 * end + 3).dot(effect.rotation);
          }
        }
      }
      lane.step = by.lanes_[static_cast<std::size_t>(index)]->factor.solve(rhs);
    }
    for (std::size_t i = 0; i < spans_.size(); ++i) {
      const Span& span = topology.spans[i];
      for (int end = 0; end < 2; ++end) {
        const std::size_t station = end == 0 ? span.left : span.right;
        Vector6d motion = carriedBy(station);
        if (lane.unknowns.count() > 0) {
          for (const UnknownEffect& effect : lane.effects[station]) {
            motion.head<3>() += lane.step[effect.unknown] * effect.displacement;
            motion.tail<3>() += lane.step[effect.unknown] * effect.rotation;
          }
        }
        put(motion, index, end == 0 ? spans_[i].left() : spans_[i].right());
      }
    }
  }
}

// The motion of everything between, from that of the spans' ends.
void LaneSystem::expand(const LaneSystem& by) {
  const element::Kernel& kernel = element::kernel();
  const element::Elimination<kLanes>& elimination = element::chainKernel().lanes;
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    SpanLanes& span = spans_[i];
    const int border = span.role.border();
    for (std::size_t j = span.count; j-- > 1;) {
      elimination.expand(by.spans_[i].links[j - 1], border, span.node(j).of, span.node(j + 1).of,
                         span.near.of);
    }
    for (std::size_t j = 0; j < span.count; ++j) {
      Element& at = elements_[span.element(j)];
      for (int end = 0; end < 2; ++end) {
        const NodeRows& node = span.endOf(j, end);
        std::copy(&node.of[0][0], &node.of[0][0] + kNodeDofs * kLanes, &at.rows[kInner + kNodeDofs * end][0]);
      }
      kernel.expand(by.elements_[span.element(j)].factor, at.rows);
    }
  }
}

void LaneSystem::predict(const LaneSystem& nominal) {
  condenseElements(nominal);
  pushByHeldEnds(nominal);
  condenseChains(nominal);
  solveStations(nominal, true);
  expand(nominal);
}

void LaneSystem::step() {
  condenseElements(*this);
  condenseChains(*this);
  solveStations(*this, false);
  expand(*this);
}

}  // namespace cable_variation
