#include <cable_variation/geometry/outer_surface.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cable_variation/geometry/body_union.h>
#include <cable_variation/geometry/filled_surface.h>
#include <cable_variation/geometry/marching_tetrahedra.h>
#include <cable_variation/math/thread_limit.h>

namespace cable_variation {
namespace {

constexpr double kFirstCells = 40.0;    // of the longest side, to learn the surface's area
constexpr int kTrials = 8;              // to reach the number of triangles
constexpr double kTriangleShare = 0.4;  // that the number may be off
constexpr double kOffCorner = 2e-3;     // of the surface from the grid's corners at least, of a cell
constexpr std::size_t kMostRegions = std::size_t{1} << 24;
const double kHalfDiagonal = 0.5 * std::sqrt(3.0);  // of a unit cube

using Bodies = std::vector<const RoundedHull*>;

// A cube of the grid's cells, and the bodies that can be the closest ones in it.
struct Region {
  std::array<std::int64_t, 3> first = {};
  std::int64_t size = 0;  // [cells]
  std::vector<BodyUnion::Near> near;
};

template <typename Function>
void forEach(std::size_t count, const Function& function) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) function(i);
  });
}

class Contourer {
 public:
  Contourer(const Bodies& bodies, const Box& cores, double cell)
      : cell_(cell), union_(bodies, radii(bodies, 0.0)), inflated_(bodies, radii(bodies, cell)) {
    const std::vector<double> inflated = radii(bodies, cell);
    const double border = *std::max_element(inflated.begin(), inflated.end()) + cell;
    origin_ = cores.low.matrix().array() - border;
    cells_ = std::ceil(((cores.high - cores.low).maxCoeff() + 2.0 * border) / cell);
  }

  struct Contour {
    TriangleMesh mesh;
    double excess = 0.0;
  };

  Contour contour() const {
    const std::vector<Region> blocks = regions();
    std::vector<ContourPart> parts(blocks.size());
    std::vector<double> excess(blocks.size(), 0.0);
    forEach(blocks.size(), [&](std::size_t i) {
      parts[i] = cable_variation::contour(block(blocks[i]), origin_, cell_);
      const Eigen::Vector3d middle = middleOf(blocks[i]);
      for (const Eigen::Vector3d& vertex : parts[i].vertices) {
        excess[i] = std::max(excess[i], union_.value(vertex, middle, blocks[i].near));
      }
    });
    return {joined(parts), excess.empty() ? 0.0 : *std::max_element(excess.begin(), excess.end())};
  }

 private:
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
  std::vector<Region> regions() const {
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
  Contourer::Contour contour;
  withThreads(options.threads, [&] {
    if (options.excess > 0.0) {
      surface.cell = cellFor(options.excess, smallest);
      contour = Contourer(bodies, cores, surface.cell).contour();
      return;
    }
    surface.cell = (cores.largestExtent() + 2.0 * largest) / kFirstCells;
    const auto wanted = static_cast<double>(options.triangles);
    for (int trial = 0; trial < kTrials; ++trial) {
      contour = Contourer(bodies, cores, surface.cell).contour();
      const auto triangles = static_cast<double>(contour.mesh.triangles.size());
      if (std::abs(triangles - wanted) <= kTriangleShare * wanted || trial + 1 == kTrials) return;
      surface.cell *= std::sqrt(triangles / wanted);
    }
  });
  FilledSurface filled = filledSurface(contour.mesh);
  surface.mesh = std::move(filled.mesh);
  surface.components = filled.components;
  surface.filled_voids = filled.filled_voids;
  surface.excess = contour.excess;
  return surface;
}

}  // namespace cable_variation
