#include <hunt/discrete_start.h>

#include <algorithm>
#include <cmath>

namespace cable_variation::hunt {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

// Sliding clips anywhere between the fixed things around them, in order.
void slideAtRandom(const DiscreteRod& rod, Draw& draw, DiscreteShape& shape) {
  const DiscreteLayout& layout = rod.layout();
  for (std::size_t i = 0; i < layout.stations.size();) {
    std::size_t last = i;
    while (last < layout.stations.size() && rod.slides(last)) ++last;
    if (last > i) {
      const double low = layout.stations[i - 1].arc_length, high = layout.stations[last].arc_length;
      std::vector<double> at;
      for (std::size_t k = i; k < last; ++k) at.push_back(draw.between(0.1, 0.9));
      std::sort(at.begin(), at.end());
      // no two nearer than a tenth of the room that each has
      const double gap = 0.1 / static_cast<double>(at.size() + 1);
      for (std::size_t k = 1; k < at.size(); ++k) at[k] = std::max(at[k], at[k - 1] + gap);
      for (std::size_t k = i; k < last; ++k) {
        shape.stations[k].arc_length = low + std::min(0.98, at[k - i]) * (high - low);
      }
    }
    i = last + 1;
  }
}

// Places that nothing holds: between their neighbours, each as near as the cable between is short; then
// aside.
void placeFreeStations(const DiscreteRod& rod, Draw& draw, DiscreteShape& shape) {
  const DiscreteLayout& layout = rod.layout();
  const std::size_t count = layout.stations.size();
  std::vector<bool> known(count), wanders(count);
  std::vector<std::size_t> root(count);
  Vector3d centre = Vector3d::Zero();
  double held = 0.0;
  for (std::size_t i : layout.parents_first) {
    root[i] = layout.stations[i].joint ? root[layout.stations[i].parent] : i;
    known[i] = rod.positionKnown(i);
    if (!known[i]) continue;
    centre += shape.stations[i].position;
    held += 1.0;
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (!known[root[i]]) shape.stations[i].position = centre / held + 1e-3 * draw.direction();
  }
  constexpr int kRounds = 200;
  std::vector<Vector3d> sum(count);
  std::vector<double> weight(count);
  for (int round = 0; round < kRounds; ++round) {
    std::fill(sum.begin(), sum.end(), Vector3d::Zero());
    std::fill(weight.begin(), weight.end(), 0.0);
    for (const DiscretePiece& piece : layout.pieces) {
      const double pull =
          1.0 / (shape.stations[piece.right].arc_length - shape.stations[piece.left].arc_length);
      for (const auto& [a, b] : {std::pair(piece.left, piece.right), std::pair(piece.right, piece.left)}) {
        sum[root[a]] += pull * shape.stations[b].position;
        weight[root[a]] += pull;
      }
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (!known[root[i]]) shape.stations[i].position = sum[root[i]] / weight[root[i]];
    }
  }
  std::vector<Vector3d> aside(count, Vector3d::Zero());
  for (const DiscretePiece& piece : layout.pieces) {
    const double length = shape.stations[piece.right].arc_length - shape.stations[piece.left].arc_length;
    for (std::size_t i : {piece.left, piece.right}) {
      const Vector3d chord = shape.stations[piece.right].position - shape.stations[piece.left].position;
      const double slack = std::max(0.0, length - chord.norm());
      aside[root[i]] += draw.between(0.2, 0.6) * slack * draw.direction();
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (!known[root[i]]) shape.stations[i].position += aside[root[i]];
  }
}

// Directions at stations: the clip's, or towards the neighbours.
void orientStations(const DiscreteRod& rod, DiscreteShape& shape) {
  const DiscreteLayout& layout = rod.layout();
  std::vector<Vector3d> along(layout.stations.size(), Vector3d::Zero());
  for (const DiscretePiece& piece : layout.pieces) {
    const Vector3d chord = shape.stations[piece.right].position - shape.stations[piece.left].position;
    along[piece.left] += chord;
    along[piece.right] += chord;
  }
  for (std::size_t i = 0; i < layout.stations.size(); ++i) {
    if (rod.orientationKnown(i)) continue;
    const double norm = along[i].norm();
    shape.stations[i].orientation =
        norm > 1e-12 ? shortestArc(Vector3d::UnitX(), along[i] / norm) : Quaterniond::Identity();
  }
  rod.place(shape);
}

struct Curve {
  Vector3d from, to, leaves, arrives, bulge;

  Vector3d at(double t) const {
    const double u = 1.0 - t;
    return u * u * (1.0 + 2.0 * t) * from + t * t * (3.0 - 2.0 * t) * to + u * u * t * leaves -
           t * t * u * arrives + 16.0 * u * u * t * t * bulge;
  }
  double length() const {
    constexpr int kParts = 40;
    double sum = 0.0;
    for (int i = 0; i < kParts; ++i) {
      sum += (at(static_cast<double>(i + 1) / kParts) - at(static_cast<double>(i) / kParts)).norm();
    }
    return sum;
  }
};

void fillPiece(const DiscreteRod& rod, std::size_t index, Draw& draw, int turns, DiscreteShape& shape) {
  const DiscretePiece& piece = rod.layout().pieces[index];
  const DiscreteShape::Station& left = shape.stations[piece.left];
  const DiscreteShape::Station& right = shape.stations[piece.right];
  const double length = right.arc_length - left.arc_length;
  const double pull = draw.between(0.3, 1.2) * length;
  Curve curve{left.position, right.position, pull * (left.orientation * Vector3d::UnitX()),
              pull * (right.orientation * Vector3d::UnitX()), Vector3d::Zero()};
  const Vector3d aside = draw.direction();
  double low = 0.0, high = 2.0 * length;
  if (curve.length() < length) {
    for (int i = 0; i < 30; ++i) {
      const double middle = 0.5 * (low + high);
      curve.bulge = middle * aside;
      (curve.length() < length ? low : high) = middle;
    }
  }
  DiscreteShape::Piece& nodes = shape.pieces[index];
  nodes.vertices.clear();
  nodes.segments.clear();
  for (std::size_t k = 1; k < piece.segments(); ++k) nodes.vertices.push_back(curve.at(piece.at[k]));
  Quaterniond frame = left.orientation;
  for (std::size_t k = 0; k < piece.segments(); ++k) {
    const Vector3d chord = shape.vertex(piece, index, k + 1) - shape.vertex(piece, index, k);
    if (chord.norm() > 1e-12 * length)
      frame = shortestArc(frame * Vector3d::UnitX(), chord.normalized()) * frame;
    nodes.segments.push_back(frame.normalized());
  }
  // what is left of a turn about the tangent is spread evenly
  const double twist = rotationVector(frame.conjugate() * right.orientation).x() + 2.0 * M_PI * turns;
  for (std::size_t k = 0; k < piece.segments(); ++k) {
    const double share = 0.5 * (piece.at[k] + piece.at[k + 1]);
    nodes.segments[k] = (nodes.segments[k] * rotationBy({share * twist, 0.0, 0.0})).normalized();
  }
  nodes.force.assign(piece.segments(), Vector3d::Zero());
}

DiscreteShape empty(const DiscreteRod& rod) {
  DiscreteShape shape;
  for (const DiscreteStation& of : rod.layout().stations) {
    DiscreteShape::Station station;
    station.arc_length = of.arc_length;
    if (of.clip) station.orientation = rod.harness().clips[*of.clip].pose.orientation;
    shape.stations.push_back(station);
  }
  shape.pieces.resize(rod.layout().pieces.size());
  rod.place(shape);
  return shape;
}

}  // namespace

DiscreteShape simpleStart(const DiscreteRod& rod, Draw& draw, bool anywhere, int turns) {
  DiscreteShape shape = empty(rod);
  if (anywhere) slideAtRandom(rod, draw, shape);
  placeFreeStations(rod, draw, shape);
  rod.place(shape);
  orientStations(rod, shape);
  for (std::size_t i = 0; i < shape.pieces.size(); ++i) fillPiece(rod, i, draw, turns, shape);
  return shape;
}

DiscreteShape startAt(const DiscreteRod& rod, const Equilibrium& answer) {
  const DiscreteLayout& layout = rod.layout();
  DiscreteShape shape = empty(rod);
  for (std::size_t i = 0; i < layout.clip_station.size(); ++i) {
    shape.stations[layout.clip_station[i]].arc_length = answer.clip_reactions[i].arc_length;
  }
  for (std::size_t i : layout.parents_first) {
    const DiscreteStation& of = layout.stations[i];
    DiscreteShape::Station& at = shape.stations[i];
    const Pose pose = answer.shapes[of.cable].pose(at.arc_length);
    at.position = pose.position;
    at.orientation = pose.orientation;
    if (of.clip) {
      const Pose in_clip = rod.harness().clips[*of.clip].pose.inverse() * pose;
      at.offset = in_clip.position;
      at.theta = rotationVector(in_clip.orientation);
      const ClipConstraint& holds = rod.harness().clips[*of.clip].constraint;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto axis = static_cast<Eigen::Index>(k);
        if (holds.translation[k].kind == ClipFreedom::Kind::locked) at.offset[axis] = 0.0;
        if (holds.rotation[k].kind == ClipFreedom::Kind::locked) at.theta[axis] = 0.0;
      }
    } else if (of.joint && rod.harness().joints[*of.joint].type == Joint::Type::hinge) {
      const Joint& joint = rod.harness().joints[*of.joint];
      const Quaterniond parent = shape.stations[of.parent].orientation * joint.rotation;
      at.hinge = rotationVector(parent.conjugate() * pose.orientation).dot(joint.axis);
    }
  }
  rod.place(shape);
  for (std::size_t i = 0; i < layout.pieces.size(); ++i) {
    const DiscretePiece& piece = layout.pieces[i];
    const CableShape& cable = answer.shapes[piece.cable];
    const double left = shape.stations[piece.left].arc_length;
    const double length = shape.stations[piece.right].arc_length - left;
    DiscreteShape::Piece& nodes = shape.pieces[i];
    std::size_t point = 1;
    for (std::size_t k = 0; k < piece.segments(); ++k) {
      if (k > 0) nodes.vertices.push_back(cable.position(left + piece.at[k] * length));
      const double s = left + 0.5 * (piece.at[k] + piece.at[k + 1]) * length;
      const Pose pose = cable.pose(s);
      while (point + 1 < cable.points.size() && cable.points[point].arc_length < s) ++point;
      const ShapePoint &a = cable.points[point - 1], &b = cable.points[point];
      const double t = b.arc_length > a.arc_length ? (s - a.arc_length) / (b.arc_length - a.arc_length) : 0.0;
      nodes.segments.push_back(pose.orientation);
      nodes.force.push_back(pose.orientation.conjugate() * ((1.0 - t) * a.force + t * b.force));
    }
  }
  return shape;
}

}  // namespace cable_variation::hunt
