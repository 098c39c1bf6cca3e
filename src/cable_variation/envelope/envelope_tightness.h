#pragma once  // internal to envelope/

#include <functional>
#include <optional>
#include <vector>

#include <cable_variation/envelope/envelope.h>
#include <cable_variation/geometry/mesh/box.h>
#include <cable_variation/tracking/stretch_shape.h>

namespace cable_variation {

/// Shape number `index` of a random sequence; none: it has no equilibrium. Called by several threads.
using ShapeDrawer = std::function<std::optional<StretchShape>(std::size_t index)>;

/// The volume of the pieces, seen from the world, beside that of the first `shapes` random shapes.
/// @param voxel edge [m]; 0: a sixth of the thinnest piece's radius. Larger where the voxels would take more
/// than `memory` [B]: Tightness::voxel tells
/// @param progress told now and then how many shapes are done, by any thread; may throw
Tightness tightnessOf(const std::vector<EnvelopePiece>& pieces, double voxel, std::size_t shapes,
                      double memory, const ShapeDrawer& draw,
                      const std::function<void(std::size_t)>& progress);

/// What the voxels of a box take, one set for each thread and two more [B].
double tightnessMemory(const Box& box, double voxel);

}  // namespace cable_variation
