// The smallest bend radius of shapes whose curvature is known.
#include <cable_variation/equilibrium/bend_radius.h>

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace cable_variation {
namespace {

/// (a cos t, b sin t) from `first` on, arc length standing for t: the radius of
/// curvature is b²/a at t = 0, between the points if `first` is no whole step.
CableShape ellipse(double a, double b, double first) {
  CableShape shape;
  for (int i = 0; i <= 20; ++i) {
    const double t = first + 0.05 * M_PI * i;
    ShapePoint point;
    point.arc_length = t;
    point.pose.position = {a * std::cos(t), b * std::sin(t), 0.0};
    point.tangent = {-a * std::sin(t), b * std::cos(t), 0.0};
    point.second_derivative = {-a * std::cos(t), -b * std::sin(t), 0.0};
    shape.points.push_back(point);
  }
  return shape;
}

TEST(BendRadius, OfAnEllipseIsAtItsTip) {
  const BendRadius at_a_point = smallestBendRadius(ellipse(0.2, 0.1, -0.5 * M_PI));
  // next to the point, where the curve is exact, the Hermite curve is bent more by 1e-10 of it
  EXPECT_NEAR(at_a_point.radius, 0.05, 1e-11);
  EXPECT_NEAR(at_a_point.arc_length, 0.0, 1e-5);
  const BendRadius between = smallestBendRadius(ellipse(0.2, 0.1, -0.525 * M_PI));
  EXPECT_NEAR(between.radius, 0.05, 1e-5);  // the Hermite curve's own error, h⁴
  EXPECT_NEAR(between.arc_length, 0.0, 1e-12);
}

TEST(BendRadius, OfAStraightCableIsInfinite) {
  CableShape shape;
  shape.points.resize(3);
  for (int i = 0; i < 3; ++i) {
    ShapePoint& point = shape.points[static_cast<std::size_t>(i)];
    point.arc_length = i;
    point.pose.position.x() = i;
    point.tangent = Eigen::Vector3d::UnitX();
  }
  EXPECT_TRUE(std::isinf(smallestBendRadius(shape).radius));
}

TEST(BendRadius, OfASolvedRollUpIsThatOfItsCircle) {
  // An end moment M bends a weightless cantilever to radius EI / M.
  Harness harness;
  harness.gravity.setZero();
  const Section section = solidSection(0.004, {1e8, 0.25, 2000});
  harness.cables.resize(1);
  harness.cables[0].name = "roll";
  harness.cables[0].length = 0.3;
  harness.cables[0].sections = {{0.0, section}};
  Clip clip;
  clip.name = "A";
  clip.type = "fixed";
  clip.constraint = fixedClip();
  harness.clips = {clip};
  PointLoad load;
  load.name = "M";
  load.arc_length = 0.3;
  load.moment = {0.0, 0.0, section.EI_z / 0.15};
  harness.loads = {load};
  const Equilibrium equilibrium = EquilibriumSolver().solve(harness);
  ASSERT_TRUE(equilibrium.converged()) << equilibrium.message;
  EXPECT_NEAR(smallestBendRadius(equilibrium.shapes[0]).radius, 0.15, 1e-4);
}

TEST(BendRadius, NeedsTwoPoints) { EXPECT_THROW(smallestBendRadius(CableShape()), std::invalid_argument); }

}  // namespace
}  // namespace cable_variation
