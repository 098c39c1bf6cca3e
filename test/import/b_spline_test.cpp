// B-splines against Bézier's polynomials, parabolas and differences.
#include <cable_variation/import/b_spline.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;
using Knots = BSpline::Knots;

const std::vector<Vector3d> kPoints{{0, 0, 0}, {1, 2, 0}, {3, 1, 1}, {4, -1, 2}, {5, 0, 0}, {6, 3, 1}};

TEST(BSpline, clampedOnOnePieceIsBezier) {
  const std::vector<Vector3d> control(kPoints.begin(), kPoints.begin() + 4);
  const BSpline spline(control, 3, Knots::clamped);
  for (const double t : {0.0, 0.2, 0.7, 1.0}) {
    const double u = 1.0 - t;
    const Vector3d bezier = u * u * u * control[0] + 3 * u * u * t * control[1] + 3 * u * t * t * control[2] +
                            t * t * t * control[3];
    EXPECT_LT((spline.position(t) - bezier).norm(), 1e-14);
  }
}

TEST(BSpline, unclampedCubicHasTheUniformBasis) {
  const BSpline spline(kPoints, 3, Knots::unclamped);
  ASSERT_EQ(spline.polynomials(), 3U);
  for (std::size_t knot = 0; knot <= 3; ++knot) {
    const std::size_t i = std::min<std::size_t>(knot, 2);
    const Vector3d at = knot < 3 ? Vector3d((kPoints[i] + 4 * kPoints[i + 1] + kPoints[i + 2]) / 6.0)
                                 : Vector3d((kPoints[3] + 4 * kPoints[4] + kPoints[5]) / 6.0);
    EXPECT_LT((spline.position(static_cast<double>(knot) / 3.0) - at).norm(), 1e-14);
  }
}

TEST(BSpline, firstDerivativeIsThatOfDifferences) {
  for (const Knots knots : {Knots::clamped, Knots::unclamped}) {
    for (const int degree : {1, 2, 3, 5}) {
      const BSpline spline(kPoints, degree, knots);
      for (const double t : {0.11, 0.37, 0.81}) {
        const double h = 1e-6;
        const Vector3d difference = (spline.position(t + h) - spline.position(t - h)) / (2 * h);
        EXPECT_LT((spline.first(t) - difference).norm(), 1e-7) << "degree " << degree;
      }
    }
  }
}

TEST(BSpline, lengthOfAParabolaIsItsClosedForm) {
  // Bézier's form of (x, x²) for x from 0 to 2
  const BSpline spline({{0, 0, 0}, {1, 0, 0}, {2, 4, 0}}, 2, Knots::clamped);
  const double slope = 4.0;
  const double exact = 0.25 * (slope * std::sqrt(1 + slope * slope) + std::asinh(slope));
  EXPECT_NEAR(spline.length(), exact, 1e-11);
  EXPECT_NEAR(spline.length(0.0, 0.3) + spline.length(0.3, 1.0), exact, 1e-11);
}

TEST(BSpline, tooFewControlPointsAreRefused) {
  EXPECT_THROW(BSpline(kPoints, 6, Knots::clamped), std::invalid_argument);
  EXPECT_THROW(BSpline(kPoints, 0, Knots::clamped), std::invalid_argument);
}

}  // namespace
}  // namespace cable_variation
