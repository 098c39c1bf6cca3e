#pragma once

#include <string>
#include <vector>

#include <cable_variation/envelope/envelope.h>
#include <cable_variation/geometry/mesh/triangle_mesh.h>

namespace cable_variation {

struct EnvelopeUrdfOptions {
  std::string name = "envelope";     ///< of the robot and its link, and how the names of its files begin
  double probability = 0.0;          ///< share of production that it holds, told in a comment; 0: all
  std::string folder;                ///< address of the files' folder: package:// or file://
  std::size_t largest_pieces = 150;  ///< convex collision pieces; one per cable and branch at least
};

/// An envelope for planners: one link, whose frame is the envelope's.
struct EnvelopeUrdf {
  struct File {
    std::string name;
    std::string contents;
  };
  std::string text;          ///< of the URDF
  std::vector<File> meshes;  ///< binary STL, to be put into the folder; the first: the outer surface
  std::size_t pieces = 0;    ///< convex, each in a file of its own
  double excess = 0.0;       ///< largest distance found of a piece's surface from the envelope's pieces in it
                             ///< [m]
};

/// Collision geometry: convex polyhedra that together hold the frame's pieces, neighbouring stretches and
/// phases merged where there are too many; visual: the outer surface. Throws std::invalid_argument: no
/// pieces, another kind of folder, a name that is no file's, no piece allowed.
EnvelopeUrdf envelopeUrdf(const EnvelopeFrame& frame, const TriangleMesh& outer_surface,
                          const EnvelopeUrdfOptions& options);

}  // namespace cable_variation
