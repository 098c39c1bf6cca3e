#pragma once  // internal to geometry/

#include <optional>

#include <cable_variation/geometry/mesh/surface_triangle.h>
#include <cable_variation/geometry/tube_distance/tube_section.h>

namespace cable_variation {

/// Where a section of a tube comes closest to a triangle.
struct SectionMinimum {
  double value = 0.0;  ///< distance less the radius [m]
  double u = 0.0;      ///< on the section
  NearestPoint nearest;
};

/// Distance of the section's place u to the triangle, less its radius [m].
SectionMinimum valueAt(const TubeSection& section, const SurfaceTriangle& triangle, double u);

/// The smallest value over the section, to 1e-9 m; none if it is `cutoff` or more.
///
/// Branch and bound. With p the triangle's point nearest to the curve's place c(u), and n the direction from
/// p to c(u), the triangle lies behind the plane through p with normal n: so the polynomial n·(c - p) - r
/// bounds the value from below all along. A local minimum makes that bound sharp.
std::optional<SectionMinimum> smallest(const TubeSection& section, const SurfaceTriangle& triangle,
                                       double cutoff);

}  // namespace cable_variation
