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

}  // namespace cable_variation::hunt
