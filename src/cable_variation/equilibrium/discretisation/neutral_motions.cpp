#include <cable_variation/equilibrium/discretisation/neutral_motions.h>

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace cable_variation {
namespace {

// Clips that are aligned to this [rad, and of the longest cable] count as aligned.
constexpr double kAligned = 1e-7;
// A motion that differs from others by less than this share of itself is one of them.
constexpr double kAnother = 1e-3;
// A motion that costs less than this share of the softest span's first bow costs nothing.
// Or less than so many times what the Hessian is rounded by.
constexpr double kNegligible = 1e-5, kOfRounding = 10.0;
// Coefficients that are rounding, of those of 1.
constexpr double kRounding = 1e-9;

// Whether turning every section about its own normal by one angle changes no energy.
bool isRound(const Cable& cable) {
  constexpr double kEqual = 1e-12;
  const auto equal = [](double a, double b) { return std::abs(a - b) <= kEqual * (a + b); };
  return std::all_of(cable.sections.begin(), cable.sections.end(),
                     [&](const SectionAt& at) {
                       return equal(at.section.EI_y, at.section.EI_z) &&
                              equal(at.section.GA_y, at.section.GA_z);
                     }) &&
         std::all_of(cable.rest_curvature.begin(), cable.rest_curvature.end(),
                     [](const auto& at) { return at.curvature.template tail<2>().isZero(0.0); });
}

// The unknowns that are no slid arc length and wind no spring.
std::vector<bool> looseUnknowns(const RodSystem& system, const Configuration& configuration) {
  const StationUnknowns& unknowns = system.unknowns();
  std::vector<bool> loose(static_cast<std::size_t>(unknowns.count()), true);
  Eigen::VectorXd none = Eigen::VectorXd::Zero(unknowns.count());
  std::vector<StationUnknowns::Curvature> springs;
  unknowns.addSprings(configuration, none, &springs);
  for (const auto& spring : springs) loose[static_cast<std::size_t>(spring.row)] = false;
  for (std::size_t i = 0; i < configuration.stations.size(); ++i) {
    if (unknowns.slide(i) >= 0) loose[static_cast<std::size_t>(unknowns.slide(i))] = false;
  }
  return loose;
}

Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

Eigen::Vector3d displacementAt(const NeutralMotion::OfSpan& of, const Eigen::Vector3d& from_left) {
  return of.translation + of.rotation.cross(from_left);
}

}  // namespace

void NeutralMotion::addScaled(double factor, const NeutralMotion& other) {
  for (std::size_t i = 0; i < spans.size(); ++i) {
    spans[i].translation += factor * other.spans[i].translation;
    spans[i].rotation += factor * other.spans[i].rotation;
    spans[i].spin += factor * other.spans[i].spin;
  }
  unknowns += factor * other.unknowns;
}

namespace {

// What clips, joints and neighbours ask of the spans: columns for each span's displacement, turn and spin,
// turns by what they move at the length of the longest cable, then for the stations' unknowns.
class Constraints {
 public:
  Constraints(const RodSystem& system, const Configuration& configuration)
      : spans_(static_cast<Eigen::Index>(system.topology().spans.size())),
        length_(largestArcLength(configuration)),
        matrix_(Eigen::MatrixXd::Zero(12 * spans_, 7 * spans_ + system.unknowns().count())),
        loose_(looseUnknowns(system, configuration)) {
    const auto effects = system.unknowns().effects(configuration);
    for (Eigen::Index i = 0; i < spans_; ++i) {
      const Span& span = system.topology().spans[static_cast<std::size_t>(i)];
      const Eigen::Vector3d& origin = configuration.stations[span.left].pose.position;
      round_.push_back(isRound(system.harness().cables[span.cable]));
      for (const std::size_t station : {span.left, span.right}) {
        const Eigen::Index row = 12 * i + (station == span.left ? 0 : 6), column = 7 * i;
        const Pose& pose = configuration.stations[station].pose;
        matrix_.block<3, 3>(row, column).setIdentity();
        matrix_.block<3, 3>(row, column + 3) = -crossMatrix(pose.position - origin) / length_;
        matrix_.block<3, 3>(row + 3, column + 3) = pose.orientation.toRotationMatrix().transpose();
        matrix_(row + 3, column + 6) = 1.0;
        for (const UnknownEffect& effect : effects[station]) {
          matrix_.block<3, 1>(row, 7 * spans_ + effect.unknown) -= effect.displacement;
          matrix_.block<3, 1>(row + 3, 7 * spans_ + effect.unknown) -= length_ * effect.rotation;
        }
      }
    }
  }

  // What they leave; `rigid`: of spans that move, too, not of spins alone.
  std::vector<NeutralMotion> allowed(bool rigid) const {
    std::vector<Eigen::Index> columns;
    for (Eigen::Index i = 0; i < spans_; ++i) {
      for (Eigen::Index k = 0; k < 6 && rigid; ++k) columns.push_back(7 * i + k);
      if (round_[static_cast<std::size_t>(i)]) columns.push_back(7 * i + 6);
    }
    for (std::size_t k = 0; k < loose_.size(); ++k) {
      if (loose_[k]) columns.push_back(7 * spans_ + static_cast<Eigen::Index>(k));
    }
    std::vector<NeutralMotion> motions;
    Eigen::MatrixXd chosen(matrix_.rows(), static_cast<Eigen::Index>(columns.size()));
    for (std::size_t k = 0; k < columns.size(); ++k)
      chosen.col(static_cast<Eigen::Index>(k)) = matrix_.col(columns[k]);
    if (chosen.size() == 0) return motions;
    Eigen::FullPivLU<Eigen::MatrixXd> factor(chosen);
    factor.setThreshold(kAligned);
    if (factor.dimensionOfKernel() == 0) return motions;
    const Eigen::MatrixXd kernel = factor.kernel();
    for (Eigen::Index m = 0; m < kernel.cols(); ++m) {
      Eigen::VectorXd of = Eigen::VectorXd::Zero(matrix_.cols());
      for (std::size_t k = 0; k < columns.size(); ++k)
        of[columns[k]] = kernel(static_cast<Eigen::Index>(k), m);
      NeutralMotion motion;
      for (Eigen::Index i = 0; i < spans_; ++i) {
        motion.spans.push_back(
            {of.segment<3>(7 * i), of.segment<3>(7 * i + 3) / length_, of[7 * i + 6] / length_});
      }
      motion.unknowns = of.tail(matrix_.cols() - 7 * spans_);
      motions.push_back(std::move(motion));
    }
    return motions;
  }

 private:
  Eigen::Index spans_;
  double length_;  // [m]
  Eigen::MatrixXd matrix_;
  std::vector<bool> loose_;  // per unknown
  std::vector<bool> round_;  // per span
};

}  // namespace

double softestBending(const RodSystem& system) {
  double bending = INFINITY;
  const std::vector<RodSystem::Metric> stiffness = system.bendingMetric(), surface = system.surfaceMetric();
  for (std::size_t i = 0; i < stiffness.size(); ++i)
    bending = std::min(bending, stiffness[i].position / surface[i].position);
  return bending;
}

NodalField fieldOf(const NeutralMotion& motion, const RodSystem& system, const Configuration& configuration) {
  NodalField field = system.zeroField();
  field.unknowns = motion.unknowns;
  for (std::size_t i = 0; i < motion.spans.size(); ++i) {
    const SpanConfiguration& nodes = configuration.spans[i];
    for (std::size_t k = 0; k < nodes.positions.size(); ++k) {
      auto at = field.spans[i].col(static_cast<Eigen::Index>(k));
      at.head<3>() = displacementAt(motion.spans[i], nodes.positions[k] - nodes.positions.front());
      at.tail<3>() = nodes.orientations[k].conjugate() * motion.spans[i].rotation;
      at[3] += motion.spans[i].spin;
    }
  }
  system.carryEnds(field);
  return field;
}

bool addOrthonormal(const RodSystem& system, const std::vector<RodSystem::Metric>& metric, NodalField field,
                    std::vector<NodalField>& fields) {
  NodalField weighted;
  system.applyMetric(metric, field, weighted);
  const double before = std::sqrt(field.dot(weighted));
  if (!(before > 0.0)) return false;
  double after = before;
  for (int twice = 0; twice < 2; ++twice) {
    for (const NodalField& other : fields) field.addScaled(-other.dot(weighted), other);
    system.applyMetric(metric, field, weighted);
    after = std::sqrt(std::max(field.dot(weighted), 0.0));
    if (!(after > kAnother * before)) return false;
  }
  field.scale(1.0 / after);
  fields.push_back(std::move(field));
  return true;
}

namespace {

// Motions, orthonormal in the metric of bending.
class Basis {
 public:
  Basis(const RodSystem& system, const Configuration& configuration)
      : system_(system), configuration_(configuration), metric_(system.bendingMetric()) {}

  // Adds what of a motion is none of those there.
  void add(NeutralMotion motion) {
    NodalField field = fieldOf(motion, system_, configuration_), weighted;
    system_.applyMetric(metric_, field, weighted);
    const double before = std::sqrt(field.dot(weighted));
    double after = before;
    for (int twice = 0; twice < 2; ++twice) {
      for (std::size_t i = 0; i < fields_.size(); ++i) {
        const double part = fields_[i].dot(weighted);
        field.addScaled(-part, fields_[i]);
        motion.addScaled(-part, motions_[i]);
      }
      system_.applyMetric(metric_, field, weighted);
      after = std::sqrt(std::max(field.dot(weighted), 0.0));
      if (!(after > kAnother * before)) return;
    }
    field.scale(1.0 / after);
    motion.addScaled(1.0 / after - 1.0, NeutralMotion(motion));
    fields_.push_back(std::move(field));
    motions_.push_back(std::move(motion));
  }

  std::size_t size() const { return fields_.size(); }
  const NeutralMotion& motion(std::size_t i) const { return motions_[i]; }

  // What the energy's second derivative makes of those from `first` on.
  Eigen::MatrixXd stiffness(std::size_t first) const {
    const auto count = static_cast<Eigen::Index>(fields_.size() - first);
    Eigen::MatrixXd form(count, count);
    for (Eigen::Index a = 0; a < count; ++a) {
      const NodalField& field = fields_[first + static_cast<std::size_t>(a)];
      form(a, a) = system_.curvatureAlong(field);
      for (Eigen::Index b = 0; b < a; ++b) {
        NodalField both = field;
        both.addScaled(1.0, fields_[first + static_cast<std::size_t>(b)]);
        form(a, b) = form(b, a) = 0.5 * (system_.curvatureAlong(both) - form(a, a) - form(b, b));
      }
    }
    return form;
  }

 private:
  const RodSystem& system_;
  const Configuration& configuration_;
  std::vector<RodSystem::Metric> metric_;
  std::vector<NeutralMotion> motions_;
  std::vector<NodalField> fields_;
};

// What a stiff cable's swing under its weight costs is next to nothing beside its bending: it is not beside
// that of the softest span.
bool costsNothing(const NeutralMotion& motion, const RodSystem& system, const Configuration& configuration) {
  const NodalField field = fieldOf(motion, system, configuration);
  NodalField weighted;
  system.applyMetric(system.surfaceMetric(), field, weighted);
  const double negligible = std::max(kNegligible, kOfRounding * system.stiffnessNoise());
  return std::abs(system.curvatureAlong(field)) <= negligible * softestBending(system) * field.dot(weighted);
}

// Columns that span the same space, each with a row that the others have nothing in.
Eigen::MatrixXd apart(const Eigen::MatrixXd& columns) {
  if (columns.cols() == 0) return columns;
  const Eigen::FullPivLU<Eigen::MatrixXd> factor(columns.transpose());
  const auto& order = factor.permutationQ().indices();
  Eigen::MatrixXd own(columns.cols(), columns.cols());
  for (Eigen::Index k = 0; k < columns.cols(); ++k) own.row(k) = columns.row(order[k]);
  return columns * own.inverse();
}

}  // namespace

std::vector<NeutralMotion> neutralMotions(const RodSystem& system, const Configuration& configuration,
                                          double share) {
  const Constraints constraints(system, configuration);
  Basis basis(system, configuration);
  std::vector<NeutralMotion> neutral;
  // Nothing works along spins.
  for (const NeutralMotion& spin : constraints.allowed(false)) {
    const std::size_t before = basis.size();
    basis.add(spin);
    if (basis.size() > before) neutral.push_back(spin);
  }
  // Along the others weight and loads may, along what in them is no spin.
  const std::size_t spins = basis.size();
  for (const NeutralMotion& motion : constraints.allowed(true)) basis.add(motion);
  if (basis.size() == spins) return neutral;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> costs(basis.stiffness(spins));
  const Eigen::Index costless = (costs.eigenvalues().array().abs() <= share).count();
  Eigen::MatrixXd combinations(costs.eigenvalues().size(), costless);
  for (Eigen::Index k = 0, next = 0; k < costs.eigenvalues().size(); ++k) {
    if (std::abs(costs.eigenvalues()[k]) <= share) combinations.col(next++) = costs.eigenvectors().col(k);
  }
  combinations = apart(combinations);
  for (Eigen::Index k = 0; k < costless; ++k) {
    NeutralMotion motion = basis.motion(spins);
    motion.addScaled(-1.0, basis.motion(spins));
    for (Eigen::Index m = 0; m < combinations.rows(); ++m) {
      if (std::abs(combinations(m, k)) > kRounding)
        motion.addScaled(combinations(m, k), basis.motion(spins + static_cast<std::size_t>(m)));
    }
    if (costsNothing(motion, system, configuration)) neutral.push_back(std::move(motion));
  }
  return neutral;
}

}  // namespace cable_variation
