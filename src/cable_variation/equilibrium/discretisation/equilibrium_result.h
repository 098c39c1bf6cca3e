#pragma once  // internal to equilibrium/

#include <array>
#include <functional>

#include <cable_variation/equilibrium/discretisation/rod_system.h>
#include <cable_variation/equilibrium/equilibrium.h>

namespace cable_variation {

/// The solved cables, from a system that holds the gradient at `configuration`.
std::vector<CableShape> describeShapes(const Harness& harness, const Topology& topology,
                                       const RodSystem& system, const Configuration& configuration);

/// A section at an element boundary: its pose, and RodSystem::sectionForce().
struct Boundary {
  Pose pose;
  Vector6d section_force;
};
/// One solved cable, from what is at its spans' element boundaries: at(span, boundary).
CableShape describeCable(const Harness& harness, const Topology& topology, const Grid& grid,
                         const std::vector<StationConfiguration>& stations, std::size_t cable,
                         const std::function<Boundary(std::size_t, std::size_t)>& at);

/// `arc_length` of a span's end moved inside it, so that at a step of the section it is on the span's side
/// [m].
double insideSpan(double arc_length, double start, double length);

/// The configuration on another grid, its nodes taken from the shapes: their
/// points are the most accurate that a grid gives, better than the elements'
/// own polynomials.
Configuration onGrid(const Topology& topology, const Configuration& configuration,
                     const std::vector<CableShape>& shapes, const Grid& grid);

/// A force and a moment, in the world.
struct Wrench {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();

  Wrench& operator+=(const Wrench& other) {
    force += other.force;
    moment += other.moment;
    return *this;
  }
};

/// What each station needs from outside: what its spans' ends need, less the loads
/// there, plus what the children that hang on it need.
/// @param span_ends per span: what its left and right end need
/// @param loads per station
std::vector<Wrench> stationWrenches(const Topology& topology,
                                    const std::vector<std::array<Wrench, 2>>& span_ends,
                                    const std::vector<Wrench>& loads);

/// Fills the reactions of `result`. @param end_force per span, RodSystem::endForce()
void describeReactions(const Harness& harness, const Topology& topology,
                       const std::vector<StationConfiguration>& stations,
                       const std::vector<std::array<Vector6d, 2>>& end_force, Equilibrium& result);

/// Fills reactions, energy and residual of `result` from a solved system, which
/// must hold the gradient at `configuration`.
void describe(const Harness& harness, const Topology& topology, const RodSystem& system,
              const Configuration& configuration, Equilibrium& result);

/// The largest distance between two shapes of one harness, at equal arc length [m].
double largestDistance(const Grid& grid_a, const Configuration& a, const Grid& grid_b,
                       const Configuration& b);

/// The held places of a cable that are further apart than it can reach; empty
/// when there are none. A cable that must stretch by more than `stretch` cannot reach.
std::string unreachable(const Harness& harness, const Topology& topology, const Configuration& configuration,
                        double stretch);

/// Why a descent that ended in `configuration` may have failed: a sliding clip
/// that has come to the end of its room, else the piece of cable furthest from balance.
std::string whereItFailed(const Harness& harness, const Topology& topology, const RodSystem& system,
                          const Configuration& configuration);

}  // namespace cable_variation
