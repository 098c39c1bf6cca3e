#include <cable_variation/equilibrium/search/smallest_eigenvalue.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Eigenvalues>

#include <cable_variation/equilibrium/discretisation/held_contacts.h>
#include <cable_variation/equilibrium/search/minimise.h>

namespace cable_variation {
namespace {

// Beside a motion to start from, which is of norm 1.
constexpr double kOfOthers = 1e-3;

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

// Lanczos' method. `hold`: gaps that press are held.
double smallest(RodSystem& system, const Configuration& configuration, NodalField* motion,
                const NodalField* near, bool hold) {
  constexpr int kSteps = 24;
  const auto bending = system.bendingMetric();
  const auto surface = system.surfaceMetric();
  // H + c M positive definite; Lanczos for the largest eigenvalue of (H + c M)⁻¹ N, N the surface metric.
  double shift = neutralShift(system);
  while (system.factorise(shift, bending, true) > 0 && shift < 1e12) {
    shift = std::max(1e-2, 4.0 * shift);
    system.evaluate(configuration, RodSystem::Hessian::exact);
  }
  const std::optional<HeldContacts> held = hold ? std::make_optional<HeldContacts>(system) : std::nullopt;
  const auto solve = [&](const NodalField& force, NodalField& response) {
    system.solve(force, response);
    if (held) held->hold(response);
  };
  std::vector<NodalField> basis, weighted;
  Eigen::VectorXd diagonal(kSteps), off(kSteps);
  NodalField v;
  solve(deterministicField(system), v);
  NodalField nv;
  system.applyMetric(surface, v, nv);
  double norm = std::sqrt(v.dot(nv));
  if (near != nullptr) {
    // with a little of everything, lest another motion has become the softest
    v.scale(kOfOthers / norm);
    v.addScaled(1.0, *near);
    system.applyMetric(surface, v, nv);
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
    system.applyMetric(surface, v, nv);
    const double norm2 = v.dot(nv);
    norm = std::sqrt(std::max(norm2, 0.0));
    if (!(norm > 1e-12 * std::abs(value))) break;
    off[k] = norm;
  }
  NodalField mode = system.zeroField();
  for (Eigen::Index k = 0; k < ritz.size(); ++k) mode.addScaled(ritz[k], basis[static_cast<std::size_t>(k)]);
  // mode is N-normal: λ = 1/θ - c modeᵀ M mode
  NodalField shifted;
  system.applyMetric(bending, mode, shifted);
  const double eigenvalue = 1.0 / value - shift * mode.dot(shifted);
  if (motion != nullptr) *motion = mode;
  return eigenvalue;
}

}  // namespace

double smallestEigenvalue(RodSystem& system, const Configuration& configuration, NodalField* motion,
                          const NodalField* near) {
  return smallest(system, configuration, motion, near, false);
}

double smallestEigenvalueInContact(RodSystem& system, const Configuration& configuration) {
  return smallest(system, configuration, nullptr, nullptr, true);
}

}  // namespace cable_variation
