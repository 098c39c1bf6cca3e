#pragma once  // internal to equilibrium/

// What LaneSystem is made of; for its own sources only.

#include <algorithm>
#include <cmath>
#include <iterator>

#include <Eigen/Dense>

#include <cable_variation/equilibrium/discretisation/lane_system.h>

namespace cable_variation {

/// Six rows of a node: a force, or a motion.
struct alignas(64) NodeRows {
  double of[element::kNodeDofs][element::kLanes];
};

struct LaneSystem::Element {
  element::Input input;
  element::Energy energy;
  element::Factor factor;
  alignas(64) double rows[element::kDofs][element::kLanes];  ///< right-hand side, then motion
};

struct LaneSystem::SpanLanes {
  std::size_t first_element = 0;
  std::size_t count = 0;  ///< of elements
  element::ChainRole role;
  bool far_held = false;
  RodSystem::Metric metric;                           ///< of the shift that counts as none
  alignas(64) double gyration[element::kLanes]{};     ///< [m]
  element::Front<element::kLanes> front;              ///< of the elimination of the nodes between the ends
  std::vector<element::Link<element::kLanes>> links;  ///< one per node between, from the near end
  NodeRows near;                                      ///< right-hand side, then motion, of the near end
  std::vector<NodeRows> nodes;                        ///< likewise, of the nodes after it

  /// The element that is number j from the near end.
  std::size_t element(std::size_t j) const { return first_element + (role.reversed ? count - 1 - j : j); }
  NodeRows& node(std::size_t j) { return j == 0 ? near : nodes[j - 1]; }
  const NodeRows& node(std::size_t j) const { return j == 0 ? near : nodes[j - 1]; }
  /// The node at the element's left end (0) or right end (1), for element j from the near end.
  NodeRows& endOf(std::size_t j, int end) {
    return node(role.reversed ? j + (end == 0 ? 1 : 0) : j + (end == 0 ? 0 : 1));
  }
  const NodeRows& left() const { return node(role.reversed ? count : 0); }
  const NodeRows& right() const { return node(role.reversed ? 0 : count); }
  NodeRows& left() { return node(role.reversed ? count : 0); }
  NodeRows& right() { return node(role.reversed ? 0 : count); }
};

/// Of a cable, per lane: how far its force, its moment and its sections' normals move from the fine grid's
/// equilibrium to the merged one's, and what that is measured over; all but the stiffness squared.
struct alignas(64) LaneSystem::ForceChange {
  ForceChange() { std::fill(std::begin(softest), std::end(softest), INFINITY); }

  double force[element::kLanes]{}, moment[element::kLanes]{};  ///< at the spans' ends
  double tilt[element::kLanes]{};                              ///< [rad²]
  double largest_force[element::kLanes]{}, largest_moment[element::kLanes]{};
  double softest[element::kLanes];  ///< EI [N m²]
};

/// One harness: its numbers, and its stations.
struct LaneSystem::Lane {
  explicit Lane(const Problem& nominal) : harness(nominal.harness), unknowns(harness, nominal.topology) {
    configuration.stations = nominal.configuration.stations;
    configuration.spans.resize(nominal.configuration.spans.size());
    carried.setZero(6, static_cast<Eigen::Index>(configuration.stations.size()));
    gradient.setZero(unknowns.count());
    step.setZero(unknowns.count());
  }

  Harness harness;
  StationUnknowns unknowns;
  Configuration configuration;                       ///< stations only
  Eigen::Matrix<double, 6, Eigen::Dynamic> carried;  ///< motion of the stations from the nominal shape
  std::vector<std::vector<UnknownEffect>> effects;
  std::vector<StationUnknowns::Curvature> curvature;
  Eigen::VectorXd gradient;  ///< in the unknowns
  Eigen::VectorXd step;      ///< of the unknowns
  Eigen::MatrixXd matrix;
  Eigen::LDLT<Eigen::MatrixXd> factor;
};

}  // namespace cable_variation
