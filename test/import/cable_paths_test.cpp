// Which segments are one cable, and what hangs on what.
#include <cable_variation/import/cable_paths.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;

// A straight segment between nodes that are at these points.
SegmentGraph::Edge edge(const std::vector<Vector3d>& nodes, std::size_t a, std::size_t b, double thickness) {
  const Vector3d way = (nodes[b] - nodes[a]).normalized();
  return {a, b, thickness, way, way};
}

SegmentGraph graphOf(const std::vector<Vector3d>& nodes, const std::vector<std::array<std::size_t, 2>>& ends,
                     const std::vector<double>& thickness) {
  SegmentGraph graph;
  graph.nodes = nodes.size();
  for (std::size_t i = 0; i < ends.size(); ++i)
    graph.edges.push_back(edge(nodes, ends[i][0], ends[i][1], thickness[i]));
  return graph;
}

const std::vector<Vector3d> kStar{{0, 0, 0}, {-1, 0, 0}, {1, 0.1, 0}, {0, 1, 0}, {0, -1, 0}};

TEST(CablePaths, theThickestPairRunsOn) {
  // the way along x is straight, but thin
  const CablePaths paths = cablePaths(graphOf(kStar, {{1, 0}, {0, 2}, {3, 0}, {0, 4}}, {2, 2, 8, 9}));
  ASSERT_EQ(paths.paths.size(), 3U);
  std::size_t through = 0;
  for (std::size_t i = 0; i < paths.paths.size(); ++i) {
    if (paths.paths[i].parts.size() == 2) through = i;
  }
  EXPECT_EQ(paths.paths[through].parts[0].segment, 2U);
  EXPECT_EQ(paths.paths[through].parts[1].segment, 3U);
  ASSERT_EQ(paths.joints.size(), 2U);
  for (const PathJoint& joint : paths.joints) {
    EXPECT_EQ(joint.node, 0U);
    EXPECT_EQ(joint.parent, through);
    EXPECT_EQ(joint.parent_before, 1U);
  }
  EXPECT_TRUE(paths.joints[0].child_end);  // segment 0 ends there
  EXPECT_FALSE(paths.joints[1].child_end);
}

TEST(CablePaths, ofEqualThicknessTheStraightestRunsOn) {
  const CablePaths paths = cablePaths(graphOf(kStar, {{1, 0}, {0, 2}, {0, 3}}, {5, 5, 5}));
  ASSERT_EQ(paths.paths.size(), 2U);
  EXPECT_EQ(paths.paths[0].parts.size(), 2U);
  EXPECT_EQ(paths.paths[0].parts[1].segment, 1U);
}

TEST(CablePaths, nothingRunsOnAroundASharpCorner) {
  const std::vector<Vector3d> nodes{{0, 0, 0}, {1, 0.1, 0}, {1, -0.1, 0}};
  const CablePaths paths = cablePaths(graphOf(nodes, {{1, 0}, {0, 2}}, {5, 7}));
  ASSERT_EQ(paths.paths.size(), 2U);
  ASSERT_EQ(paths.joints.size(), 1U);
  EXPECT_EQ(paths.paths[paths.joints[0].parent].parts[0].segment, 1U);  // the thicker one
}

TEST(CablePaths, segmentsOfAnyDirectionMakeOneCable) {
  const std::vector<Vector3d> nodes{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  const CablePaths paths = cablePaths(graphOf(nodes, {{1, 0}, {1, 2}, {3, 2}}, {1, 1, 1}));
  ASSERT_EQ(paths.paths.size(), 1U);
  ASSERT_EQ(paths.paths[0].parts.size(), 3U);
  EXPECT_TRUE(paths.joints.empty());
  EXPECT_TRUE(paths.paths[0].parts[0].reversed);
  EXPECT_FALSE(paths.paths[0].parts[1].reversed);
  EXPECT_TRUE(paths.paths[0].parts[2].reversed);
}

TEST(CablePaths, aRingIsTwoCablesAtLeast) {
  std::vector<Vector3d> nodes;
  std::vector<std::array<std::size_t, 2>> ends;
  for (std::size_t i = 0; i < 12; ++i) {
    const double angle = 2 * M_PI * static_cast<double>(i) / 12;
    nodes.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    ends.push_back({i, (i + 1) % 12});
  }
  const SegmentGraph graph = graphOf(nodes, ends, std::vector<double>(12, 5.0));
  const CablePaths paths = cablePaths(graph);
  EXPECT_EQ(paths.paths.size(), 2U);
  EXPECT_EQ(paths.joints.size(), 2U);
  for (const PathJoint& joint : paths.joints) EXPECT_NE(joint.parent, joint.child);
  EXPECT_EQ(closingSegments(graph), std::vector<std::size_t>{11});
  EXPECT_EQ(ringOf(graph, 11).size(), 12U);
}

TEST(CablePaths, partsThatNothingJoins) {
  const std::vector<Vector3d> nodes{{0, 0, 0}, {1, 0, 0}, {5, 0, 0}, {6, 0, 0}, {7, 0, 0}};
  const SegmentGraph graph = graphOf(nodes, {{0, 1}, {2, 3}, {3, 4}}, {1, 1, 1});
  const std::vector<std::vector<std::size_t>> parts = connectedSegments(graph);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[1], (std::vector<std::size_t>{1, 2}));
  EXPECT_TRUE(closingSegments(graph).empty());
}

// Whatever the graph: each segment is in one cable, a cable's segments meet end to end, and at each node all
// cables that end there hang on one that does not, or on one of them.
TEST(CablePaths, holdForRandomGraphs) {
  std::mt19937 random(7);
  for (int round = 0; round < 300; ++round) {
    const std::size_t count = 2 + random() % 12;
    std::vector<Vector3d> nodes;
    for (std::size_t i = 0; i < count; ++i)
      nodes.emplace_back(Vector3d(random() % 100, random() % 100, random() % 100));
    SegmentGraph graph;
    graph.nodes = count;
    const std::size_t segments = 1 + random() % 25;
    while (graph.edges.size() < segments) {
      const std::size_t a = random() % count, b = random() % count;
      if (a == b || nodes[a] == nodes[b]) continue;
      graph.edges.push_back(edge(nodes, a, b, 1.0 + random() % 4));
    }
    const CablePaths paths = cablePaths(graph);
    std::set<std::size_t> seen;
    std::vector<std::size_t> cable_ends(count, 0), at_node(count, 0), joined(count, 0);
    for (const SegmentGraph::Edge& one : graph.edges) {
      ++at_node[one.start_node];
      ++at_node[one.end_node];
    }
    for (const CablePath& path : paths.paths) {
      std::size_t last = 0;
      for (std::size_t k = 0; k < path.parts.size(); ++k) {
        const auto [segment, reversed] = path.parts[k];
        EXPECT_TRUE(seen.insert(segment).second);
        const SegmentGraph::Edge& one = graph.edges[segment];
        const std::size_t from = reversed ? one.end_node : one.start_node;
        if (k == 0) ++cable_ends[from];
        if (k > 0) {
          EXPECT_EQ(from, last);
        }
        last = reversed ? one.start_node : one.end_node;
      }
      ++cable_ends[last];
      const auto [segment, reversed] = path.parts.front();
      EXPECT_NE(last, reversed ? graph.edges[segment].end_node : graph.edges[segment].start_node);
    }
    EXPECT_EQ(seen.size(), segments);
    for (const PathJoint& joint : paths.joints) {
      EXPECT_NE(joint.parent, joint.child);
      ++joined[joint.node];
    }
    for (std::size_t node = 0; node < count; ++node) {
      if (at_node[node] == 0) continue;
      const bool passed = cable_ends[node] < at_node[node];
      EXPECT_EQ(joined[node], cable_ends[node] - (passed ? 0 : 1))
          << "node " << node << " of round " << round;
    }
  }
}

}  // namespace
}  // namespace cable_variation
