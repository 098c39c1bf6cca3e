#include <cable_variation/geometry/body/voxel_set.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace cable_variation {
namespace {

constexpr std::uint64_t kFull = ~std::uint64_t{0};

// Bits of a word from `first` to `last`, counted from the line's beginning, that lie in word number `word`.
std::uint64_t mask(std::int64_t word, std::int64_t first, std::int64_t last) {
  const std::int64_t low = std::max<std::int64_t>(first - 64 * word, 0);
  const std::int64_t high = std::min<std::int64_t>(last - 64 * word, 63);
  return kFull << low & kFull >> (63 - high);
}

// Where a line along x meets a body: between low and high, if at all.
struct Interval {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

// A capsule's section with a line along x lies between the ends of those with its two balls and with its
// mantle.
class CapsuleLine {
 public:
  CapsuleLine(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius)
      : from_(from), to_(to), along_(to - from), squared_radius_(radius * radius) {
    squared_length_ = along_.squaredNorm();
    if (squared_length_ > 0.0) across_ = 1.0 - along_.x() * along_.x() / squared_length_;
  }

  Interval operator()(double y, double z) const {
    Interval interval;
    ball(from_, y, z, interval);
    ball(to_, y, z, interval);
    if (across_ > kParallel) mantle(y - from_.y(), z - from_.z(), interval);
    return interval;
  }

 private:
  static constexpr double kParallel = 1e-12;  // the balls' sections are all, then

  void ball(const Eigen::Vector3d& middle, double y, double z, Interval& interval) const {
    const double dy = y - middle.y(), dz = z - middle.z();
    const double squared = squared_radius_ - dy * dy - dz * dz;
    if (squared < 0.0) return;
    const double half = std::sqrt(squared);
    interval.add(middle.x() - half);
    interval.add(middle.x() + half);
  }

  // |p|² - (p · along)² / length² = radius² for p = (x, y, z) from the segment's beginning.
  void mantle(double y, double z, Interval& interval) const {
    const double offset = y * along_.y() + z * along_.z();
    const double half_sum = along_.x() * offset / squared_length_ / across_;
    const double product = (y * y + z * z - offset * offset / squared_length_ - squared_radius_) / across_;
    const double squared = half_sum * half_sum - product;
    if (squared < 0.0) return;
    const double half = std::sqrt(squared);
    for (const double x : {half_sum - half, half_sum + half}) {
      const double place = x * along_.x() + offset;
      if (place >= 0.0 && place <= squared_length_) interval.add(from_.x() + x);
    }
  }

  Eigen::Vector3d from_, to_, along_;
  double squared_radius_, squared_length_ = 0.0;
  double across_ = 0.0;  // squared share of the segment's direction at right angles to x
};

// The distance along the line is convex: Newton's method from outside comes to the body's border without
// passing it.
class BodyLine {
 public:
  BodyLine(const RoundedHull& body, const Box& box, double accuracy)
      : body_(body), box_(box), accuracy_(accuracy) {}

  Interval operator()(double y, double z) const {
    Interval interval;
    double low = box_.low.x(), high = box_.high.x();
    if (approach(low, y, z, 1.0) && approach(high, y, z, -1.0)) {
      interval.low = low;
      interval.high = high;
    }
    return interval;
  }

 private:
  bool approach(double& x, double y, double z, double direction) const {
    for (;;) {
      const Eigen::Vector3d point(x, y, z);
      const ConvexHull::Closest closest = body_.core.closest(point);
      const double gap = closest.distance - body_.radius;
      if (gap <= accuracy_) return true;
      // outside by a radius at least, so the direction is sure unless the radius is none
      const double slope = closest.distance > 0.0 ? (x - closest.point.x()) / closest.distance : 0.0;
      if (slope * direction >= 0.0) return false;
      x -= gap / slope;
      if (x < box_.low.x() || x > box_.high.x()) return false;
    }
  }

  const RoundedHull& body_;
  const Box& box_;
  double accuracy_;
};

}  // namespace

VoxelSet::VoxelSet(const Box& box, double edge) : origin_(box.low.matrix()), edge_(edge) {
  if (!(std::isfinite(edge) && edge > 0.0)) {
    throw std::invalid_argument("voxel edge " + std::to_string(edge) + " m; expected more than 0 m");
  }
  const Eigen::Array3d voxels = ((box.high - box.low) / edge).ceil();
  if (!(voxels >= 1.0).all() || !(voxels.prod() <= static_cast<double>(kMost))) {
    throw std::invalid_argument("voxels of " + std::to_string(edge) + " m in a box of " +
                                std::to_string(box.high.x() - box.low.x()) + " m × " +
                                std::to_string(box.high.y() - box.low.y()) + " m × " +
                                std::to_string(box.high.z() - box.low.z()) +
                                " m; expected a box with a volume, and at most 2^32 voxels");
  }
  for (std::size_t i = 0; i < 3; ++i) size_[i] = static_cast<std::size_t>(voxels[static_cast<int>(i)]);
  words_ = (size_[0] + 63) / 64;
  bits_.assign(words_ * size_[1] * size_[2], 0);
}

VoxelSet::Range VoxelSet::between(int axis, double low, double high) const {
  const auto last = static_cast<double>(size_[static_cast<std::size_t>(axis)]) - 1.0;
  Range range;
  range.first =
      static_cast<std::int64_t>(std::clamp(std::ceil((low - origin_[axis]) / edge_ - 0.5), 0.0, last + 1.0));
  range.last =
      static_cast<std::int64_t>(std::clamp(std::floor((high - origin_[axis]) / edge_ - 0.5), -1.0, last));
  return range;
}

Eigen::Vector3d VoxelSet::middle(std::size_t x, std::size_t y, std::size_t z) const {
  return origin_ + edge_ * Eigen::Vector3d(static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5,
                                           static_cast<double>(z) + 0.5);
}

template <class Line>
void VoxelSet::addLines(const Box& box, const Line& line) {
  const Range xs = between(0, box.low.x(), box.high.x());
  const Range ys = between(1, box.low.y(), box.high.y());
  const Range zs = between(2, box.low.z(), box.high.z());
  if (xs.first > xs.last) return;
  const std::int64_t first_word = xs.first / 64, last_word = xs.last / 64;
  for (std::int64_t z = zs.first; z <= zs.last; ++z) {
    for (std::int64_t y = ys.first; y <= ys.last; ++y) {
      std::uint64_t* const words =
          &bits_[words_ * (static_cast<std::size_t>(z) * size_[1] + static_cast<std::size_t>(y))];
      bool full = true;
      for (std::int64_t word = first_word; word <= last_word && full; ++word) {
        full = (~words[word] & mask(word, xs.first, xs.last)) == 0;
      }
      if (full) continue;
      const Interval interval = line(origin_.y() + edge_ * (static_cast<double>(y) + 0.5),
                                     origin_.z() + edge_ * (static_cast<double>(z) + 0.5));
      if (interval.low > interval.high) continue;
      const Range range = between(0, interval.low, interval.high);
      if (range.first > range.last) continue;
      for (std::int64_t word = range.first / 64; word <= range.last / 64; ++word) {
        words[word] |= mask(word, range.first, range.last);
      }
    }
  }
}

void VoxelSet::addCapsule(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius) {
  Box box;
  box.add(from);
  box.add(to);
  box.low -= radius;
  box.high += radius;
  addLines(box, CapsuleLine(from, to, radius));
}

void VoxelSet::addTube(const std::vector<Eigen::Vector3d>& centreline, double radius) {
  if (centreline.size() == 1) addCapsule(centreline.front(), centreline.front(), radius);
  for (std::size_t i = 1; i < centreline.size(); ++i) addCapsule(centreline[i - 1], centreline[i], radius);
}

void VoxelSet::addBody(const RoundedHull& body) {
  constexpr double kAccuracy = 1e-7;  // of the border, of a voxel
  Box box;
  for (const Eigen::Vector3d& vertex : body.core.surface().vertices) box.add(vertex);
  box.low -= body.radius;
  box.high += body.radius;
  addLines(box, BodyLine(body, box, kAccuracy * edge_));
}

void VoxelSet::unite(const VoxelSet& other) {
  if (other.size_ != size_ || other.origin_ != origin_ || other.edge_ != edge_) {
    throw std::invalid_argument("voxel sets to be united are on different grids");
  }
  for (std::size_t i = 0; i < bits_.size(); ++i) bits_[i] |= other.bits_[i];
}

std::uint64_t VoxelSet::count() const {
  std::uint64_t count = 0;
  for (std::uint64_t word : bits_) {
    // sums of neighbouring bits, of pairs, of fours, of bytes
    word -= word >> 1 & 0x5555555555555555;
    word = (word & 0x3333333333333333) + (word >> 2 & 0x3333333333333333);
    word = (word + (word >> 4)) & 0x0f0f0f0f0f0f0f0f;
    count += word * 0x0101010101010101 >> 56;
  }
  return count;
}

double VoxelSet::volume() const { return static_cast<double>(count()) * edge_ * edge_ * edge_; }

bool VoxelSet::contains(std::size_t x, std::size_t y, std::size_t z) const {
  return (bits_.at(words_ * (z * size_[1] + y) + x / 64) >> x % 64 & 1) != 0;
}

}  // namespace cable_variation
