// Rest curvature of a curve through points, against curves whose curvature is known.

#include <cmath>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <equilibrium/cases.h>

namespace cable_variation::test {
namespace {

using Points = std::vector<Eigen::Vector3d>;

Points helixPoints(double radius, double rise_per_radian, double turn, int count) {
  Points points;
  for (int i = 0; i < count; ++i) {
    const double t = turn * i / (count - 1);
    points.emplace_back(radius * std::cos(t), radius * std::sin(t), rise_per_radian * t);
  }
  return points;
}

double largestOf(const std::vector<RestCurvatureAt>& knots) {
  double largest = 0.0;
  for (const RestCurvatureAt& knot : knots) largest = std::max(largest, knot.curvature.norm());
  return largest;
}

// A spline through n points of a smooth curve is off by the order of the distance between them cubed in its
// second derivative; its ends, where nothing is known beyond, are the worst.
TEST(RestCurvature, OfACircleIsOneOverItsRadius) {
  const double radius = 0.1, turn = 2.5, length = radius * turn;
  const auto knots = restCurvatureThrough(helixPoints(radius, 0.0, turn, 41), length);
  ASSERT_GT(knots.size(), 10u);
  EXPECT_EQ(knots.front().arc_length, 0.0);
  EXPECT_NEAR(knots.back().arc_length, length, 1e-12);
  for (const RestCurvatureAt& knot : knots) {
    EXPECT_NEAR(knot.curvature.norm(), 1.0 / radius, 0.02 / radius) << "at " << knot.arc_length;
    EXPECT_EQ(knot.curvature.x(), 0.0);  // the frame has no torsion
  }
}

// The frame turns backwards about the tangent by the curve's torsion τ = c/(r² + c²), so the curvature's
// direction turns forwards by it.
TEST(RestCurvature, OfAHelixTurnsWithItsTorsion) {
  const double r = 0.05, c = 0.03, turn = 4.0, length = turn * std::hypot(r, c);
  const auto knots = restCurvatureThrough(helixPoints(r, c, turn, 61), length);
  const auto angleAt = [](const RestCurvatureAt& knot) {
    return std::atan2(knot.curvature.z(), knot.curvature.y());
  };
  const RestCurvatureAt& a = knots[knots.size() / 4];
  const RestCurvatureAt& b = knots[knots.size() / 2];
  const double turned = std::remainder(angleAt(b) - angleAt(a), 2.0 * M_PI);
  EXPECT_NEAR(turned / (b.arc_length - a.arc_length), c / (r * r + c * c), 0.01 * c / (r * r + c * c));
  EXPECT_NEAR(a.curvature.norm(), r / (r * r + c * c), 0.01 * r / (r * r + c * c));
}

TEST(RestCurvature, OfAStraightLineIsNone) {
  EXPECT_LT(largestOf(restCurvatureThrough({{0, 0, 0}, {0.1, 0.1, 0}, {0.3, 0.3, 0}, {0.4, 0.4, 0}},
                                           0.4 * std::sqrt(2.0))),
            1e-9);
}

// The cable takes up the shape its points describe.
TEST(RestCurvature, LeadsAFreeCableThroughThePoints) {
  const double r = 0.05, c = 0.03, turn = 3.0, length = turn * std::hypot(r, c);
  const Points points = helixPoints(r, c, turn, 41);
  Cable cable = uniformCable(length, hoseOfCaseH());
  cable.rest_curvature = restCurvatureThrough(points, length);
  Harness harness = cantilever(cable, Eigen::Vector3d::Zero());
  const Eigen::Vector3d tangent = Eigen::Vector3d(0.0, r, c).normalized();
  harness.clips[0].pose = {points.front(), so3::smallestRotation(Eigen::Vector3d::UnitX(), tangent)};
  const Equilibrium result = solve(harness, 1e-5);
  ASSERT_TRUE(result.converged()) << result.message;
  for (std::size_t i = 0; i < points.size(); i += 4) {
    const double s = length * static_cast<double>(i) / static_cast<double>(points.size() - 1);
    EXPECT_LT((result.shapes[0].position(s) - points[i]).norm(), 2e-4)
        << "point " << i;  // 0.1 % of the length
  }
}

std::string refusalOf(const Points& points, double length) {
  try {
    restCurvatureThrough(points, length);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "taken";
}

TEST(RestCurvature, TakesALengthWithinOnePercentAndScalesByIt) {
  const Points circle = helixPoints(0.1, 0.0, 2.0, 41);  // 0.2 m
  EXPECT_NEAR(restCurvatureThrough(circle, 0.2019).back().arc_length, 0.2019, 1e-15);
  // scaled by 0.95 %, to far below that
  EXPECT_NEAR(restCurvatureThrough(circle, 0.2019)[200].curvature.norm(), 10.0 * 0.2 / 0.2019, 5e-3);
  EXPECT_NE(refusalOf(circle, 0.2021).find("expected the cable's length of 0.2021 m within 1 %"),
            std::string::npos);
  EXPECT_NE(refusalOf(circle, 0.1979).find("expected the cable's length of 0.1979 m within 1 %"),
            std::string::npos);
}

TEST(RestCurvature, RefusesWhatIsNoCurve) {
  EXPECT_EQ(refusalOf({{0, 0, 0}, {1, 0, 0}}, 1.0), "rest shape has 2 points, expected at least 3");
  EXPECT_EQ(refusalOf({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}}, 2.0),
            "rest shape points 1 and 2 coincide, expected a distance between them");
  EXPECT_EQ(refusalOf({{0, 0, 0}, {1, NAN, 0}, {2, 0, 0}}, 2.0), "rest shape point 1 is not finite");
}

}  // namespace
}  // namespace cable_variation::test
