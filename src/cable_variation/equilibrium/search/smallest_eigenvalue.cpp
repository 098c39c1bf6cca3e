#include <cable_variation/equilibrium/search/smallest_eigenvalue.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Eigenvalues>

#include <cable_variation/equilibrium/discretisation/held_contacts.h>
#include <cable_variation/equilibrium/neutral_note.h>
#include <cable_variation/equilibrium/search/minimise.h>

namespace cable_variation {
namespace {

// Beside a motion to start from, which is of norm 1.
constexpr double kOfOthers = 1e-3;
// A motion that costs less than this share of what it would in bending may be a neutral one.
constexpr double kSuspicious = 1e-2;
// It is one if it costs no more than rounding: this share of bending, or so much of what the Hessian is
// rounded by, more where it is not known to strain nothing; and nothing beside the softest span's first bow.
constexpr double kStrainless = 1e-8, kNone = 1e-9, kOfRounding = 10.0;
constexpr double kOfSoftest = 1e-5;
// More motions than this are not left out for rounding alone.
constexpr std::size_t kMostUnnamed = 12;

// A vector with a part along everything, the same every time.
NodalField deterministicField(const RodSystem& system) {
  NodalField field = system.zeroField();
  unsigned state = 12345;
  const auto next = [&state] {
    state = state * 1664525u + 1013904223u;
    return static_cast<double>(state >> 8) / 16777216.0 - 0.5;
  };
  for (Eigen::Index i = 0; i < field.unknowns.size(); ++i) field.unknowns[i] = next();
  for (auto& nodes : field.spans) {
    for (Eigen::Index c = 1; c + 1 < nodes.cols(); ++c) {
      for (Eigen::Index r = 0; r < 6; ++r) nodes(r, c) = next();
    }
  }
  return field;
}

struct Found {
  double eigenvalue = 0.0;  // [N/m]
  double share = 0.0;       // of what the motion would cost in bending
  NodalField motion;
};

// Lanczos' method, across motions that are orthonormal in the surface's metric. `hold`: gaps that press are
// held.
class Lanczos {
 public:
  Lanczos(RodSystem& system, const Configuration& configuration, bool hold = false)
      : system_(system), bending_(system.bendingMetric()), surface_(system.surfaceMetric()) {
    // H + c M positive definite
    constexpr double kFast = 1e-3, kMost = 1e12;
    shift_ = neutralShift(system);
    while (system.factorise(shift_, bending_, true) > 0 && shift_ < kMost) {
      shift_ *= shift_ < kFast ? 100.0 : 4.0;
      system.evaluate(configuration, RodSystem::Hessian::exact);
    }
    if (hold) held_.emplace(system);
  }

  bool leaveOut(NodalField field) {
    if (!addOrthonormal(system_, surface_, std::move(field), left_out_)) return false;
    left_out_weighted_.emplace_back();
    system_.applyMetric(surface_, left_out_.back(), left_out_weighted_.back());
    return true;
  }

  Found find(const NodalField* near);

 private:
  void project(NodalField& field) const {
    for (int twice = 0; twice < 2; ++twice) {
      for (std::size_t i = 0; i < left_out_.size(); ++i)
        field.addScaled(-field.dot(left_out_weighted_[i]), left_out_[i]);
    }
  }

  void solve(const NodalField& force, NodalField& response) const {
    system_.solve(force, response);
    if (held_) held_->hold(response);
  }

  RodSystem& system_;
  std::vector<RodSystem::Metric> bending_, surface_;
  double shift_ = 0.0;
  std::optional<HeldContacts> held_;
  std::vector<NodalField> left_out_, left_out_weighted_;
};

// For the largest eigenvalue of (H + c M)⁻¹ N, N the surface metric.
Found Lanczos::find(const NodalField* near) {
  constexpr int kSteps = 24;
  std::vector<NodalField> basis, weighted;
  Eigen::VectorXd diagonal(kSteps), off(kSteps);
  NodalField v;
  solve(deterministicField(system_), v);
  project(v);
  NodalField nv;
  system_.applyMetric(surface_, v, nv);
  double norm = std::sqrt(v.dot(nv));
  if (near != nullptr) {
    // with a little of everything, lest another motion has become the softest
    v.scale(kOfOthers / norm);
    v.addScaled(1.0, *near);
    project(v);
    system_.applyMetric(surface_, v, nv);
    norm = std::sqrt(v.dot(nv));
  }
  double value = 0.0;
  Eigen::VectorXd ritz;
  for (int k = 0; k < kSteps; ++k) {
    v.scale(1.0 / norm);
    nv.scale(1.0 / norm);
    basis.push_back(v);
    weighted.push_back(nv);
    NodalField w;
    solve(nv, w);
    project(w);
    diagonal[k] = w.dot(nv);
    for (int twice = 0; twice < 2; ++twice) {
      for (std::size_t j = 0; j < basis.size(); ++j) w.addScaled(-w.dot(weighted[j]), basis[j]);
    }
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
    solver.computeFromTridiagonal(diagonal.head(k + 1), off.head(k), Eigen::ComputeEigenvectors);
    const double previous = value;
    value = solver.eigenvalues()[k];
    ritz = solver.eigenvectors().col(k);
    if (k > 2 && std::abs(value - previous) <= 1e-9 * std::abs(value)) break;
    v = w;
    system_.applyMetric(surface_, v, nv);
    const double norm2 = v.dot(nv);
    norm = std::sqrt(std::max(norm2, 0.0));
    if (!(norm > 1e-12 * std::abs(value))) break;
    off[k] = norm;
  }
  Found found;
  found.motion = system_.zeroField();
  for (Eigen::Index k = 0; k < ritz.size(); ++k)
    found.motion.addScaled(ritz[k], basis[static_cast<std::size_t>(k)]);
  // the motion is N-normal: λ = 1/θ - c vᵀ M v
  NodalField stiffness;
  system_.applyMetric(bending_, found.motion, stiffness);
  const double in_bending = found.motion.dot(stiffness);
  found.eigenvalue = 1.0 / value - shift_ * in_bending;
  found.share = found.eigenvalue / in_bending;
  return found;
}

}  // namespace

SoftestMotion softestMotion(RodSystem& system, const Configuration& configuration, const NodalField* near) {
  SoftestMotion softest;
  const double rounding = system.stiffnessNoise();
  Found found = Lanczos(system, configuration).find(near);
  if (std::abs(found.share) < std::max(kSuspicious, kOfRounding * rounding)) {
    system.evaluate(configuration, RodSystem::Hessian::exact);
    softest.neutral = neutralMotions(system, configuration, std::max(kStrainless, kOfRounding * rounding));
    Lanczos others(system, configuration);
    for (const NeutralMotion& motion : softest.neutral)
      others.leaveOut(fieldOf(motion, system, configuration));
    if (!softest.neutral.empty()) found = others.find(nullptr);
    const double most = kOfSoftest * softestBending(system);
    while (std::abs(found.share) < std::max(kNone, kOfRounding * rounding) &&
           std::abs(found.eigenvalue) < most && softest.unnamed.size() < kMostUnnamed) {
      softest.unnamed.push_back(found.motion);
      if (!others.leaveOut(found.motion)) break;
      found = others.find(nullptr);
    }
  }
  softest.eigenvalue = found.eigenvalue;
  softest.motion = std::move(found.motion);
  return softest;
}

double smallestEigenvalueBeside(const SoftestMotion& of, RodSystem& system,
                                const Configuration& configuration) {
  Lanczos lanczos(system, configuration);
  for (const NeutralMotion& motion : of.neutral) lanczos.leaveOut(fieldOf(motion, system, configuration));
  for (std::size_t i = 0; i < of.unnamed.size(); ++i) lanczos.leaveOut(lanczos.find(nullptr).motion);
  return lanczos.find(nullptr).eigenvalue;
}

NodalField motionOfLeastStiffness(RodSystem& system, const Configuration& configuration) {
  return Lanczos(system, configuration).find(nullptr).motion;
}

double smallestEigenvalue(RodSystem& system, const Configuration& configuration, NodalField* motion,
                          const NodalField* near) {
  SoftestMotion softest = softestMotion(system, configuration, near);
  if (motion != nullptr) *motion = std::move(softest.motion);
  return softest.eigenvalue;
}

std::string neutralText(const SoftestMotion& softest, const RodSystem& system,
                        const Configuration& configuration) {
  std::string text;
  for (const NeutralMotion& motion : softest.neutral)
    text += (text.empty() ? "" : "; ") + describe(motion, system, configuration);
  if (!softest.unnamed.empty()) {
    text += (text.empty() ? "" : "; ");
    text += std::to_string(softest.unnamed.size()) +
            (softest.unnamed.size() == 1 ? " motion that costs" : " motions that cost") +
            " no more than rounding";
  }
  if (text.empty()) return text;
  return kNeutralNote + text;
}

double smallestEigenvalueInContact(RodSystem& system, const Configuration& configuration) {
  return Lanczos(system, configuration, true).find(nullptr).eigenvalue;
}

}  // namespace cable_variation
