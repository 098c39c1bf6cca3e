#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace cable_variation {

/// Segments between nodes, as far as it matters which of them are one cable.
struct SegmentGraph {
  struct Edge {
    std::size_t start_node = 0, end_node = 0;
    double thickness = 0.0;         ///< [m]
    Eigen::Vector3d start_tangent;  ///< along the segment, of length 1
    Eigen::Vector3d end_tangent;
  };
  std::size_t nodes = 0;
  std::vector<Edge> edges;
};

/// Segments that make one cable, end to end.
struct CablePath {
  struct Part {
    std::size_t segment = 0;
    bool reversed = false;  ///< the cable runs from its end node to its start node
  };
  std::vector<Part> parts;
};

/// A cable's end that hangs on another cable.
struct PathJoint {
  std::size_t node = 0;
  std::size_t parent = 0;         ///< index of a path
  std::size_t parent_before = 0;  ///< the parent's parts up to the node: 0 at its start
  std::size_t child = 0;
  bool child_end = false;  ///< the child's end is there, not its start
};

struct CablePaths {
  std::vector<CablePath> paths;
  std::vector<PathJoint> joints;
};

/// Which segments run on into each other, and what hangs on what.
///
/// Where segments meet, two of them are one cable: those with the largest
/// min(d₁, d₂) (1 + cos θ)/2, the thickness of the thinner one and the angle by which the way turns from one
/// to the other. None are when each pair turns by more than a right angle. The other ones are children of
/// that cable there; where none runs on, of the thickest that ends there. No cable starts and ends at one
/// node: a ring becomes two cables at least.
CablePaths cablePaths(const SegmentGraph& graph);

/// The connected parts of a graph: segments of each, in the order of their first one.
std::vector<std::vector<std::size_t>> connectedSegments(const SegmentGraph& graph);

/// Segments that close a ring with those before them, one for each ring there is.
std::vector<std::size_t> closingSegments(const SegmentGraph& graph);

/// The ring that such a segment closes: itself and the way back along segments before it.
std::vector<std::size_t> ringOf(const SegmentGraph& graph, std::size_t closing);

}  // namespace cable_variation
