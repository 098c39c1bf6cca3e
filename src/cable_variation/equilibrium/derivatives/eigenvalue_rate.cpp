#include <cable_variation/equilibrium/derivatives/eigenvalue_rate.h>

#include <cmath>

#include <cable_variation/equilibrium/derivatives/equilibrium_rate.h>
#include <cable_variation/equilibrium/search/smallest_eigenvalue.h>

namespace cable_variation {

EigenvalueRate::EigenvalueRate(const Problem& problem) : problem_(problem), aside_(problem) {
  RodSystem& system = *aside_.system;
  system.evaluate(aside_.configuration, RodSystem::Hessian::exact);
  const double eigenvalue = smallestEigenvalue(system, aside_.configuration, &mode_);
  // The quotient's derivative is as good as the motion: inverse iteration next to the eigenvalue sharpens it.
  constexpr double kBeside = 1e-4;
  system.evaluate(aside_.configuration, RodSystem::Hessian::exact);
  system.factorise(-(1.0 - kBeside) * eigenvalue, system.surfaceMetric(), true);
  for (int twice = 0; twice < 2; ++twice) {
    NodalField weighted, sharper;
    system.applyMetric(system.surfaceMetric(), mode_, weighted);
    system.solve(weighted, sharper);
    sharper.scale(1.0 / std::sqrt(sharper.dot(sharper)));
    mode_ = sharper;
  }
}

double EigenvalueRate::quotientAt(double step, const HarnessRate& variable, const HarnessChange& change,
                                  const HarnessResponse& response) {
  aside_.harness = changed(problem_.harness, variable, step);
  aside_.configuration = problem_.configuration;
  for (std::size_t i = 0; i < aside_.topology.stations.size(); ++i) {
    const double moved = step * change.arc_lengths[static_cast<Eigen::Index>(i)];
    aside_.topology.stations[i].arc_length = problem_.topology.stations[i].arc_length + moved;
    aside_.configuration.stations[i].arc_length += moved;
  }
  placeStations(aside_.harness, aside_.topology, aside_.configuration);
  aside_.system->harnessChanged();
  NodalField motion = response.motion;
  motion.scale(step);
  aside_.system->move(motion, aside_.configuration);
  aside_.system->evaluate(aside_.configuration, RodSystem::Hessian::exact);
  aside_.system->carryEnds(mode_);
  const double stiffness = aside_.system->curvatureAlong(mode_);
  NodalField weighted;
  aside_.system->applyMetric(aside_.system->surfaceMetric(), mode_, weighted);
  return stiffness / mode_.dot(weighted);
}

double EigenvalueRate::of(const HarnessRate& variable, const HarnessChange& change,
                          const HarnessResponse& response) {
  constexpr double kTurn = 1e-3;  // that the nearer ones turn a section by, about [rad]
  const double size = sizeOf(change, response, problem_.length());
  if (size == 0.0) return 0.0;
  const double step = kTurn / size;
  const auto quotient = [&](double by) { return quotientAt(by, variable, change, response); };
  return (8.0 * (quotient(step) - quotient(-step)) - (quotient(2.0 * step) - quotient(-2.0 * step))) /
         (12.0 * step);
}

}  // namespace cable_variation
