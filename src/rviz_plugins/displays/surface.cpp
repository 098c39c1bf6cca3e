#include <rviz_plugins/displays/surface.h>

#include <cmath>

#include <Eigen/Geometry>

namespace cable_variation_rviz {

using Eigen::Vector3f;

namespace {

/// Unit directions at stations: that of the way from the station before to the one after.
std::vector<Vector3f> directionsOf(const std::vector<Vector3f>& line) {
  std::vector<Vector3f> directions(line.size(), Vector3f::UnitX());
  Vector3f last = Vector3f::UnitX();
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vector3f way = line[std::min(i + 1, line.size() - 1)] - line[i == 0 ? 0 : i - 1];
    const float length = way.norm();
    if (length > 0.0F) last = way / length;
    directions[i] = last;
  }
  return directions;
}

/// A ring of vertices around a station; `lean` tilts its normals along the tube.
void addRing(TubeSurface& tube, std::uint32_t station, const Vector3f& centre, float radius,
             const Vector3f& y, const Vector3f& z, std::uint32_t sides, const Vector3f* normal) {
  for (std::uint32_t k = 0; k < sides; ++k) {
    const float angle = 2.0F * static_cast<float>(M_PI) * static_cast<float>(k) / static_cast<float>(sides);
    const Vector3f out = std::cos(angle) * y + std::sin(angle) * z;
    tube.positions.emplace_back(centre + radius * out);
    tube.normals.push_back(normal != nullptr ? *normal : out);
    tube.stations.push_back(station);
  }
}

}  // namespace

TubeSurface tubeSurface(const std::vector<Vector3f>& line, const std::vector<float>& radii,
                        std::uint32_t sides) {
  TubeSurface tube;
  if (line.size() < 2) return tube;
  const std::vector<Vector3f> directions = directionsOf(line);
  // Rings are turned no more than the line turns: y is carried along by the smallest rotation.
  Vector3f y = directions.front().unitOrthogonal();
  const auto count = static_cast<std::uint32_t>(line.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    if (i > 0) y = Eigen::Quaternionf::FromTwoVectors(directions[i - 1], directions[i]) * y;
    y = (y - y.dot(directions[i]) * directions[i]).normalized();
    const Vector3f z = directions[i].cross(y);
    const bool first = i == 0, last = i + 1 == count;
    if (first) {
      const Vector3f back = -directions[i];
      addRing(tube, i, line[i], radii[i], y, z, sides, &back);
    }
    addRing(tube, i, line[i], radii[i], y, z, sides, nullptr);
    if (last) addRing(tube, i, line[i], radii[i], y, z, sides, &directions[i]);
  }
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    tube.triangles.insert(tube.triangles.end(), {a, b, c});
  };
  for (std::uint32_t i = 1; i < count; ++i) {  // ring 0 is the lid's
    for (std::uint32_t k = 0; k < sides; ++k) {
      const std::uint32_t next = (k + 1) % sides;
      const std::uint32_t a = i * sides + k, b = i * sides + next;
      add(a, b, a + sides);
      add(b, b + sides, a + sides);
    }
  }
  const std::uint32_t end = (count + 1) * sides;
  for (std::uint32_t k = 1; k + 1 < sides; ++k) {
    add(0, k + 1, k);
    add(end, end + k, end + k + 1);
  }
  return tube;
}

}  // namespace cable_variation_rviz
