// Variation along a cable against stored samples.
#include <cable_variation/statistics/arc_variation.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cable_variation/util/counter_random.h>

namespace cable_variation {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr Eigen::Index kSections = 4;

// Sections far from the origin, each varying in its own directions; the first not at all.
ArcVariation::Positions positionsOf(std::uint32_t sample) {
  const CounterRandom random(6, 6);
  ArcVariation::Positions positions(3, kSections);
  for (Eigen::Index s = 0; s < kSections; ++s) {
    const auto u = [&](std::uint32_t k) {
      return random.uniform(sample, 3 * static_cast<std::uint32_t>(s) + k) - 0.5;
    };
    const double size = 1e-3 * static_cast<double>(s);
    positions.col(s) = Vector3d(10.0, -4.0, 0.1 * static_cast<double>(s)) +
                       size * (u(0) * Vector3d(1, 2, 2) + u(1) * Vector3d(0.2, 0.1, -0.2) +
                               0.01 * u(2) * Vector3d(2, -2, 1));
  }
  return positions;
}

constexpr std::uint32_t kCount = 700;

ArcVariation variationOf(std::uint32_t begin, std::uint32_t end, const std::vector<Matrix3d>& frames = {}) {
  ArcVariation variation(kSections, frames);
  for (std::uint32_t i = begin; i < end; ++i) variation.add(positionsOf(i));
  return variation;
}

TEST(ArcVariation, MeanCovarianceAndRangeAreThoseOfTheSamples) {
  const Matrix3d frame = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const auto found = variationOf(0, kCount, std::vector<Matrix3d>(kSections, frame)).variation();
  for (Eigen::Index s = 0; s < kSections; ++s) {
    Eigen::Matrix3Xd all(3, kCount);
    for (std::uint32_t i = 0; i < kCount; ++i) all.col(i) = positionsOf(i).col(s);
    const Vector3d mean = all.rowwise().mean();
    const Eigen::Matrix3Xd centred = all.colwise() - mean;
    const Matrix3d covariance = centred * centred.transpose() / (kCount - 1.0);
    const Eigen::Matrix3Xd along = frame.transpose() * all;
    const SectionVariation& section = found[static_cast<std::size_t>(s)];
    EXPECT_LT((section.mean - mean).norm(), 1e-13);
    EXPECT_LT((section.covariance - covariance).norm(), 1e-16);
    EXPECT_LT((section.range - (along.rowwise().maxCoeff() - along.rowwise().minCoeff())).norm(), 1e-14);
  }
}

TEST(ArcVariation, PrincipalAxesAreThoseOfTheLargestVariation) {
  const SectionVariation section = variationOf(0, kCount).variation()[3];
  const PrincipalAxes& axes = section.axes;
  // uniform, 9 mm wide along (1, 2, 2)/3: 9/√12 mm, to the error of 700 samples
  EXPECT_NEAR(axes.sigma[0], 9e-3 / std::sqrt(12.0), 1e-4);
  EXPECT_GT(std::abs(axes.directions.col(0).dot(Vector3d(1, 2, 2) / 3.0)), 0.999);
  EXPECT_NEAR(axes.directions.determinant(), 1.0, 1e-12);
  const Matrix3d again = axes.directions * axes.sigma.cwiseAbs2().asDiagonal() * axes.directions.transpose();
  EXPECT_LT((again - section.covariance).norm(), 1e-16);
}

TEST(ArcVariation, MergedPartsAreTheWhole) {
  ArcVariation merged = variationOf(0, 0);
  merged.merge(variationOf(0, 1));
  merged.merge(variationOf(1, 300));
  merged.merge(variationOf(0, 0));
  merged.merge(variationOf(300, kCount));
  const auto parts = merged.variation(), once = variationOf(0, kCount).variation();
  EXPECT_EQ(merged.count(), kCount);
  for (std::size_t s = 0; s < once.size(); ++s) {
    EXPECT_LT((parts[s].mean - once[s].mean).norm(), 1e-14);
    EXPECT_LT((parts[s].covariance - once[s].covariance).norm(), 1e-17);
    EXPECT_EQ(parts[s].range, once[s].range);
  }
}

TEST(ArcVariation, WhatDoesNotVaryHasNoVariation) {
  const SectionVariation fixed = variationOf(0, kCount).variation()[0];
  EXPECT_LT(fixed.axes.sigma[0], 1e-12);
  EXPECT_EQ(fixed.range, Vector3d::Zero());
  const SectionVariation once = variationOf(0, 1).variation()[3];
  EXPECT_EQ(once.covariance, Matrix3d::Zero());
  EXPECT_EQ(once.mean, Vector3d(positionsOf(0).col(3)));
  EXPECT_EQ(variationOf(0, 0).variation()[3].range, Vector3d::Zero());
}

TEST(ArcVariation, BadInputIsRefused) {
  EXPECT_THROW(ArcVariation(3, std::vector<Matrix3d>(2, Matrix3d::Identity())), std::invalid_argument);
  ArcVariation variation(2);
  EXPECT_THROW(variation.add(ArcVariation::Positions::Zero(3, 3)), std::invalid_argument);
  ArcVariation::Positions broken = ArcVariation::Positions::Zero(3, 2);
  broken(1, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(variation.add(broken), std::invalid_argument);
  EXPECT_EQ(variation.count(), 0u);
  EXPECT_THROW(variation.merge(ArcVariation(3)), std::invalid_argument);
}

}  // namespace
}  // namespace cable_variation
