#include <cable_variation/geometry/body/hull_facets.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include <Eigen/Geometry>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

#include <cable_variation/geometry/mesh/box.h>
#include <cable_variation/util/error.h>

namespace cable_variation {
namespace {

// One run of qhull, with what it says kept as text.
class Run {
 public:
  Run() : words_(open_memstream(&text_, &length_)) {
    if (words_ == nullptr) throw std::bad_alloc();
    qh_zero(&state, words_);
  }
  ~Run() {
    int left = 0, bytes_left = 0;
    state.NOerrexit = True;
    qh_freeqhull(&state, !qh_ALL);
    qh_memfreeshort(&state, &left, &bytes_left);
    std::fclose(words_);
    std::free(text_);
  }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  void hullOf(std::vector<double>& coordinates) {
    // Qt: triangles; Pp: no reports on precision
    char command[] = "qhull Qt Pp";
    const auto count = static_cast<int>(coordinates.size() / 3);
    if (qh_new_qhull(&state, 3, count, coordinates.data(), False, command, nullptr, words_) != 0) {
      std::fflush(words_);
      throw InternalError("convex hull of " + std::to_string(count) +
                          " points: " + std::string(text_, length_));
    }
  }

  qhT state;

 private:
  char* text_ = nullptr;
  std::size_t length_ = 0;
  std::FILE* words_;
};

// Coordinates about the middle and in units of the extent: qhull's tolerances go by the largest coordinate.
std::vector<double> centred(const std::vector<Eigen::Vector3d>& points) {
  Box box;
  for (const Eigen::Vector3d& point : points) box.add(point);
  const Eigen::Vector3d middle = 0.5 * (box.low + box.high).matrix();
  const double scale = box.largestExtent() > 0.0 ? 1.0 / box.largestExtent() : 1.0;
  std::vector<double> coordinates(3 * points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    Eigen::Vector3d::Map(&coordinates[3 * i]) = scale * (points[i] - middle);
  }
  return coordinates;
}

// Six times the volume that the surface encloses, in its scaled coordinates.
double enclosed(const HullFacets& facets, const std::vector<double>& coordinates) {
  const auto at = [&](std::uint32_t vertex) {
    return Eigen::Vector3d::Map(&coordinates[3 * facets.vertices[vertex]]);
  };
  double sum = 0.0;
  for (const auto& [a, b, c] : facets.triangles) sum += at(a).dot(at(b).cross(at(c)));
  return sum;
}

void turnAbout(HullFacets& facets) {
  for (auto& corners : facets.triangles) std::swap(corners[1], corners[2]);
}

struct HalfEdge {
  std::uint64_t key;  // smaller vertex, larger vertex
  std::uint32_t triangle, corner;
};

std::vector<std::array<std::uint32_t, 3>> neighboursOf(
    const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  std::vector<HalfEdge> edges;
  edges.reserve(3 * triangles.size());
  for (std::uint32_t triangle = 0; triangle < triangles.size(); ++triangle) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(triangles[triangle][i], triangles[triangle][(i + 1) % 3]);
      edges.push_back({static_cast<std::uint64_t>(low) << 32 | high, triangle, i});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const HalfEdge& a, const HalfEdge& b) {
    return a.key != b.key ? a.key < b.key : a.triangle < b.triangle;
  });
  std::vector<std::array<std::uint32_t, 3>> neighbours(triangles.size());
  for (std::size_t i = 0; i < edges.size(); i += 2) {
    const bool paired = i + 1 < edges.size() && edges[i].key == edges[i + 1].key &&
                        (i + 2 == edges.size() || edges[i + 2].key != edges[i].key);
    // Two triangles that run along an edge the same way have no common outside.
    if (!paired || triangles[edges[i].triangle][edges[i].corner] ==
                       triangles[edges[i + 1].triangle][edges[i + 1].corner]) {
      throw InternalError("convex hull: its facets do not close");
    }
    neighbours[edges[i].triangle][edges[i].corner] = edges[i + 1].triangle;
    neighbours[edges[i + 1].triangle][edges[i + 1].corner] = edges[i].triangle;
  }
  return neighbours;
}

}  // namespace

void checkHullPoints(const std::vector<Eigen::Vector3d>& points) {
  if (points.empty()) throw std::invalid_argument("convex hull of no points; expected one at least");
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite()) {
      throw std::invalid_argument("convex hull: point " + std::to_string(i) + " of " +
                                  std::to_string(points.size()) + " is not finite");
    }
  }
}

HullFacets hullFacets(const std::vector<Eigen::Vector3d>& points) {
  checkHullPoints(points);
  std::vector<double> coordinates = centred(points);
  Run run;
  run.hullOf(coordinates);

  // The names that qhull's loops expect.
  qhT* const qh = &run.state;
  facetT* facet;
  vertexT* vertex;
  vertexT** vertexp;
  HullFacets facets;
  std::vector<std::uint32_t> number(points.size(), 0);
  FORALLvertices { facets.vertices.push_back(static_cast<std::size_t>(qh_pointid(qh, vertex->point))); }
  std::sort(facets.vertices.begin(), facets.vertices.end());
  for (std::uint32_t i = 0; i < facets.vertices.size(); ++i) number[facets.vertices[i]] = i;
  FORALLfacets {
    std::array<std::uint32_t, 3> corners;
    std::size_t i = 0;
    FOREACHvertex_(facet->vertices) {
      corners.at(i++) = number[static_cast<std::size_t>(qh_pointid(qh, vertex->point))];
    }
    if (facet->toporient) std::swap(corners[1], corners[2]);
    facets.triangles.push_back(corners);
    facets.normals.emplace_back(Eigen::Vector3d::Map(facet->normal).normalized());
  }
  if (enclosed(facets, coordinates) < 0.0) turnAbout(facets);
  facets.neighbours = neighboursOf(facets.triangles);
  return facets;
}

}  // namespace cable_variation
