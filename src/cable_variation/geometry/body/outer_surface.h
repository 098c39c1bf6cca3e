#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include <cable_variation/geometry/body/convex_hull.h>
#include <cable_variation/geometry/mesh/triangle_mesh.h>

namespace cable_variation {

struct OuterSurfaceOptions {
  double excess = 0.0;            ///< of the surface over each body by itself [m]; 0: what `triangles` allow
  std::size_t triangles = 80000;  ///< wanted, to about 40 %, if no excess is
  std::size_t threads = 0;        ///< 0: as many as there are cores
  /// That the surface may take [B]. An excess that takes more is not kept to: see OuterSurface::coarsened.
  double memory_limit = std::numeric_limits<double>::infinity();
  std::function<void()> check;  ///< called now and then, by any thread; may throw, which ends the work
};

/// One closed, oriented manifold mesh per component of a union of bodies, that encloses all of them. Without
/// inner walls; voids that cannot be reached from outside are filled, with whatever floats in them.
struct OuterSurface {
  TriangleMesh mesh;
  double cell = 0.0;    ///< edge of the grid's cubes [m]
  double excess = 0.0;  ///< largest distance of a vertex from the bodies [m]: in the creases between bodies
                        ///< it is more than over each of them
  bool coarsened = false;  ///< the excess wanted would have taken more memory than allowed: the cubes are
                           ///< those that the memory is enough for
  std::size_t components = 0;
  std::size_t filled_voids = 0;
};

/// The union's distance is interpolated linearly within tetrahedra, six to a cube of edge h, and contoured
/// where it surely encloses. Let x lie within r of a convex core, y be the core's point closest to x, and λ
/// the weights of the tetrahedron's corners v at x. Then, since |·| and the square root are convex and
/// concave,
///   Σ λ d(v) <= Σ λ |v - y| <= √(Σ λ |v - y|²) = √(|x - y|² + Σ λ |v - x|²) <= √(r² + R²),
/// where R = √3 h / 2 is the circumradius, which the cube and its tetrahedra share. So bodies of the radius
/// √(r² + 3h²/4), interpolated, hold those of the radius r, and so does the interpolated union, which is
/// nowhere above that of the interpolated bodies.
/// The same result whatever the number of threads. Throws std::invalid_argument: no bodies, a radius or an
/// excess that is none, no triangles wanted, no memory allowed, a grid of more than 2^20 cubes along an axis
/// or 2^24 blocks of 4³ near the surface.
OuterSurface outerSurface(const std::vector<const RoundedHull*>& bodies,
                          const OuterSurfaceOptions& options = {});

/// What a surface of an area [m²] around bodies of at least this radius [m] takes with an excess [m], about
/// [B].
double outerSurfaceMemory(double area, double thinnest_radius, double excess);
/// The smallest excess [m] for which it takes no more than so much [B].
double finestExcess(double area, double thinnest_radius, double memory);

}  // namespace cable_variation
