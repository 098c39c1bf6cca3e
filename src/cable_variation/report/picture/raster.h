#pragma once  // internal to report/

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Core>

namespace cable_variation {

using Colour = std::array<std::uint8_t, 3>;  ///< red, green, blue

/// A corner of a triangle as it is drawn.
struct Corner {
  Eigen::Vector3d place;  ///< x, y [px], z towards the viewer [m], see Camera::project()
  double light = 1.0;     ///< that it reflects, 0 to 1
};

/// A picture of triangles of which the nearest one counts at every pixel.
class Raster {
 public:
  Raster(std::size_t width, std::size_t height);

  std::size_t width() const { return width_; }
  std::size_t height() const { return height_; }

  /// Light between the corners is interpolated. What lies outside the picture, or has no area or a corner
  /// that is not finite, leaves no pixel.
  void draw(const std::array<Corner, 3>& triangle, const Colour& colour);

  static constexpr float kNothing = -std::numeric_limits<float>::infinity();
  /// Towards the viewer [m]; kNothing: no triangle is there.
  float depth(std::size_t x, std::size_t y) const { return depth_[y * width_ + x]; }
  const Colour& colour(std::size_t x, std::size_t y) const { return colour_[y * width_ + x]; }

 private:
  std::size_t width_, height_;
  std::vector<float> depth_;
  std::vector<Colour> colour_;
};

}  // namespace cable_variation
