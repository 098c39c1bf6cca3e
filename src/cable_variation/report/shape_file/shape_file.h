#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <cable_variation/measures/measure_evaluation.h>

namespace cable_variation {

// Solved cables as the content of files that other programs read. `cables` are indices, in the order they are
// to be in; coordinates are those of the scene's world. All throw std::invalid_argument for a step
// [m] that is not above 0, or so short that a cable would have more than a million points.

/// One row per section (RFC 4180, SI units in the titles): cable, arc length, position, quaternion of the
/// section's frame, force and moment of the part s+ on the part s-, curvature and radius.
std::string shapeCsv(const SolvedScene& solved, const std::vector<std::size_t>& cables, double step);

/// VTK polydata in the legacy text format, version 3.0 [m]: a polyline per cable; per point arc_length,
/// radius, curvature, tension, force and moment; per line its cable's index. ParaView's tube filter takes
/// "radius" as absolute scalar.
std::string shapeVtk(const SolvedScene& solved, const std::vector<std::size_t>& cables, double step);

/// A drawing (DXF of release 12) in millimetres: a 3D polyline per cable, each on a layer of its name.
/// Characters that release 12 has not in names become '_'; two names that become one are told apart by a
/// number.
std::string shapeDxf(const SolvedScene& solved, const std::vector<std::size_t>& cables, double step);

/// The surface of round cables as binary STL [m], each closed: a prism of twenty sides whose edges lie on
/// the surface, so inside it by up to 1.3 % of the radius; of
/// 2,000 rings at most.
std::string shapeStl(const SolvedScene& solved, const std::vector<std::size_t>& cables, double step);

}  // namespace cable_variation
