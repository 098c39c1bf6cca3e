// Energy, gradient and Hessian of DiscreteRod: local elements in the freedoms of sections, then the unknowns.

#include <cmath>

#include <hunt/discrete_element.h>
#include <hunt/discrete_rod.h>
#include <hunt/rotation.h>

namespace cable_variation::hunt {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Kind = ClipFreedom::Kind;

namespace {

// Two halves of a bending element one after the other, which bear the same moment.
RodProperties inSeries(const RodProperties& a, const RodProperties& b) {
  RodProperties both = a;
  both.stiffness = 2.0 * (a.stiffness.cwiseInverse() + b.stiffness.cwiseInverse()).cwiseInverse();
  both.rest_curvature = 0.5 * (a.rest_curvature + b.rest_curvature);
  return both;
}

}  // namespace

class DiscreteRod::Assembler {
 public:
  Assembler(std::vector<Row> rows, int raw, int unknowns)
      : rows_(std::move(rows)), raw_gradient_(VectorXd::Zero(raw)), gradient_(VectorXd::Zero(unknowns)) {}

  template <int n>
  void add(const std::array<int, n>& raw, const Eigen::Matrix<double, n, 1>& gradient,
           const Eigen::Matrix<double, n, n>& hessian) {
    for (int i = 0; i < n; ++i) {
      const auto a = static_cast<std::size_t>(i);
      raw_gradient_[raw[a]] += gradient[i];
      for (const auto& [row, by_row] : rows_[static_cast<std::size_t>(raw[a])]) {
        gradient_[row] += by_row * gradient[i];
        for (int j = 0; j < n; ++j) {
          const auto b = static_cast<std::size_t>(j);
          for (const auto& [column, by_column] : rows_[static_cast<std::size_t>(raw[b])]) {
            if (row >= column) addSecond(row, column, by_row * by_column * hessian(i, j));
          }
        }
      }
    }
  }
  void addSecond(int row, int column, double value) { entries_.emplace_back(row, column, value); }
  void addFirst(int row, double value) { gradient_[row] += value; }

  Vector3d rawGradient(int raw) const { return raw_gradient_.segment<3>(raw); }
  void take(VectorXd& gradient, Eigen::SparseMatrix<double>& hessian) {
    const Eigen::Index n = gradient_.size();
    for (int i = 0; i < n; ++i) entries_.emplace_back(i, i, 0.0);
    hessian.resize(n, n);
    hessian.setFromTriplets(entries_.begin(), entries_.end());
    gradient = std::move(gradient_);
  }

 private:
  std::vector<Row> rows_;
  VectorXd raw_gradient_, gradient_;
  std::vector<Eigen::Triplet<double>> entries_;
};

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

// Second derivatives of the stations' rotation vectors by the unknowns, by central differences.
void DiscreteRod::addChartCurvature(const DiscreteShape& shape, Assembler& assembler) const {
  constexpr double kStep = 1e-3;
  for (std::size_t i = 0; i < layout_.stations.size(); ++i) {
    const DiscreteStation& of = layout_.stations[i];
    const bool from_parent = of.joint && harness_.joints[*of.joint].type != Joint::Type::pivot;
    if (!unknown_[i].chart && !from_parent) continue;
    const std::vector<int> unknowns = turningUnknowns(i);
    const Vector3d moment = assembler.rawGradient(rawStation(i) + 3);
    const Quaterniond back = shape.stations[i].orientation.conjugate();
    const auto value = [&](int a, double da, int b, double db) {
      return moment.dot(rotationVector(back * turned(shape, i, {{{a, da}, {b, db}}})));
    };
    for (int a : unknowns) {
      for (int b : unknowns) {
        if (a < b) continue;
        const double second = value(a, kStep, b, kStep) - value(a, kStep, b, -kStep) -
                              value(a, -kStep, b, kStep) + value(a, -kStep, b, -kStep);
        assembler.addSecond(a, b, second / (4.0 * kStep * kStep));
      }
    }
  }
}

template <class Add>
void DiscreteRod::forEachSpring(const DiscreteShape& shape, Add add) const {
  for (std::size_t i = 0; i < layout_.stations.size(); ++i) {
    if (!layout_.stations[i].clip) continue;
    const ClipConstraint& holds = harness_.clips[*layout_.stations[i].clip].constraint;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      if (holds.translation[k].kind == Kind::sprung) {
        add(unknown_[i].translation[k], holds.translation[k].stiffness, shape.stations[i].offset[axis]);
      }
      if (holds.rotation[k].kind == Kind::sprung) {
        add(unknown_[i].rotation[k], holds.rotation[k].stiffness, shape.stations[i].theta[axis]);
      }
    }
  }
}

DiscreteRod::Energy DiscreteRod::collect(const DiscreteShape& shape, const RodModel& model,
                                         Assembler* assembler) const {
  Energy energy;
  for (std::size_t i = 0; i < layout_.pieces.size(); ++i) {
    const DiscretePiece& piece = layout_.pieces[i];
    const RodProfile& profile = profiles_[piece.cable];
    const double left = shape.stations[piece.left].arc_length;
    const double length = shape.stations[piece.right].arc_length - left;
    const int slide_left = rawStation(piece.left) + 6, slide_right = rawStation(piece.right) + 6;
    const std::size_t count = piece.segments();
    const bool slides = this->slides(piece.left) || this->slides(piece.right);
    // an element's length and middle as the piece's ends slide: derivatives by their arc lengths
    struct Chain {
      Eigen::Vector2d length, place;
    };
    const auto addStrain = [&](const StrainEnergy& w, const auto& first, const auto& second, const auto& ids,
                               const Vector3d& stiffness_per_length, const Chain& chain) {
      constexpr int n = std::decay_t<decltype(first)>::ColsAtCompileTime;
      Eigen::Matrix<double, n + 2, 1> g;
      Eigen::Matrix<double, n + 2, n + 2> h;
      g.template head<n>() = first.transpose() * w.stress;
      g.template tail<2>() = w.by_length * chain.length + w.by_place * chain.place;
      h.template topLeftCorner<n, n>() =
          first.transpose() * stiffness_per_length.asDiagonal() * first + second;
      const Eigen::Matrix<double, n, 2> mixed =
          first.transpose() *
          (w.by_v_length * chain.length.transpose() + w.by_v_place * chain.place.transpose());
      h.template topRightCorner<n, 2>() = mixed;
      h.template bottomLeftCorner<2, n>() = mixed.transpose();
      h.template bottomRightCorner<2, 2>() = w.by_length_length * chain.length * chain.length.transpose() +
                                             w.by_length_place * (chain.length * chain.place.transpose() +
                                                                  chain.place * chain.length.transpose()) +
                                             w.by_place_place * chain.place * chain.place.transpose();
      assembler->add<n + 2>(ids, g, h);
    };
    for (std::size_t k = 0; k < count; ++k) {
      const double share = piece.at[k + 1] - piece.at[k], middle = 0.5 * (piece.at[k] + piece.at[k + 1]);
      const double h = share * length;
      const RodProperties rod = profile.at(left + middle * length);
      const double soft = softened(rod, i, share, model);
      const Vector3d from = shape.vertex(piece, i, k), to = shape.vertex(piece, i, k + 1);
      const StretchVector v(from, to, shape.pieces[i].segments[k]);
      const Vector3d stiffness = soft * rod.stiffness.head<3>();
      const StrainEnergy w(v.value, h, stiffness, soft * rod.stiffness_slope.head<3>(), Vector3d::UnitX(),
                           Vector3d::Zero());
      energy.stretch += w.energy;
      const double weight = rod.mass_per_length * h;
      const Vector3d centre = 0.5 * (from + to);
      energy.gravity -= weight * harness_.gravity.dot(centre);
      if (assembler == nullptr) continue;
      const Chain chain = {{-share, share}, {1.0 - middle, middle}};
      const int a = rawVertex(i, k), b = rawVertex(i, k + 1), q = rawSegment(i, k);
      const std::array<int, 11> ids = {a, a + 1, a + 2, b,          b + 1,      b + 2,
                                       q, q + 1, q + 2, slide_left, slide_right};
      addStrain(w, v.first(), v.second(model.given_force ? shape.pieces[i].force[k] : w.stress), ids,
                stiffness / h, chain);
      // -ρ h g·φ: ρ h changes as the ends slide
      const Eigen::Vector2d weight_slope =
          rod.mass_per_length * chain.length + rod.mass_slope * h * chain.place;
      const double along = -harness_.gravity.dot(centre);
      Eigen::Matrix<double, 11, 1> g = Eigen::Matrix<double, 11, 1>::Zero();
      Eigen::Matrix<double, 11, 11> second = Eigen::Matrix<double, 11, 11>::Zero();
      g.head<3>() = g.segment<3>(3) = -0.5 * weight * harness_.gravity;
      g.tail<2>() = along * weight_slope;
      for (int end = 0; end < 2; ++end) {
        second.block<3, 2>(3 * end, 9) = -0.5 * harness_.gravity * weight_slope.transpose();
        second.block<2, 3>(9, 3 * end) = second.block<3, 2>(3 * end, 9).transpose();
      }
      second.bottomRightCorner<2, 2>() =
          along * rod.mass_slope *
          (chain.length * chain.place.transpose() + chain.place * chain.length.transpose());
      assembler->add<11>(ids, g, second);
    }
    for (std::size_t k = 0; k <= count; ++k) {
      // between the middles of two segments, or a station and the next one
      const double begin = k == 0 ? 0.0 : 0.5 * (piece.at[k - 1] + piece.at[k]);
      const double end = k == count ? 1.0 : 0.5 * (piece.at[k] + piece.at[k + 1]);
      const Quaterniond& before =
          k == 0 ? shape.stations[piece.left].orientation : shape.pieces[i].segments[k - 1];
      const Quaterniond& after =
          k == count ? shape.stations[piece.right].orientation : shape.pieces[i].segments[k];
      const double middle = 0.5 * (begin + end), h = (end - begin) * length;
      const RodProperties rod = slides ? profile.at(left + middle * length)
                                       : inSeries(profile.at(left + 0.5 * (begin + middle) * length),
                                                  profile.at(left + 0.5 * (middle + end) * length));
      const CurvatureVector v(before, after);
      const Vector3d stiffness = rod.stiffness.tail<3>();
      const StrainEnergy w(v.value, h, stiffness, rod.stiffness_slope.tail<3>(), rod.rest_curvature,
                           rod.rest_curvature_slope);
      energy.bending += w.energy;
      if (assembler == nullptr) continue;
      const int a = k == 0 ? rawStation(piece.left) + 3 : rawSegment(i, k - 1);
      const int b = k == count ? rawStation(piece.right) + 3 : rawSegment(i, k);
      const std::array<int, 8> ids = {a, a + 1, a + 2, b, b + 1, b + 2, slide_left, slide_right};
      addStrain(w, v.first(), v.second(w.stress), ids, stiffness / h,
                {{begin - end, end - begin}, {1.0 - middle, middle}});
    }
  }
  for (std::size_t i = 0; i < layout_.stations.size(); ++i) {
    for (std::size_t load : layout_.stations[i].loads) {
      const Vector3d& force = harness_.loads[load].force;
      energy.loads -= force.dot(shape.stations[i].position);
      const int raw = rawStation(i);
      if (assembler != nullptr) assembler->add<3>({raw, raw + 1, raw + 2}, -force, Eigen::Matrix3d::Zero());
    }
  }
  forEachSpring(shape, [&](int unknown, double stiffness, double deflection) {
    energy.springs += 0.5 * stiffness * deflection * deflection;
    if (assembler == nullptr) return;
    assembler->addFirst(unknown, stiffness * deflection);
    assembler->addSecond(unknown, unknown, stiffness);
  });
  return energy;
}

DiscreteRod::Energy DiscreteRod::energy(const DiscreteShape& shape, const RodModel& model) const {
  return collect(shape, model, nullptr);
}

DiscreteRod::Energy DiscreteRod::assemble(const DiscreteShape& shape, const RodModel& model,
                                          VectorXd& gradient, Eigen::SparseMatrix<double>& hessian) const {
  Assembler assembler(rows(shape, model), raw_count_, count_);
  const Energy energy = collect(shape, model, &assembler);
  addChartCurvature(shape, assembler);
  for (const StationUnknowns& own : unknown_) {
    if (own.slide >= 0 && model.hold_slides)
      assembler.addSecond(own.slide, own.slide, bending_metric_[own.slide]);
  }
  assembler.take(gradient, hessian);
  return energy;
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
