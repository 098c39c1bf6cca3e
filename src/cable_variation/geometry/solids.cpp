#include <cable_variation/geometry/solids.h>

#include <algorithm>
#include <array>
#include <numeric>

#include <cable_variation/geometry/crossing_ray.h>

namespace cable_variation {
namespace {

// Numbers that are the same for vertices at the same position.
std::vector<std::uint32_t> positionNumbers(const std::vector<Eigen::Vector3d>& vertices) {
  std::vector<std::uint32_t> order(vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto before = [&](std::uint32_t i, std::uint32_t j) {
    const Eigen::Vector3d &a = vertices[i], &b = vertices[j];
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  };
  std::sort(order.begin(), order.end(), before);
  std::vector<std::uint32_t> number(vertices.size());
  std::uint32_t next = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0 && before(order[i - 1], order[i])) ++next;
    number[order[i]] = next;
  }
  return number;
}

struct Edge {
  std::uint32_t low, high;  // corners
  std::uint32_t triangle;
  bool forward;  // the triangle runs from low to high

  bool sameAs(const Edge& other) const { return low == other.low && high == other.high; }
};

class Groups {  // union-find
 public:
  explicit Groups(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }
  std::uint32_t of(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t i, std::uint32_t j) { parent_[of(i)] = of(j); }

 private:
  std::vector<std::uint32_t> parent_;
};

struct Group {
  bool closed = true, facing = true;  // facing: neighbours face the same way
  bool doubled = true;                // every triangle is there twice
};

// 0 for a triangle that is counted, 1 for one that is there again.
struct Copies {
  std::vector<std::uint8_t> again, twice;
};

Copies copies(const std::vector<std::array<std::uint32_t, 3>>& corners) {
  std::vector<std::array<std::uint32_t, 4>> sorted;
  sorted.reserve(corners.size());
  for (std::uint32_t i = 0; i < corners.size(); ++i) {
    std::array<std::uint32_t, 3> key = corners[i];
    std::sort(key.begin(), key.end());
    sorted.push_back({key[0], key[1], key[2], i});
  }
  std::sort(sorted.begin(), sorted.end());
  Copies found{std::vector<std::uint8_t>(corners.size(), 0), std::vector<std::uint8_t>(corners.size(), 0)};
  for (std::size_t i = 0, end; i < sorted.size(); i = end) {
    for (end = i + 1;
         end < sorted.size() && std::equal(sorted[i].begin(), sorted[i].begin() + 3, sorted[end].begin());
         ++end) {
      found.again[sorted[end][3]] = 1;
    }
    for (std::size_t k = i; k < end; ++k) found.twice[sorted[k][3]] = (end - i) % 2 == 0;
  }
  return found;
}

std::vector<Edge> edgesOf(const std::vector<std::array<std::uint32_t, 3>>& corners,
                          const std::vector<std::uint8_t>& left_out) {
  std::vector<Edge> edges;
  edges.reserve(3 * corners.size());
  for (std::uint32_t i = 0; i < corners.size(); ++i) {
    const auto& [a, b, c] = corners[i];
    if (left_out[i] || a == b || b == c || c == a) continue;  // a triangle without area bounds nothing
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      edges.push_back({std::min(from, to), std::max(from, to), i, from < to});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& x, const Edge& y) {
    return std::array{x.low, x.high, x.triangle} < std::array{y.low, y.high, y.triangle};
  });
  return edges;
}

// Calls visit(first, last) for the triangles at each edge.
template <typename Visit>
void forEachEdge(const std::vector<Edge>& edges, Visit&& visit) {
  for (std::size_t i = 0, end; i < edges.size(); i = end) {
    for (end = i + 1; end < edges.size() && edges[end].sameAs(edges[i]);) ++end;
    visit(edges.data() + i, edges.data() + end);
  }
}

double sixVolumes(const std::array<Eigen::Vector3d, 3>& triangle, const Eigen::Vector3d& origin) {
  const Eigen::Vector3d a = triangle[0] - origin, b = triangle[1] - origin, c = triangle[2] - origin;
  return a.x() * (b.y() * c.z() - b.z() * c.y()) + a.y() * (b.z() * c.x() - b.x() * c.z()) +
         a.z() * (b.x() * c.y() - b.y() * c.x());
}

}  // namespace

Solids::Solids(const TriangleMesh& mesh) {
  const std::vector<std::uint32_t> position = positionNumbers(mesh.vertices);
  const std::size_t triangles = mesh.triangles.size();
  corners.reserve(triangles);
  for (const auto& [a, b, c] : mesh.triangles) corners.push_back({position[a], position[b], position[c]});

  const Copies found = copies(corners);
  Groups groups(triangles);
  const auto join = [&](const std::vector<Edge>& edges) {
    forEachEdge(edges, [&](const Edge* first, const Edge* last) {
      for (const Edge* edge = first + 1; edge < last; ++edge) groups.join(first->triangle, edge->triangle);
    });
  };
  std::vector<std::uint8_t> left_out(triangles, 0);
  join(edgesOf(corners, left_out));

  std::vector<Group> group(triangles);  // at the number of each group
  for (std::uint32_t i = 0; i < triangles; ++i) {
    if (!found.twice[i]) group[groups.of(i)].doubled = false;
  }
  for (std::uint32_t i = 0; i < triangles; ++i) {
    left_out[i] = group[groups.of(i)].doubled && found.again[i];
  }
  std::vector<std::uint8_t> bounds(triangles, 0);
  forEachEdge(edgesOf(corners, left_out), [&](const Edge* first, const Edge* last) {
    Group& here = group[groups.of(first->triangle)];
    if ((last - first) % 2 != 0) here.closed = false;
    if (last - first != 2 || first->forward == (first + 1)->forward) here.facing = false;
    for (const Edge* edge = first; edge < last; ++edge) bounds[edge->triangle] = 1;
  });

  shell.assign(triangles, kOpen);
  std::vector<std::uint32_t> shell_of_group(triangles, kOpen);
  std::vector<double> volume;  // six times, positive: faces outwards
  std::vector<std::uint32_t> sample;
  std::vector<bool> facing;
  std::vector<std::vector<std::uint32_t>> members;
  for (std::uint32_t i = 0; i < triangles; ++i) {
    const std::uint32_t number = groups.of(i);
    if (!bounds[i] || !group[number].closed) continue;
    if (shell_of_group[number] == kOpen) {
      shell_of_group[number] = static_cast<std::uint32_t>(shells.size());
      shells.emplace_back();
      volume.push_back(0.0);
      facing.push_back(group[number].facing);
      members.emplace_back();
    }
    const std::uint32_t in = shell_of_group[number];
    shell[i] = in;
    members[in].push_back(i);
    for (const std::uint32_t vertex : mesh.triangles[i]) shells[in].box.add(mesh.vertices[vertex]);
  }
  const auto points = [&](std::uint32_t triangle) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    return std::array{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
  };
  for (std::size_t k = 0; k < shells.size(); ++k) {
    const Eigen::Vector3d origin = points(members[k].front())[0];
    for (const std::uint32_t i : members[k]) volume[k] += sixVolumes(points(i), origin);
  }

  // An inward shell belongs to the smallest outward one around it.
  std::vector<std::uint32_t> around(shells.size(), kOpen);
  for (std::size_t k = 0; k < shells.size(); ++k) {
    if (!(facing[k] && volume[k] < 0.0)) continue;
    const Eigen::Vector3d inside = points(members[k].front())[0];
    for (std::uint32_t outer = 0; outer < shells.size(); ++outer) {
      if (!(facing[outer] && volume[outer] > -volume[k]) || !shells[outer].box.contains(inside)) continue;
      if (around[k] != kOpen && volume[around[k]] < volume[outer]) continue;
      const bool within = oddCrossings(inside, [&](const CrossingRay& ray) {
        int crossings = 0;
        for (const std::uint32_t i : members[outer]) {
          const CrossingRay::Answer answer = ray.crosses(points(i), corners[i]);
          if (answer == CrossingRay::Answer::unclear) return CrossingRay::kUnclear;
          crossings += answer == CrossingRay::Answer::yes;
        }
        return crossings;
      });
      if (within) around[k] = outer;
    }
  }
  for (std::size_t k = 0; k < shells.size(); ++k) {
    if (around[k] == kOpen) shells[k].solid = count++;
  }
  for (std::size_t k = 0; k < shells.size(); ++k) {
    if (around[k] == kOpen) continue;
    shells[k].cavity = true;
    shells[k].solid = shells[around[k]].solid;
  }
}

}  // namespace cable_variation
