#include <cable_variation/envelope/envelope_tightness.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cable_variation/geometry/body/voxel_set.h>

namespace cable_variation {
namespace {

// Voxels are as large as this share of the thinnest piece's radius.
constexpr double kVoxel = 1.0 / 6.0;
constexpr double kCoarser = 1.1;  // voxels, where they would take too much memory

using VoxelSets = tbb::enumerable_thread_specific<VoxelSet>;

Box boxOf(const std::vector<EnvelopePiece>& pieces) {
  Box box;
  for (const EnvelopePiece& piece : pieces) {
    for (const Eigen::Vector3d& vertex : piece.body.core.surface().vertices) {
      box.add(vertex - Eigen::Vector3d::Constant(piece.body.radius));
      box.add(vertex + Eigen::Vector3d::Constant(piece.body.radius));
    }
  }
  return box;
}

// Held at once: one for each thread, an empty one and the union.
double voxelSets() { return static_cast<double>(tbb::this_task_arena::max_concurrency()) + 2.0; }

double volumeOf(const VoxelSets& sets, const VoxelSet& none) {
  VoxelSet all = none;
  for (const VoxelSet& set : sets) all.unite(set);
  return all.volume();
}

}  // namespace

Tightness tightnessOf(const std::vector<EnvelopePiece>& pieces, double voxel, std::size_t shapes,
                      double memory, const ShapeDrawer& draw,
                      const std::function<void(std::size_t)>& progress) {
  Tightness tightness;
  if (shapes == 0) return tightness;
  double thinnest = std::numeric_limits<double>::infinity();
  for (const EnvelopePiece& piece : pieces) thinnest = std::min(thinnest, piece.body.radius);
  tightness.voxel = voxel > 0.0 ? voxel : kVoxel * thinnest;
  const Box box = boxOf(pieces);
  const double most = std::min(memory, voxelSets() * static_cast<double>(VoxelSet::kMost) / 8.0);
  while (tightnessMemory(box, tightness.voxel) > most) tightness.voxel *= kCoarser;
  const VoxelSet none(box, tightness.voxel);
  VoxelSets of_pieces(none);
  tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t i) {
    progress(0);
    of_pieces.local().addBody(pieces[i].body);
  });
  tightness.envelope_volume = volumeOf(of_pieces, none);
  of_pieces.clear();

  VoxelSets of_shapes(none);
  std::atomic<std::size_t> done{0}, drawn{0};
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, shapes, 16), [&](const auto& range) {
    VoxelSet& own = of_shapes.local();
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      const std::optional<StretchShape> shape = draw(i);
      if (!shape) continue;
      for (std::size_t k = 0; k < shape->radius.size(); ++k) {
        own.addTube(shape->centreline(0, k), shape->radius[k]);
      }
      ++drawn;
    }
    done += range.size();
    progress(done);
  });
  tightness.shapes = drawn;
  tightness.shapes_volume = volumeOf(of_shapes, none);
  return tightness;
}

double tightnessMemory(const Box& box, double voxel) {
  constexpr double kBits = 64.0, kWord = 8.0;
  const Eigen::Array3d count = ((box.high - box.low) / voxel).ceil().max(1.0);
  return voxelSets() * kWord * std::ceil(count.x() / kBits) * count.y() * count.z();
}

}  // namespace cable_variation
