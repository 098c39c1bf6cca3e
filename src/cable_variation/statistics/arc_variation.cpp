#include <cable_variation/statistics/arc_variation.h>

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

// Adds weight times the products of the step with itself.
template <class Column>
void addProducts(const Vector3d& step, double weight, Column&& sums) {
  const Vector3d weighted = weight * step;
  sums[0] += weighted.x() * step.x();
  sums[1] += weighted.x() * step.y();
  sums[2] += weighted.x() * step.z();
  sums[3] += weighted.y() * step.y();
  sums[4] += weighted.y() * step.z();
  sums[5] += weighted.z() * step.z();
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
  const double share = 1.0 / static_cast<double>(count_);
  for (Index i = 0; i < positions.cols(); ++i) {
    const Vector3d position = positions.col(i), step = position - mean_.col(i);
    mean_.col(i) += share * step;
    addProducts(step, 1.0 - share, scatter_.col(i));
    const Vector3d along =
        frames_.empty() ? position : Vector3d(frames_[static_cast<std::size_t>(i)] * position);
    low_.col(i) = low_.col(i).cwiseMin(along);
    high_.col(i) = high_.col(i).cwiseMax(along);
  }
}

void ArcVariation::merge(const ArcVariation& later) {
  if (later.mean_.cols() != mean_.cols()) {
    throw std::invalid_argument("variation of " + std::to_string(later.sectionCount()) +
                                " sections; expected " + std::to_string(sectionCount()));
  }
  if (later.count_ == 0) return;
  const double before = static_cast<double>(count_), added = static_cast<double>(later.count_);
  count_ += later.count_;
  const double share = added / (before + added);
  for (Index i = 0; i < mean_.cols(); ++i) {
    const Vector3d step = later.mean_.col(i) - mean_.col(i);
    mean_.col(i) += share * step;
    scatter_.col(i) += later.scatter_.col(i);
    addProducts(step, before * share, scatter_.col(i));
  }
  low_ = low_.cwiseMin(later.low_);
  high_ = high_.cwiseMax(later.high_);
}

Eigen::VectorXd ArcVariation::collected() const {
  Eigen::VectorXd numbers(collectedSize());
  Index at = 0;
  const auto write = [&](const auto& matrix) {
    numbers.segment(at, matrix.size()) = Eigen::Map<const Eigen::VectorXd>(matrix.data(), matrix.size());
    at += matrix.size();
  };
  numbers[at++] = static_cast<double>(count_);
  write(mean_);
  write(scatter_);
  write(low_);
  write(high_);
  return numbers;
}

void ArcVariation::restore(const Eigen::VectorXd& collected) {
  if (collected.size() != collectedSize()) {
    throw std::invalid_argument(std::to_string(collected.size()) + " numbers of the variation of " +
                                std::to_string(sectionCount()) + " sections; expected " +
                                std::to_string(collectedSize()));
  }
  Index at = 0;
  const auto read = [&](auto& matrix) {
    Eigen::Map<Eigen::VectorXd>(matrix.data(), matrix.size()) = collected.segment(at, matrix.size());
    at += matrix.size();
  };
  count_ = static_cast<std::uint64_t>(collected[at++]);
  read(mean_);
  read(scatter_);
  read(low_);
  read(high_);
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
