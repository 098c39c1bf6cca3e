#pragma once

#include <string>
#include <utility>
#include <vector>

#include <cable_variation/envelope/envelope.h>
#include <cable_variation/geometry/body/outer_surface.h>
#include <cable_variation/analysis/output_directory.h>

namespace cable_variation {

/// An envelope's files.
struct EnvelopeFiles {
  // Paths; empty: it could not be written.
  std::string mesh;       ///< NAME.stl: the outer surface, binary
  std::string urdf;       ///< NAME.urdf: convex pieces to collide with, NAME_*.stl
  std::string region;     ///< NAME.obj: the pieces themselves, see CheckForbiddenRegion
  std::string report;     ///< NAME.html
  double rounding = 0.0;  ///< of the coordinates in the STL files [m]

  using Contents = std::vector<std::pair<std::string, std::string>>;        ///< path and contents
  Contents mesh_contents, urdf_contents, region_contents, report_contents;  ///< in the order to write them
  std::string error;  ///< what went wrong in writing, and with which file; empty: nothing
};

/// @param report the page
/// Throws as OutputDirectory::pathOf().
EnvelopeFiles envelopeFiles(const OutputDirectory& output, const std::string& name, const Scene& scene,
                            const Envelope& envelope, const OuterSurface& surface, const std::string& report);

/// Writes them, in place of older ones: each complete or not at all, the URDF together with the pieces it
/// names. What cannot be written loses its path, and `error` tells of it; the others are written.
void write(EnvelopeFiles& files, const OutputDirectory& output);

}  // namespace cable_variation
