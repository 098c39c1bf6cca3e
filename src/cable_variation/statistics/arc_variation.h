#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace cable_variation {

/// Of a covariance: standard deviations along its principal directions, the largest first; columns, unit,
/// right-handed.
struct PrincipalAxes {
  Eigen::Vector3d sigma = Eigen::Vector3d::Zero();
  Eigen::Matrix3d directions = Eigen::Matrix3d::Identity();
};
PrincipalAxes principalAxes(const Eigen::Matrix3d& covariance);

/// How a section of a cable varies, its centreline's position [m, world].
struct SectionVariation {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< over n - 1 [m²]
  PrincipalAxes axes;                                    ///< 6σ is six times axes.sigma[0]
  /// Largest less smallest coordinate along the axes that ArcVariation was given.
  Eigen::Vector3d range = Eigen::Vector3d::Zero();
};

/// Collects the positions of a cable's sections, sample by sample: in constant memory, mergeable; the same
/// order of calls gives the same numbers bit for bit.
class ArcVariation {
 public:
  using Positions = Eigen::Matrix3Xd;

  /// @param sections their number
  /// @param frames of each section, columns unit vectors, along which the range is taken: best the principal
  /// directions of the first-order covariance. Empty: world x,
  /// y, z. Throws std::invalid_argument: another number of them.
  explicit ArcVariation(std::size_t sections, const std::vector<Eigen::Matrix3d>& frames = {});

  std::uint64_t count() const { return count_; }
  std::size_t sectionCount() const { return static_cast<std::size_t>(mean_.cols()); }

  /// @param positions one column per section [m, world]; std::invalid_argument: another number, or one that
  /// is not finite
  void add(const Positions& positions);
  /// @param later with the same sections and frames
  void merge(const ArcVariation& later);

  /// All that was collected, as numbers for another process, whose restore() makes of them the same again bit
  /// for bit.
  Eigen::VectorXd collected() const;
  /// @param collected by one of the same sections and frames; std::invalid_argument: another number of them
  void restore(const Eigen::VectorXd& collected);
  /// How many numbers collected() has.
  Eigen::Index collectedSize() const { return 1 + kPerSection * mean_.cols(); }

  /// One per section; without two samples the covariance is zero.
  std::vector<SectionVariation> variation() const;

 private:
  static constexpr Eigen::Index kPerSection = 15;  // numbers: mean, scatter, low, high

  std::uint64_t count_ = 0;
  Positions mean_;
  Eigen::Matrix<double, 6, Eigen::Dynamic> scatter_;  // sums of products about the mean: xx xy xz yy yz zz
  std::vector<Eigen::Matrix3d> frames_;               // transposed
  Positions low_, high_;                              // along the frames
};

}  // namespace cable_variation
