#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include <cable_variation/measures/cable_view.h>

namespace cable_variation {

/// A stretch of a cable's material: between two shares of the piece of cable between two stations (ends,
/// clips, joints, loads, steps), so that it names the same material whatever the lengths.
struct MaterialStretch {
  std::size_t cable = 0;          ///< index into Harness::cables
  std::size_t interval = 0;       ///< between stations, from the cable's start
  double from = 0.0, to = 1.0;    ///< shares of it
  double start = 0.0, end = 0.0;  ///< nominal arc lengths [m]
};

/// A solved cable by the intervals between its stations.
class StationIntervals {
 public:
  /// The view must outlive it.
  explicit StationIntervals(const CableView& view);

  std::size_t size() const { return first_.size() - 1; }
  double start(std::size_t interval) const;  ///< [m]
  double end(std::size_t interval) const;    ///< [m]
  Place at(std::size_t interval, double share) const;

  /// Bézier points of the stretch's curve, six per piece of it.
  void appendControlPoints(const MaterialStretch& stretch, std::vector<Eigen::Vector3d>& points) const;
  /// The largest radius along the stretch [m].
  double largestRadius(const MaterialStretch& stretch) const;

 private:
  const CableView* view_;
  std::vector<std::size_t> first_;  // piece of each interval, and the end
};

/// Where a stretch of a cable's material is to end.
struct MaterialCut {
  std::size_t cable = 0;    ///< index into Harness::cables
  double arc_length = 0.0;  ///< nominal [m]
};

/// All of a solved cable, cut so that no stretch is longer than `longest` [m] or crosses a point of the
/// shape or one of the cuts that are of this cable.
std::vector<MaterialStretch> cutIntoStretches(std::size_t cable, const CableView& view, double longest,
                                              const std::vector<MaterialCut>& cuts = {});

}  // namespace cable_variation
