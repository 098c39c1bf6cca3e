#pragma once  // internal to equilibrium/

#include <optional>
#include <vector>

#include <Eigen/Core>

#include <cable_variation/math/pose.h>
#include <cable_variation/rod/profile.h>

namespace cable_variation {

/// A held place that a guide curve passes.
struct GuideAnchor {
  double arc_length = 0.0;  ///< [m]
  Eigen::Vector3d position;
  std::optional<Eigen::Vector3d> tangent;         ///< where a direction is held
  std::optional<Eigen::Quaterniond> orientation;  ///< where the roll is held too
};

/// A framed curve, sampled finely enough to interpolate linearly.
class GuideCurve {
 public:
  /// A cubic Bézier curve from `a` to `b` whose length is the arc length
  /// between them where that is possible. `bulge` pushes its middle aside; a zero
  /// vector lets the tangents decide.
  static GuideCurve between(const GuideAnchor& a, const GuideAnchor& b, const Eigen::Vector3d& bulge,
                            const Eigen::Vector3d& fallback_bulge);
  /// The cable free of stress from `pose` on, or backwards for a negative `length`.
  static GuideCurve free(const RodProfile& cable, double arc_length, const Pose& pose, double length);
  /// The cable free of stress at both ends, bent and shifted between them for it to come from `first` to `b`.
  static GuideCurve freeBetween(const RodProfile& cable, double arc_length, const Pose& first,
                                const GuideAnchor& b);

  /// Frames by parallel transport from `first`, turned about the tangent by
  /// `twist` [rad] in all, evenly.
  void frame(const Eigen::Quaterniond& first, double twist);
  /// The twist that frame() would need to end in `last`, in (-π, π].
  double twistTo(const Eigen::Quaterniond& first, const Eigen::Quaterniond& last) const;

  double start() const { return samples_.front().arc_length; }
  double end() const { return samples_.back().arc_length; }
  Pose at(double arc_length) const;

 private:
  struct Sample {
    double arc_length;
    Eigen::Vector3d position, tangent;
    Eigen::Quaterniond orientation;  // without the twist
  };
  std::vector<Sample> samples_;
  double twist_ = 0.0;  // in all, spread evenly [rad]
};

}  // namespace cable_variation
