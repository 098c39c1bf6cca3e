#pragma once

#include <Eigen/Core>

#include <cable_variation/tracking/stretch_shape.h>

namespace cable_variation {

/// The way that a snap takes, and how far along it shapes are: 0 at a reference, 1 a whole jump further.
/// Shapes far along it are few and far apart, so hulls over all of it would span space that none of them
/// takes: they are held in slices of it instead, that overlap a little.
class SnapWay {
 public:
  SnapWay() = default;  ///< no way: all shapes are in slice 0
  /// @param reference shape, at 0 @param motion of the jump, FollowedShape::Jump::motion()
  SnapWay(const Eigen::Matrix3Xd& reference, const Eigen::Matrix3Xd& motion);

  bool empty() const { return motion_.size() == 0; }
  double length() const { return motion_.norm(); }  ///< of the jump, all ends together [m]

  struct Progress {
    double at = 0.0;
    Eigen::VectorXd rates;  ///< by the coordinates; empty: not known
  };
  Progress of(const StretchShape& shape, Eigen::Index coordinates) const;

  struct Slices {
    int first = 0, last = 0;
    bool contain(int slice) const { return first <= slice && slice <= last; }
  };
  /// That a shape so far along is held in; slice 0 is all before the way gets rare.
  Slices slices(double at) const;

 private:
  Eigen::Matrix3Xd reference_, motion_;
};

}  // namespace cable_variation
