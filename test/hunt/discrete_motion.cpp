// How the stations, vertices and frames of DiscreteRod move with its unknowns.

#include <cmath>

#include <hunt/discrete_element.h>
#include <hunt/discrete_rod.h>
#include <hunt/rotation.h>

namespace cable_variation::hunt {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using Eigen::VectorXd;

// The orientation of a station when unknowns move by what `by` says.
Quaterniond DiscreteRod::turned(const DiscreteShape& shape, std::size_t station,
                                const std::array<std::pair<int, double>, 2>& by) const {
  const DiscreteStation& of = layout_.stations[station];
  const StationUnknowns& own = unknown_[station];
  const DiscreteShape::Station& at = shape.stations[station];
  Vector3d turn = Vector3d::Zero();
  double hinge = 0.0;
  for (const auto& [unknown, value] : by) {
    for (int k = 0; k < 3; ++k) {
      if (own.rotation[static_cast<std::size_t>(k)] == unknown) turn[k] += value;
    }
    if (own.hinge >= 0 && own.hinge == unknown) hinge += value;
  }
  if (of.clip && own.chart) {
    return harness_.clips[*of.clip].pose.orientation * rotationBy(at.theta + turn);
  }
  if (of.joint && harness_.joints[*of.joint].type != Joint::Type::pivot) {
    const Joint& joint = harness_.joints[*of.joint];
    return turned(shape, of.parent, by) * joint.rotation * rotationBy((at.hinge + hinge) * joint.axis);
  }
  return at.orientation * rotationBy(turn);
}

std::vector<int> DiscreteRod::turningUnknowns(std::size_t station) const {
  std::vector<int> unknowns;
  for (std::size_t i = station;;) {
    for (int unknown : unknown_[i].rotation) {
      if (unknown >= 0) unknowns.push_back(unknown);
    }
    if (unknown_[i].hinge >= 0) unknowns.push_back(unknown_[i].hinge);
    const DiscreteStation& of = layout_.stations[i];
    if (!of.joint || harness_.joints[*of.joint].type == Joint::Type::pivot) return unknowns;
    i = of.parent;
  }
}

std::vector<DiscreteRod::Row> DiscreteRod::rows(const DiscreteShape& shape, const RodModel& model) const {
  std::vector<Row> rows(static_cast<std::size_t>(raw_count_));
  const auto at = [&rows](int raw) -> Row& { return rows[static_cast<std::size_t>(raw)]; };
  for (std::size_t i : layout_.parents_first) {
    const DiscreteStation& of = layout_.stations[i];
    const StationUnknowns& own = unknown_[i];
    const int raw = rawStation(i);
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(), turns = Eigen::Matrix3d::Identity();
    if (of.clip) axes = harness_.clips[*of.clip].pose.orientation.toRotationMatrix();
    if (own.chart) turns = rightJacobian(shape.stations[i].theta);
    for (int c = 0; c < 3; ++c) {
      for (int k = 0; k < 3; ++k) {
        const auto unknown = static_cast<std::size_t>(k);
        if (own.translation[unknown] >= 0) at(raw + c).emplace_back(own.translation[unknown], axes(c, k));
        if (own.rotation[unknown] >= 0) at(raw + 3 + c).emplace_back(own.rotation[unknown], turns(c, k));
      }
    }
    if (of.joint) {
      const Joint& joint = harness_.joints[*of.joint];
      const int parent = rawStation(of.parent);
      for (int c = 0; c < 3; ++c) {
        at(raw + c) = at(parent + c);
        if (own.hinge >= 0) at(raw + 3 + c).emplace_back(own.hinge, joint.axis[c]);
        if (joint.type == Joint::Type::pivot) continue;
        const Eigen::Matrix3d back = (joint.rotation * rotationBy(shape.stations[i].hinge * joint.axis))
                                         .toRotationMatrix()
                                         .transpose();
        for (int k = 0; k < 3; ++k) {
          for (const auto& [unknown, value] : at(parent + 3 + k)) {
            at(raw + 3 + c).emplace_back(unknown, back(c, k) * value);
          }
        }
      }
    }
    if (own.slide >= 0 && !model.hold_slides) at(raw + 6).emplace_back(own.slide, 1.0);
  }
  for (std::size_t i = 0; i < layout_.pieces.size(); ++i) {
    const int more = 3 * static_cast<int>(2 * layout_.pieces[i].segments() - 1);
    for (int k = 0; k < more; ++k) at(first_raw_[i] + k).emplace_back(first_unknown_[i] + k, 1.0);
  }
  return rows;
}

void DiscreteRod::predictForces(const std::vector<Row>& rows, const VectorXd& step, const RodModel& model,
                                DiscreteShape& shape) const {
  const auto motion = [&](int raw) {
    double value = 0.0;
    for (const auto& [unknown, by] : rows[static_cast<std::size_t>(raw)]) value += by * step[unknown];
    return value;
  };
  for (std::size_t i = 0; i < layout_.pieces.size(); ++i) {
    const DiscretePiece& piece = layout_.pieces[i];
    const double left = shape.stations[piece.left].arc_length;
    const double length = shape.stations[piece.right].arc_length - left;
    const double longer = motion(rawStation(piece.right) + 6) - motion(rawStation(piece.left) + 6);
    for (std::size_t k = 0; k < piece.segments(); ++k) {
      const double share = piece.at[k + 1] - piece.at[k];
      const RodProperties rod =
          profiles_[piece.cable].at(left + 0.5 * (piece.at[k] + piece.at[k + 1]) * length);
      const StretchVector v(shape.vertex(piece, i, k), shape.vertex(piece, i, k + 1),
                            shape.pieces[i].segments[k]);
      Eigen::Matrix<double, 9, 1> moved;
      for (int c = 0; c < 3; ++c) {
        moved[c] = motion(rawVertex(i, k) + c);
        moved[3 + c] = motion(rawVertex(i, k + 1) + c);
        moved[6 + c] = motion(rawSegment(i, k) + c);
      }
      const double h = share * length;
      const Vector3d strain =
          (v.value + v.first() * moved) / h - v.value * share * longer / (h * h) - Vector3d::UnitX();
      shape.pieces[i].force[k] =
          softened(rod, i, share, model) * rod.stiffness.head<3>().cwiseProduct(strain);
    }
  }
}

void DiscreteRod::move(const VectorXd& step, const RodModel& model, DiscreteShape& shape) const {
  predictForces(rows(shape, model), step, model, shape);
  for (std::size_t i = 0; i < layout_.stations.size(); ++i) {
    const StationUnknowns& own = unknown_[i];
    DiscreteShape::Station& at = shape.stations[i];
    Vector3d shift = Vector3d::Zero(), turn = Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
      const auto unknown = static_cast<std::size_t>(k);
      if (own.translation[unknown] >= 0) shift[k] = step[own.translation[unknown]];
      if (own.rotation[unknown] >= 0) turn[k] = step[own.rotation[unknown]];
    }
    at.offset += shift;
    if (!layout_.stations[i].clip) at.position += shift;
    if (own.chart) {
      at.theta += turn;
      // the same rotation by the shorter way; components that are locked stay 0
      if (at.theta.norm() > M_PI) at.theta *= 1.0 - 2.0 * M_PI / at.theta.norm();
    } else {
      at.orientation = at.orientation * rotationBy(turn);
    }
    if (own.hinge >= 0) at.hinge += step[own.hinge];
    if (own.slide >= 0) at.arc_length += step[own.slide];
  }
  for (std::size_t i = 0; i < layout_.pieces.size(); ++i) {
    DiscreteShape::Piece& nodes = shape.pieces[i];
    int unknown = first_unknown_[i];
    for (Vector3d& vertex : nodes.vertices) {
      vertex += step.segment<3>(unknown);
      unknown += 3;
    }
    for (Quaterniond& segment : nodes.segments) {
      segment = (segment * rotationBy(step.segment<3>(unknown))).normalized();
      unknown += 3;
    }
  }
  place(shape);
}

}  // namespace cable_variation::hunt
