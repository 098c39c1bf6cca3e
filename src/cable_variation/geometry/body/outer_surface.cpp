#include <cable_variation/geometry/body/outer_surface.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cable_variation/geometry/body/body_union.h>
#include <cable_variation/geometry/mesh/filled_surface.h>
#include <cable_variation/geometry/mesh/marching_tetrahedra.h>
#include <cable_variation/util/thread_limit.h>

namespace cable_variation {
namespace {

constexpr double kFirstCells = 40.0;    // of the longest side, to learn the surface's area
constexpr int kTrials = 12;             // to reach the number of triangles, or the excess
constexpr double kTriangleShare = 0.4;  // that the number may be off
constexpr double kOffCorner = 2e-3;     // of the surface from the grid's corners at least, of a cell
constexpr std::size_t kMostRegions = std::size_t{1} << 24;
// Of a surface per area of a cube's face, and what one takes while it is made: measured.
constexpr double kTrianglesPerFace = 9.2, kBytesPerTriangle = 130.0;
constexpr double kTrianglesPerBlock = 80.0;             // about, where the surface passes through
constexpr double kFewBlocks = 64.0;                     // that any memory is enough for
constexpr double kFinerAtOnce = 0.3, kAsCoarse = 0.95;  // cubes, on the way to those wanted
constexpr double kCoarser = 1.25;                   // cubes, when a surface takes more memory than expected
const double kHalfDiagonal = 0.5 * std::sqrt(3.0);  // of a unit cube

using Bodies = std::vector<const RoundedHull*>;

// A cube of the grid's cells, and the bodies that can be the closest ones in it.
struct Region {
  std::array<std::int64_t, 3> first = {};
  std::int64_t size = 0;  // [cells]
  std::vector<BodyUnion::Near> near;
};

class Contourer {
 public:
  Contourer(const Bodies& bodies, const Box& cores, double cell, const OuterSurfaceOptions& options)
      : options_(options),
        cell_(cell),
        union_(bodies, radii(bodies, 0.0)),
        inflated_(bodies, radii(bodies, cell)) {
    const std::vector<double> inflated = radii(bodies, cell);
    const double border = *std::max_element(inflated.begin(), inflated.end()) + cell;
    origin_ = cores.low.matrix().array() - border;
    cells_ = std::ceil(((cores.high - cores.low).maxCoeff() + 2.0 * border) / cell);
  }

  struct Contour {
    TriangleMesh mesh;
    double excess = 0.0;
  };

  /// None: it would take more memory than allowed.
  std::optional<Contour> contour() const {
    const std::optional<std::vector<Region>> found = regions();
    if (!found) return std::nullopt;
    const std::vector<Region>& blocks = *found;
    std::vector<ContourPart> parts(blocks.size());
    std::vector<double> excess(blocks.size(), 0.0);
    forEach(blocks.size(), [&](std::size_t i) {
      parts[i] = cable_variation::contour(block(blocks[i]), origin_, cell_);
      const Eigen::Vector3d middle = middleOf(blocks[i]);
      for (const Eigen::Vector3d& vertex : parts[i].vertices) {
        excess[i] = std::max(excess[i], union_.value(vertex, middle, blocks[i].near));
      }
    });
    return Contour{joined(parts), excess.empty() ? 0.0 : *std::max_element(excess.begin(), excess.end())};
  }

 private:
  template <typename Function>
  void forEach(std::size_t count, const Function& function) const {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count), [&](const auto& range) {
      for (std::size_t i = range.begin(); i < range.end(); ++i) {
        if (options_.check) options_.check();
        function(i);
      }
    });
  }

  static std::vector<double> radii(const Bodies& bodies, double cell) {
    std::vector<double> radii;
    for (const RoundedHull* body : bodies) radii.push_back(std::hypot(body->radius, kHalfDiagonal * cell));
    return radii;
  }

  Eigen::Vector3d middleOf(const Region& region) const {
    Eigen::Vector3d middle = origin_;
    for (int axis = 0; axis < 3; ++axis) {
      middle[axis] += cell_ * (static_cast<double>(region.first[static_cast<std::size_t>(axis)]) +
                               0.5 * static_cast<double>(region.size));
    }
    return middle;
  }

  // Whether the surface can pass through; finds the region's bodies among those given.
  bool meetsSurface(Region& region, const std::vector<BodyUnion::Near>& given) const {
    const double edge = cell_ * static_cast<double>(region.size);
    region.near = inflated_.closestIn(middleOf(region), 0.5 * edge, given);
    return std::abs(region.near.front().value) <= kHalfDiagonal * edge + kOffCorner * cell_;
  }

  // All of a block's size that the surface passes through, by halving.
  std::optional<std::vector<Region>> regions() const {
    if (cells_ > static_cast<double>(GridBlock::kLargest)) {
      throw std::invalid_argument("outer surface: cubes of " + std::to_string(cell_) +
                                  " m are too small for the bodies; expected at most 2^20 along an axis");
    }
    Region whole;
    whole.size = GridBlock::kCubes;
    while (static_cast<double>(whole.size) < cells_) whole.size *= 2;
    std::vector<Region> regions;
    if (meetsSurface(whole, inflated_.all())) regions.push_back(std::move(whole));
    while (!regions.empty() && regions.front().size > GridBlock::kCubes) {
      std::vector<std::vector<Region>> children(regions.size());
      forEach(regions.size(), [&](std::size_t i) {
        for (int octant = 0; octant < 8; ++octant) {
          Region child;
          child.size = regions[i].size / 2;
          for (std::size_t axis = 0; axis < 3; ++axis) {
            child.first[axis] = regions[i].first[axis] + (octant >> axis & 1 ? child.size : 0);
          }
          if (meetsSurface(child, regions[i].near)) children[i].push_back(std::move(child));
        }
        regions[i].near = {};
      });
      regions.clear();
      for (auto& some : children) {
        std::move(some.begin(), some.end(), std::back_inserter(regions));
      }
      if (regions.size() > kMostRegions) {
        throw std::invalid_argument(
            "outer surface: cubes of " + std::to_string(cell_) +
            " m are too small for the bodies; expected at most 2^24 near the surface");
      }
      const double blocks = static_cast<double>(regions.size());
      if (blocks > kFewBlocks && kTrianglesPerBlock * kBytesPerTriangle * blocks > options_.memory_limit) {
        return std::nullopt;
      }
    }
    return regions;
  }

  GridBlock block(const Region& region) const {
    GridBlock block;
    block.first = region.first;
    const Eigen::Vector3d middle = middleOf(region);
    for (int z = 0; z < GridBlock::kPoints; ++z) {
      for (int y = 0; y < GridBlock::kPoints; ++y) {
        for (int x = 0; x < GridBlock::kPoints; ++x) {
          const Eigen::Vector3d point =
              origin_ + cell_ * Eigen::Vector3d(static_cast<double>(region.first[0] + x),
                                                static_cast<double>(region.first[1] + y),
                                                static_cast<double>(region.first[2] + z));
          double value = inflated_.value(point, middle, region.near);
          // Off the surface, to the inside: vertices then keep apart, and the surface can only grow.
          if (std::abs(value) < kOffCorner * cell_) value = -kOffCorner * cell_;
          block.values[GridBlock::at(x, y, z)] = value;
        }
      }
    }
    return block;
  }

  const OuterSurfaceOptions& options_;
  double cell_;
  BodyUnion union_, inflated_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  double cells_ = 0.0;  // along the longest side
};

void check(const Bodies& bodies, const OuterSurfaceOptions& options) {
  if (bodies.empty()) throw std::invalid_argument("outer surface of no bodies; expected one at least");
  for (const RoundedHull* body : bodies) {
    if (!(std::isfinite(body->radius) && body->radius >= 0.0)) {
      throw std::invalid_argument("outer surface: radius " + std::to_string(body->radius) +
                                  " m; expected 0 m at least");
    }
  }
  if (!(std::isfinite(options.excess) && options.excess >= 0.0)) {
    throw std::invalid_argument("outer surface: excess " + std::to_string(options.excess) +
                                " m; expected 0 m at least");
  }
  if (options.triangles == 0) throw std::invalid_argument("outer surface: 0 triangles; expected 1 at least");
  if (!(options.memory_limit > 0.0))
    throw std::invalid_argument("outer surface: memory of " + std::to_string(options.memory_limit) +
                                " B; expected more than 0 B");
}

// So that √(r² + 3h²/4) is r + excess for the thinnest body.
double cellFor(double excess, double smallest_radius) {
  return std::sqrt(excess * (2.0 * smallest_radius + excess)) / kHalfDiagonal;
}

}  // namespace

OuterSurface outerSurface(const Bodies& bodies, const OuterSurfaceOptions& options) {
  check(bodies, options);
  Box cores;
  double smallest = bodies.front()->radius, largest = 0.0;
  for (const RoundedHull* body : bodies) {
    for (const Eigen::Vector3d& vertex : body->core.surface().vertices) cores.add(vertex);
    smallest = std::min(smallest, body->radius);
    largest = std::max(largest, body->radius);
  }

  OuterSurface surface;
  std::optional<Contourer::Contour> contour;
  const auto make = [&] {
    contour.reset();  // before the next one takes its memory
    contour = Contourer(bodies, cores, surface.cell, options).contour();
    return contour.has_value();
  };
  const auto makeCoarserIfNeeded = [&] {
    while (!make()) {
      surface.coarsened = true;
      surface.cell *= kCoarser;
    }
  };
  withThreads(options.threads, [&] {
    surface.cell = (cores.largestExtent() + 2.0 * largest) / kFirstCells;
    const double fine = options.excess > 0.0 ? cellFor(options.excess, smallest) : 0.0;
    if (fine >= surface.cell || (fine > 0.0 && std::isinf(options.memory_limit))) {
      surface.cell = fine;
      makeCoarserIfNeeded();
      return;
    }
    // How fine it can be follows from the surface's area, and the area from what coarser cubes take.
    const double affordable = options.memory_limit / kBytesPerTriangle;
    const double wanted = std::min(static_cast<double>(options.triangles), affordable);
    for (int trial = 0; trial < kTrials; ++trial) {
      makeCoarserIfNeeded();
      const auto triangles = static_cast<double>(contour->mesh.triangles.size());
      double next = surface.cell * std::sqrt(triangles / wanted);
      bool done = std::abs(triangles - wanted) <= kTriangleShare * wanted;
      if (fine > 0.0) {
        const double finest = surface.cell * std::sqrt(triangles / affordable);
        next = std::max({fine, finest, kFinerAtOnce * surface.cell});
        done = next > fine ? next >= kAsCoarse * surface.cell : surface.cell == fine;
        if (done) surface.coarsened = surface.cell > fine;
      }
      if (done || trial + 1 == kTrials) return;
      surface.cell = next;
    }
  });
  if (options.check) options.check();
  FilledSurface filled = filledSurface(contour->mesh);
  surface.mesh = std::move(filled.mesh);
  surface.components = filled.components;
  surface.filled_voids = filled.filled_voids;
  surface.excess = contour->excess;
  return surface;
}

double outerSurfaceMemory(double area, double thinnest_radius, double excess) {
  const double cell = cellFor(excess, thinnest_radius);
  return kBytesPerTriangle * kTrianglesPerFace * area / (cell * cell);
}

double finestExcess(double area, double thinnest_radius, double memory) {
  const double squared_cell = kBytesPerTriangle * kTrianglesPerFace * area / memory;
  const double r = thinnest_radius;
  return std::sqrt(r * r + kHalfDiagonal * kHalfDiagonal * squared_cell) - r;
}

}  // namespace cable_variation
