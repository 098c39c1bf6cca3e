#include <cable_variation/variation/arc_variation.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace cable_variation {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

// Adds weight times the products of each column with itself.
void addProducts(const ArcVariation::Positions& columns, double weight,
                 Eigen::Matrix<double, 6, Eigen::Dynamic>& sums) {
  for (Index i = 0; i < columns.cols(); ++i) {
    const double x = columns(0, i), y = columns(1, i), z = columns(2, i);
    sums(0, i) += weight * x * x;
    sums(1, i) += weight * x * y;
    sums(2, i) += weight * x * z;
    sums(3, i) += weight * y * y;
    sums(4, i) += weight * y * z;
    sums(5, i) += weight * z * z;
  }
}

}  // namespace

PrincipalAxes principalAxes(const Matrix3d& covariance) {
  const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(covariance);  // in increasing order
  PrincipalAxes axes;
  axes.sigma = eigen.eigenvalues().reverse().cwiseMax(0.0).cwiseSqrt();
  axes.directions.col(0) = eigen.eigenvectors().col(2);
  axes.directions.col(1) = eigen.eigenvectors().col(1);
  axes.directions.col(2) = axes.directions.col(0).cross(axes.directions.col(1));
  return axes;
}

ArcVariation::ArcVariation(std::size_t sections, const std::vector<Matrix3d>& frames) {
  if (!frames.empty() && frames.size() != sections) {
    throw std::invalid_argument(std::to_string(frames.size()) + " frames for the variation of " +
                                std::to_string(sections) + " sections; expected one each");
  }
  for (const Matrix3d& frame : frames) frames_.push_back(frame.transpose());
  const auto size = static_cast<Index>(sections);
  mean_ = Positions::Zero(3, size);
  scatter_.setZero(6, size);
  low_ = Positions::Constant(3, size, std::numeric_limits<double>::infinity());
  high_ = -low_;
}

void ArcVariation::add(const Positions& positions) {
  if (positions.cols() != mean_.cols() || !positions.allFinite()) {
    throw std::invalid_argument("positions of " + std::to_string(positions.cols()) +
                                " sections; expected finite ones of " + std::to_string(mean_.cols()));
  }
  ++count_;
  const auto n = static_cast<double>(count_);
  const Positions step = positions - mean_;
  mean_ += step / n;
  addProducts(step, (n - 1.0) / n, scatter_);
  const Positions along = alongFrames(positions);
  low_ = low_.cwiseMin(along);
  high_ = high_.cwiseMax(along);
}

void ArcVariation::merge(const ArcVariation& later) {
  if (later.mean_.cols() != mean_.cols()) {
    throw std::invalid_argument("variation of " + std::to_string(later.sectionCount()) +
                                " sections; expected " + std::to_string(sectionCount()));
  }
  if (later.count_ == 0) return;
  const double before = static_cast<double>(count_), added = static_cast<double>(later.count_);
  count_ += later.count_;
  const Positions step = later.mean_ - mean_;
  mean_ += step * (added / (before + added));
  scatter_ += later.scatter_;
  addProducts(step, before * added / (before + added), scatter_);
  low_ = low_.cwiseMin(later.low_);
  high_ = high_.cwiseMax(later.high_);
}

ArcVariation::Positions ArcVariation::alongFrames(const Positions& positions) const {
  if (frames_.empty()) return positions;
  Positions along(3, positions.cols());
  for (Index i = 0; i < positions.cols(); ++i) {
    along.col(i).noalias() = frames_[static_cast<std::size_t>(i)] * positions.col(i);
  }
  return along;
}

std::vector<SectionVariation> ArcVariation::variation() const {
  std::vector<SectionVariation> result(sectionCount());
  if (count_ == 0) return result;
  for (std::size_t s = 0; s < result.size(); ++s) {
    const auto i = static_cast<Index>(s);
    SectionVariation& section = result[s];
    section.mean = mean_.col(i);
    section.range = high_.col(i) - low_.col(i);
    if (count_ < 2) continue;
    const auto sums = scatter_.col(i);
    section.covariance << sums[0], sums[1], sums[2], sums[1], sums[3], sums[4], sums[2], sums[4], sums[5];
    section.covariance /= static_cast<double>(count_ - 1);
    section.axes = principalAxes(section.covariance);
  }
  return result;
}

}  // namespace cable_variation
