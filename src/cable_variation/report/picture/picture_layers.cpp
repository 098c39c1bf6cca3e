#include <cable_variation/report/picture/picture_layers.h>

#include <algorithm>
#include <cmath>

namespace cable_variation {

using Eigen::Vector3d;

namespace {

constexpr double kHidden = 0.4;    // share of a cable's colour that shines through a part
constexpr double kTint = 0.35;     // of an envelope's
constexpr double kEdge = 0.45;     // what is left of a part's light at its edge
constexpr double kAmbient = 0.35;  // light from everywhere

double reflected(const Vector3d& normal, const Camera& camera) {
  const Vector3d light = camera.axes.transpose() * Vector3d(-0.35, 0.5, 0.8).normalized();
  const double length = normal.norm();
  if (!(length > 0.0)) return kAmbient;
  return kAmbient + (1.0 - kAmbient) * std::abs(normal.dot(light)) / length;
}

/// Whether the surface bends away or ends here: its depth jumps to a neighbour by more than a slope does.
bool isEdge(const Raster& raster, std::size_t x, std::size_t y) {
  constexpr float kJump = 1e-3F;  // [m]
  const float here = raster.depth(x, y);
  const auto jumps = [&](std::size_t x1, std::size_t y1, std::size_t x2, std::size_t y2) {
    const float a = raster.depth(x1, y1), b = raster.depth(x2, y2);
    if (a == Raster::kNothing || b == Raster::kNothing) return true;
    return std::abs(a + b - 2.0F * here) > kJump;  // 0 on a plane
  };
  if (x == 0 || y == 0 || x + 1 == raster.width() || y + 1 == raster.height()) return false;
  return jumps(x - 1, y, x + 1, y) || jumps(x, y - 1, x, y + 1);
}

struct Sum {
  double colour[3] = {0.0, 0.0, 0.0};
  double opacity = 0.0;
};

void add(const PictureLayers& layers, std::size_t x, std::size_t y, Sum& sum) {
  const float part = layers.parts.depth(x, y), cable = layers.cables.depth(x, y);
  double colour[3] = {0.0, 0.0, 0.0}, opacity = 0.0;
  const auto blend = [&](const Colour& other, double share) {  // over what is there
    for (std::size_t k = 0; k < 3; ++k) {
      colour[k] = share * other[k] + (1.0 - share) * opacity * colour[k];
    }
    opacity = share + (1.0 - share) * opacity;
    for (double& each : colour) each /= opacity;
  };
  if (part > Raster::kNothing) {
    blend(layers.parts.colour(x, y), 1.0);
    if (isEdge(layers.parts, x, y)) {
      for (double& each : colour) each *= kEdge;
    }
  }
  if (cable > Raster::kNothing) blend(layers.cables.colour(x, y), cable >= part ? 1.0 : kHidden);
  if (layers.envelope.depth(x, y) > part) blend(layers.envelope.colour(x, y), kTint);
  for (std::size_t k = 0; k < 3; ++k) sum.colour[k] += opacity * colour[k];
  sum.opacity += opacity;
}

}  // namespace

void Surface::draw(const Camera& camera, Raster& raster) const {
  std::vector<Vector3d> places;
  places.reserve(vertices.size());
  for (const Vector3d& vertex : vertices) places.push_back(camera.project(vertex));
  for (const auto& [a, b, c] : triangles) {
    std::array<Corner, 3> corners = {{{places[a], 1.0}, {places[b], 1.0}, {places[c], 1.0}}};
    if (normals.empty()) {
      const double light = reflected((vertices[b] - vertices[a]).cross(vertices[c] - vertices[a]), camera);
      for (Corner& corner : corners) corner.light = light;
    } else {
      corners[0].light = reflected(normals[a], camera);
      corners[1].light = reflected(normals[b], camera);
      corners[2].light = reflected(normals[c], camera);
    }
    raster.draw(corners, colour);
  }
}

Raster rasterFor(const Camera& camera) {
  return {static_cast<std::size_t>(camera.width), static_cast<std::size_t>(camera.height)};
}

Pixels composed(const PictureLayers& layers, std::size_t fine) {
  Pixels pixels;
  pixels.width = layers.parts.width() / fine;
  pixels.height = layers.parts.height() / fine;
  pixels.rgba.reserve(4 * pixels.width * pixels.height);
  const auto byte = [](double value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
  };
  for (std::size_t y = 0; y < pixels.height; ++y) {
    for (std::size_t x = 0; x < pixels.width; ++x) {
      Sum sum;
      for (std::size_t dy = 0; dy < fine; ++dy) {
        for (std::size_t dx = 0; dx < fine; ++dx) add(layers, fine * x + dx, fine * y + dy, sum);
      }
      for (const double each : sum.colour) {
        pixels.rgba.push_back(byte(sum.opacity > 0.0 ? each / sum.opacity : 0.0));
      }
      pixels.rgba.push_back(byte(255.0 * sum.opacity / static_cast<double>(fine * fine)));
    }
  }
  return pixels;
}

}  // namespace cable_variation
