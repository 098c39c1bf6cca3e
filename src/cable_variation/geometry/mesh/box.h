#pragma once

#include <limits>

#include <Eigen/Core>

namespace cable_variation {

/// An axis-aligned box; empty until something is put in.
struct Box {
  Eigen::Array3d low = Eigen::Array3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Array3d high = Eigen::Array3d::Constant(-std::numeric_limits<double>::infinity());

  void add(const Eigen::Vector3d& point) {
    low = low.min(point.array());
    high = high.max(point.array());
  }
  void add(const Box& other) {
    low = low.min(other.low);
    high = high.max(other.high);
  }
  bool contains(const Eigen::Vector3d& point) const {
    return (point.array() >= low).all() && (point.array() <= high).all();
  }
  double largestExtent() const { return (high - low).maxCoeff(); }
};

/// Squared distance of two boxes; 0 where they overlap [m²].
inline double squaredGap(const Box& a, const Box& b) {
  return (a.low - b.high).max(b.low - a.high).max(0.0).matrix().squaredNorm();
}

inline double squaredGap(const Box& box, const Eigen::Vector3d& point) {
  return (box.low - point.array()).max(point.array() - box.high).max(0.0).matrix().squaredNorm();
}

}  // namespace cable_variation
