#pragma once  // internal to report/

#include <vector>

#include <cable_variation/geometry/mesh/triangle_mesh.h>
#include <cable_variation/report/picture/camera.h>
#include <cable_variation/report/picture/png.h>
#include <cable_variation/report/picture/raster.h>

namespace cable_variation {

/// Triangles of one colour in the world [m].
struct Surface {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Eigen::Vector3d> normals;  ///< one per vertex; none: flat triangles
  Colour colour{};

  /// Lit from where the viewer stands, a little from above and the left, both sides alike.
  void draw(const Camera& camera, Raster& raster) const;
};

/// A raster of a camera's size.
Raster rasterFor(const Camera& camera);

/// What a picture is put together of, all of one size.
struct PictureLayers {
  Raster parts, cables, envelope;
};

/// Cables before parts are opaque, those behind shine through; an envelope tints what is behind it; edges of
/// parts, where the depth jumps, are dark lines. Every `fine` × `fine` pixels become one, which has the share
/// of them where something is as its opacity.
Pixels composed(const PictureLayers& layers, std::size_t fine);

}  // namespace cable_variation
