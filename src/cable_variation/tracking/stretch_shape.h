#pragma once

#include <vector>

#include <Eigen/Core>

#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/tolerances/sample_space.h>
#include <cable_variation/tracking/material_stretch.h>
#include <cable_variation/util/error.h>

namespace cable_variation {

/// The largest distance between columns of the same number [m], and that number.
struct LargestDistance {
  double distance = 0.0;
  Eigen::Index column = 0;
};
LargestDistance largestDistance(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b);

/// What an envelope needs of one solved sample: its stretches as seen from each frame.
struct StretchShape {
  SamplePlace place;
  /// Per frame and stretch: points whose hull holds the centreline there [m, in the frame].
  std::vector<std::vector<std::vector<Eigen::Vector3d>>> control;
  /// Per frame: both ends of each stretch, a column each [m, in the frame].
  std::vector<Eigen::Matrix3Xd> ends;
  std::vector<double> radius;  ///< per stretch, the largest [m]
  /// Per frame: how the ends change per coordinate of the SampleSpace: rows x y z and the radius, columns end
  /// by end, within an end coordinate by coordinate. Empty unless asked for.
  std::vector<Eigen::Matrix4Xf> rates;
  double discretisation_error = 0.0;  ///< [m]

  /// The rates of one end: 4 by coordinates.
  auto endRates(std::size_t frame, std::size_t end, Eigen::Index coordinates) const {
    return rates[frame].middleCols(static_cast<Eigen::Index>(end) * coordinates, coordinates);
  }
  /// Points on the centreline of a stretch, from its start to its end, at thirds of its pieces [m].
  std::vector<Eigen::Vector3d> centreline(std::size_t frame, std::size_t stretch) const;
  /// Where the ends, seen from the world, would be after a change of the coordinates, to first order.
  Eigen::Matrix3Xd predicted(const Eigen::VectorXd& change) const;
};

/// Thrown of a solved shape that has other stations than the stretches: its points are not comparable.
class OtherStations : public InternalError {
 public:
  OtherStations() : InternalError("the shape has other stations") {}
};

/// Reads the stretches off solved samples.
class StretchReader {
 public:
  /// @param frames components, "world" first; all must outlive the reader
  StretchReader(const SampleSpace& space, const std::vector<MaterialStretch>& stretches,
                const std::vector<std::string>& frames)
      : space_(&space), stretches_(&stretches), frames_(&frames) {}

  const SampleSpace& space() const { return *space_; }
  const std::vector<MaterialStretch>& stretches() const { return *stretches_; }
  const std::vector<std::string>& frames() const { return *frames_; }

  /// Throws OtherStations.
  StretchShape read(const SamplePlace& place, const Harness& harness, const Equilibrium& equilibrium) const;
  /// With derivatives. `solver` has the equilibrium.
  StretchShape readWithRates(const SamplePlace& place, const Harness& harness, const Equilibrium& equilibrium,
                             EquilibriumSolver& solver) const;

 private:
  StretchShape read(const SamplePlace& place, const Equilibrium& equilibrium,
                    const std::vector<CableView>& views, const ComponentPoses& components) const;

  const SampleSpace* space_;
  const std::vector<MaterialStretch>* stretches_;
  const std::vector<std::string>* frames_;
};

}  // namespace cable_variation
