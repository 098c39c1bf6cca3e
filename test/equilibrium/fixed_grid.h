#pragma once

#include <random>
#include <vector>

#include <cable_variation/equilibrium/discretisation/grid.h>
#include <cable_variation/equilibrium/search/initial_shape.h>
#include <cable_variation/equilibrium/search/minimise.h>

namespace cable_variation::test {

/// A harness on a grid of equal elements, with a shape to start from: what the
/// equilibrium solver works with, without its adaptation and multi-start.
struct FixedGrid {
  Harness harness;
  Topology topology;
  RodSystem system;
  Configuration configuration;

  FixedGrid(const Harness& of, std::size_t elements_per_span)
      : harness(of),
        topology(makeTopology(harness)),
        system(harness, topology, uniform(topology, elements_per_span)) {
    const InitialShape initial(harness, topology);
    configuration = initial.make(system.grid(), std::vector<Routing>(initial.intervals().size()));
  }
  FixedGrid(const FixedGrid&) = delete;
  FixedGrid& operator=(const FixedGrid&) = delete;

  static Grid uniform(const Topology& topology, std::size_t elements) {
    std::vector<double> boundaries;
    for (std::size_t i = 0; i <= elements; ++i) {
      boundaries.push_back(static_cast<double>(i) / static_cast<double>(elements));
    }
    return Grid(topology.spans.size(), boundaries);
  }

  /// A motion with every component random: displacements up to `shift` [m], turns up to `turn` [rad].
  NodalField randomMotion(std::mt19937& generator, double shift, double turn) {
    system.evaluate(configuration, RodSystem::Hessian::none);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    NodalField motion = system.zeroField();
    for (Eigen::Index i = 0; i < motion.unknowns.size(); ++i) motion.unknowns[i] = shift * uniform(generator);
    for (const auto& effects : system.unknowns().effects(configuration)) {
      for (const UnknownEffect& effect : effects) {
        if (effect.displacement.isZero(0.0)) motion.unknowns[effect.unknown] = turn * uniform(generator);
      }
    }
    for (auto& nodes : motion.spans) {
      for (Eigen::Index c = 1; c + 1 < nodes.cols(); ++c) {
        for (Eigen::Index r = 0; r < 6; ++r) nodes(r, c) = (r < 3 ? shift : turn) * uniform(generator);
      }
    }
    return motion;
  }
};

}  // namespace cable_variation::test
