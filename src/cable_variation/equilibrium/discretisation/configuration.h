#pragma once  // internal to equilibrium/

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cable_variation/harness/topology.h>
#include <cable_variation/math/pose.h>

namespace cable_variation {

/// Where a station is, with the coordinates that describe it.
struct StationConfiguration {
  Pose pose;                                         ///< world
  double arc_length = 0.0;                           ///< [m]
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();  ///< of a clip: position in the clip's frame [m]
  Eigen::Vector3d rotation =
      Eigen::Vector3d::Zero();  ///< of a clip that holds a rotation: its rotation vector
  double hinge_angle = 0.0;     ///< of a hinge joint's child [rad]
};

/// Positions and orientations of a span's nodes, three per element and one
/// more; the first and the last are those of its stations.
struct SpanConfiguration {
  std::vector<Eigen::Vector3d> positions;
  std::vector<Eigen::Quaterniond> orientations;
};

/// A shape of the whole harness, an equilibrium or not.
struct Configuration {
  std::vector<StationConfiguration> stations;
  std::vector<SpanConfiguration> spans;
};

/// Per span the boundaries of its elements as fractions of its length, from 0
/// to 1; an even number of elements, neighbours in pairs of equal length.
using Grid = std::vector<std::vector<double>>;

/// Sets a clip's station from its coordinates, and child stations from their
/// parents, for all stations; a pose that no clip or joint decides is kept.
/// The spans' end nodes follow.
void placeStations(const Harness& harness, const Topology& topology, Configuration& configuration);

/// The largest arc length of its stations: the length of the longest cable [m].
double largestArcLength(const Configuration& configuration);

}  // namespace cable_variation
