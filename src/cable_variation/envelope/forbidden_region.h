#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <cable_variation/envelope/envelope.h>
#include <cable_variation/geometry/body/convex_hull.h>
#include <cable_variation/geometry/tube_distance/distance.h>

namespace cable_variation {

/// An envelope kept as a region that no part may enter: what is needed of it, without its scene.
struct ForbiddenRegion {
  struct Piece {
    std::string cable;
    double start = 0.0, end = 0.0;  ///< nominal arc lengths [m]
    double from = 0.0, to = 0.0;    ///< times of its phase [s]
    std::size_t branch = 0;         ///< of equilibria, see EnvelopePiece
    RoundedHull body;
  };
  std::string frame = "world";  ///< that the vertices are in: the world or a component
  double inflation = 0.0;       ///< in every radius [m]
  double probability = 0.0;     ///< share of production that the envelope holds; 0: all within the tolerances
  std::size_t shapes = 0;       ///< independent random shapes that the envelope was verified with
  double protrusion = 0.0;      ///< the most that one of them stuck out before inflation [m]
  std::vector<Piece> pieces;
};

/// The envelope as seen from one of its frames. Throws std::invalid_argument for a frame it is not seen from.
ForbiddenRegion forbiddenRegion(const Scene& scene, const Envelope& envelope,
                                const std::string& frame = "world");

/// As a Wavefront OBJ file that other tools open: an object per piece, its core's vertices [m] and facets.
/// The object's name is `cable=NAME;s=START..END;t=FROM..TO;branch=N;r=RADIUS`, NAME with %XX for all but
/// letters, digits, '_', '-' and '.'; what is forbidden is all within r of an object. The rest stands in
/// comments at the beginning. Numbers are written so that they are read back bit by bit.
std::string regionText(const ForbiddenRegion& region);

/// Reads what regionText() has written; lines that other tools add (g, s, vn, vt, usemtl, mtllib, comments)
/// are passed over. @param source the file's name, for messages. Throws std::invalid_argument with file and
/// line: another format or version, what is missing or no number, facets of other vertices, pieces fewer or
/// more than announced.
ForbiddenRegion parseRegion(const std::string& text, const std::string& source);
/// From a file; FileError that names it when it cannot be read.
ForbiddenRegion readRegion(const std::string& path);

/// A part against the region.
struct RegionClearance {
  double distance = 0.0;  ///< between the surfaces [m]; negative: overlap, geometry/body_distance.h
  std::size_t piece = 0;  ///< of the region, the closest
  Eigen::Vector3d on_region, on_part;    ///< closest points of the surfaces [m], region's frame
  std::vector<std::uint32_t> colliding;  ///< triangles of the part's mesh that enter the region
  bool undecided = false;                ///< BodyPair::undecided
};

/// @param pose of the part in the region's frame. Throws std::invalid_argument: a region without pieces, a
/// pose that is not finite.
RegionClearance checkRegion(const ForbiddenRegion& region, const DistancePart& part, const Pose& pose);

}  // namespace cable_variation
