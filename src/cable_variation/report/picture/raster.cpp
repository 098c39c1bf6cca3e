#include <cable_variation/report/picture/raster.h>

#include <algorithm>
#include <cmath>

namespace cable_variation {

Raster::Raster(std::size_t width, std::size_t height)
    : width_(width), height_(height), depth_(width * height, kNothing), colour_(width * height) {}

void Raster::draw(const std::array<Corner, 3>& triangle, const Colour& colour) {
  const Eigen::Vector3d &a = triangle[0].place, &b = triangle[1].place, &c = triangle[2].place;
  const double area = (b.x() - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (b.y() - a.y());
  if (!std::isfinite(area + a.z() + b.z() + c.z()) || area == 0.0) return;
  // Pixels whose centres lie in the triangle's box.
  const auto from = [](double low) { return std::max(0.0, std::ceil(low - 0.5)); };
  const auto to = [](double high, std::size_t size) {
    return std::min(static_cast<double>(size) - 1.0, std::floor(high - 0.5));
  };
  const double left = from(std::min({a.x(), b.x(), c.x()})), top = from(std::min({a.y(), b.y(), c.y()}));
  const double right = to(std::max({a.x(), b.x(), c.x()}), width_);
  const double bottom = to(std::max({a.y(), b.y(), c.y()}), height_);
  for (double y = top; y <= bottom; ++y) {
    for (double x = left; x <= right; ++x) {
      const double px = x + 0.5, py = y + 0.5;
      // Shares of the corners: the areas opposite of them.
      const double u = ((b.x() - px) * (c.y() - py) - (c.x() - px) * (b.y() - py)) / area;
      const double v = ((c.x() - px) * (a.y() - py) - (a.x() - px) * (c.y() - py)) / area;
      const double w = 1.0 - u - v;
      if (u < 0.0 || v < 0.0 || w < 0.0) continue;
      const auto depth = static_cast<float>(u * a.z() + v * b.z() + w * c.z());
      const std::size_t pixel = static_cast<std::size_t>(y) * width_ + static_cast<std::size_t>(x);
      if (depth <= depth_[pixel]) continue;
      depth_[pixel] = depth;
      const double light = u * triangle[0].light + v * triangle[1].light + w * triangle[2].light;
      for (std::size_t k = 0; k < 3; ++k) {
        colour_[pixel][k] = static_cast<std::uint8_t>(std::lround(std::clamp(light * colour[k], 0.0, 255.0)));
      }
    }
  }
}

}  // namespace cable_variation
