#pragma once  // internal to equilibrium/

#include <memory>

#include <cable_variation/equilibrium/discretisation/grid.h>
#include <cable_variation/equilibrium/discretisation/rod_system.h>
#include <cable_variation/equilibrium/discretisation/solve_tolerance.h>

namespace cable_variation {

/// A harness on a grid, and the shape it has there. Not movable: the systems refer to its members.
struct Problem {
  Harness harness;
  Topology topology;
  std::unique_ptr<RodSystem> system;
  std::unique_ptr<RodSystem> coarse;  ///< every pair of elements merged
  Configuration configuration;

  /// Throws std::invalid_argument (makeTopology()).
  explicit Problem(const Harness& of) : harness(of), topology(makeTopology(of)) {}
  /// A copy can be followed to another harness as the original can.
  Problem(const Problem& other)
      : harness(other.harness), topology(other.topology), configuration(other.configuration) {
    if (other.system) {
      setGrid(other.system->grid());
      system->takeContacts(*other.system);
      system->evaluate(configuration, RodSystem::Hessian::exact);
      system->factorise(neutralShift(*system), system->bendingMetric());
    }
  }
  Problem& operator=(const Problem&) = delete;

  void setGrid(const Grid& grid) {
    system = std::make_unique<RodSystem>(harness, topology, grid);
    coarse = std::make_unique<RodSystem>(harness, topology, coarsen(grid));
  }

  double length() const {
    double sum = 0.0;
    for (const Cable& cable : harness.cables) sum += cable.length;
    return sum;
  }
};

}  // namespace cable_variation
