#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <cable_variation/harness/harness.h>

namespace cable_variation {

/// A section of a cable where something happens: an end, a clip, a joint, a
/// load, or a step of its properties.
struct Station {
  std::size_t cable = 0;
  double arc_length = 0.0;            ///< [m]; of a sliding clip, where it starts
  std::optional<std::size_t> clip;    ///< the clip that holds it
  std::optional<std::size_t> joint;   ///< the joint whose child it is
  std::optional<std::size_t> parent;  ///< the station that joint hangs it on
  std::vector<std::size_t> loads;
};

/// A piece of cable between two neighbouring stations.
struct Span {
  std::size_t cable = 0;
  std::size_t left = 0;   ///< station at the smaller arc length
  std::size_t right = 0;  ///< station at the larger one
};

inline constexpr std::size_t kNoStation = static_cast<std::size_t>(-1);

/// Which stations and spans a harness has, and how they are connected.
struct Topology {
  std::vector<Station> stations;
  std::vector<Span> spans;
  std::vector<std::vector<std::size_t>> cable_stations;  ///< per cable, by arc length
  std::vector<std::vector<std::size_t>> cable_spans;     ///< per cable, by arc length
  std::vector<std::size_t> clip_station;                 ///< per clip; kNoStation: it is not attached
  std::vector<std::size_t> joint_child, joint_parent;    ///< per joint
  std::vector<std::size_t> order;                        ///< stations, each after the one it hangs on
};

/// Throws std::invalid_argument as validate() does, and when a sliding clip
/// starts where something else is.
Topology makeTopology(const Harness& harness);

/// Whether two harnesses have the same stations, connected alike: then they
/// differ in numbers only.
bool sameStructure(const Harness& a, const Topology& of_a, const Harness& b, const Topology& of_b);

/// The arc lengths [m] of `harness`, station by station as in the topology of `nominal`, without a topology
/// of its own; of a sliding clip, where its search starts. Nothing when the harness is of another structure.
/// That it is valid otherwise is not looked at.
std::optional<std::vector<double>> stationArcLengths(const Harness& nominal, const Topology& topology,
                                                     const Harness& harness);

}  // namespace cable_variation
