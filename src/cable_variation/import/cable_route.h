#pragma once

#include <optional>
#include <vector>

#include <cable_variation/import/cable_paths.h>
#include <cable_variation/import/kbl_document.h>
#include <cable_variation/import/segment_curve.h>
#include <cable_variation/math/pose.h>

namespace cable_variation {

/// What is known of the segments of a harness.
struct SegmentShapes {
  std::vector<std::optional<SegmentCurve>> curves;  ///< sound ones alone
  std::vector<double> lengths;                      ///< [m]
};

/// The tangent at a segment's start or end, along it: that of its sound curve, else as the file says, else
/// from node to node.
Eigen::Vector3d endTangent(const KblDocument& document, const SegmentShapes& shapes, std::size_t segment,
                           bool end);

/// The way of one cable in the vehicle, with section frames along it: x is the tangent, and they turn about
/// it as little as possible (parallel transport), from the smallest rotation of the x axis at the start. In
/// this form the cable is free of torsion.
class CableRoute {
 public:
  /// A place of the cable where something is known of its way.
  struct Station {
    double arc_length = 0.0;            ///< along the cable [m]
    Eigen::Vector3d position, tangent;  ///< [m], of length 1
    Eigen::Quaterniond orientation;     ///< of the section frame
  };

  /// With stations at nodes, at the fixings' places and, as far as curves are sound, in between: about
  /// `spacing` [m] apart, or nearer where the way turns by more than a few degrees.
  CableRoute(const KblDocument& document, const SegmentShapes& shapes, const CablePath& path, double spacing);

  double length() const { return part_starts_.back(); }
  /// Arc length of the place before a part, or behind the last one [m].
  double partStart(std::size_t part) const { return part_starts_[part]; }
  const std::vector<Station>& stations() const { return stations_; }
  /// All segments have sound curves.
  bool isWhole() const { return whole_; }

  /// The pose of the section at the station nearest to `arc_length`.
  Pose frameAt(double arc_length) const;

 private:
  void add(double arc_length, const Eigen::Vector3d& position, const Eigen::Vector3d& tangent);

  std::vector<double> part_starts_;
  std::vector<Station> stations_;
  bool whole_ = true;
};

}  // namespace cable_variation
