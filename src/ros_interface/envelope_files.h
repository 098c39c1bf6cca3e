#pragma once

#include <string>
#include <utility>
#include <vector>

#include <cable_variation/geometry/outer_surface.h>
#include <cable_variation/variation/envelope.h>
#include <ros_interface/output_directory.h>

namespace cable_variation_ros {

/// An envelope's files, not written yet.
struct EnvelopeFiles {
  std::string mesh;       ///< path of NAME.stl: the outer surface, binary
  std::string urdf;       ///< of NAME.urdf: convex pieces to collide with, NAME_*.stl
  std::string region;     ///< of NAME.obj: the pieces themselves, see CheckForbiddenRegion
  double rounding = 0.0;  ///< of the coordinates in the STL files [m]
  std::vector<std::pair<std::string, std::string>> contents;  ///< path and contents, in order
};

/// Throws as OutputDirectory::pathOf().
EnvelopeFiles envelopeFiles(const OutputDirectory& output, const std::string& name,
                            const cable_variation::Scene& scene, const cable_variation::Envelope& envelope,
                            const cable_variation::OuterSurface& surface);

/// Writes them, each complete or not at all, in place of older ones. Throws as OutputDirectory::make() and
/// cable_variation::writeFile().
void write(const EnvelopeFiles& files, const OutputDirectory& output);

}  // namespace cable_variation_ros
