#include <cable_variation/geometry/tube_distance/hausdorff.h>

#include <limits>
#include <random>
#include <stdexcept>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "test_curves.h"

namespace cable_variation {
namespace {

using Eigen::Vector3d;
using test::centreline;
using test::circle;
using test::Curve;
using test::straight;
using test::wandering;

std::vector<Vector3d> samples(const Centreline& line, int per_piece) {
  std::vector<Vector3d> points;
  for (const Centreline::Piece& piece : line.pieces) {
    for (int k = 0; k < per_piece; ++k) points.push_back(piece.curve.position(double(k) / per_piece));
  }
  points.push_back(line.pieces.back().curve.position(1.0));
  return points;
}

double distanceToPolygon(const Vector3d& p, const std::vector<Vector3d>& polygon) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < polygon.size(); ++i) {
    const Vector3d way = polygon[i] - polygon[i - 1];
    const double t = std::clamp((p - polygon[i - 1]).dot(way) / way.squaredNorm(), 0.0, 1.0);
    smallest = std::min(smallest, (p - polygon[i - 1] - t * way).squaredNorm());
  }
  return std::sqrt(smallest);
}

Vector3d place(const Hausdorff& found, const Centreline& a, const Centreline& b) {
  return (found.on_first ? a : b).position(found.place);
}
Vector3d nearest(const Hausdorff& found, const Centreline& a, const Centreline& b) {
  return (found.on_first ? b : a).position(found.nearest);
}

TEST(CurveHausdorff, ConcentricCirclesAreTheirRadiiApart) {
  // three quarters, so that ends are on the same rays; 40 quintic pieces are within 1e-10 of the circle
  const Centreline a = centreline(circle({0.1, 0.2, 0.3}, 0.05), 1.5 * M_PI * 0.05, 40);
  const Centreline b = centreline(circle({0.1, 0.2, 0.3}, 0.08), 1.5 * M_PI * 0.08, 37);
  for (const Hausdorff& found : {curveHausdorff(a, b), curveHausdorff(b, a)}) {
    EXPECT_NEAR(found.distance, 0.03, 1e-9);
    EXPECT_LE(found.error_bound, 1e-7);
    EXPECT_GE(found.error_bound, 0.0);
  }
}

TEST(CurveHausdorff, LinesOfDifferentLengthDifferMostAtTheLongerOnesEnds) {
  const Centreline a = centreline(straight({0.0, 0.0, 0.0}, {1, 0, 0}), 0.3, 7);
  // 0.02 to the side, from 0.05 before the start of the other to 0.02 short of its end
  const Centreline b = centreline(straight({-0.05, 0.02, 0.0}, {1, 0, 0}), 0.33, 11);
  const Hausdorff found = curveHausdorff(a, b);
  EXPECT_NEAR(found.distance, std::hypot(0.05, 0.02), 1e-12);
  EXPECT_FALSE(found.on_first);
  EXPECT_TRUE(place(found, a, b).isApprox(Vector3d(-0.05, 0.02, 0.0), 1e-12));
  EXPECT_LT(nearest(found, a, b).norm(), 1e-12);
  const Hausdorff other = curveHausdorff(b, a);
  EXPECT_TRUE(other.on_first);
  EXPECT_EQ(other.distance, found.distance);
}

TEST(CurveHausdorff, OfACurveToItselfIsZero) {
  std::mt19937 generator(1);
  const Curve curve = wandering(generator, 0.3, 0.05);
  const Centreline a = centreline(curve, 0.3, 50);
  const Hausdorff found = curveHausdorff(a, a);
  EXPECT_LT(found.distance, 1e-15);
  EXPECT_LE(found.error_bound, 1e-7);
}

TEST(CurveHausdorff, ShiftAcrossIsTheShift) {
  // of a plane curve out of its plane, on another grid: every place is as far, also for a shift of 1 nm
  const Curve flat = circle(Vector3d::Zero(), 0.1);
  for (const double shift : {1e-9, 1e-6, 1e-3, 0.5}) {
    const Curve lifted = [&](double s) {
      CurvePiece::End end = flat(s);
      end.position.z() += shift;
      return end;
    };
    const Hausdorff found = curveHausdorff(centreline(flat, 0.25, 60), centreline(lifted, 0.25, 60));
    EXPECT_NEAR(found.distance, shift, 2e-12) << shift;
    EXPECT_LE(found.error_bound, 1e-7) << shift;
  }
}

TEST(CurveHausdorff, SmallestAwayFromTwoBranchesIsFoundAtTheKink) {
  // a wide U; the way across it is furthest from the U half way between the legs, where the foot jumps
  Centreline u = centreline(straight({0.4, -0.1, 0.0}, {-1, 0, 0}), 0.4, 10);
  const Centreline back = centreline(
      [](double s) {
        const double angle = s / 0.1;
        const Vector3d out(-std::sin(angle), -std::cos(angle), 0.0);
        return CurvePiece::End{0.1 * out, {out.y(), -out.x(), 0.0}, -out / 0.1};
      },
      M_PI * 0.1, 20);
  const Centreline leg = centreline(straight({0.0, 0.1, 0.0}, {1, 0, 0}), 0.4, 10);
  for (const Centreline* part : {&back, &leg}) {
    const double shift = u.pieces.back().end;
    for (Centreline::Piece piece : part->pieces) {
      piece.start += shift;
      piece.end += shift;
      u.pieces.push_back(piece);
    }
  }
  const Centreline across = centreline(straight({0.2, -0.1, 0.0}, {0, 1, 0}), 0.2, 3);
  const Hausdorff there = curveHausdorff(across, u);
  EXPECT_FALSE(there.on_first);  // of the U, the bottom is 0.3 and its legs' ends are 0.2 from the way across
  EXPECT_NEAR(there.distance, 0.3, 1e-9);
  // a bar beyond the legs' ends, of which nothing is far from the U: only the U's places count less
  const Centreline bar = centreline(straight({0.0, -0.1, 0.0}, {0, 1, 0}), 0.2, 4);
  const Hausdorff middle = curveHausdorff(u, bar, 1e-9);
  EXPECT_NEAR(middle.distance, 0.4, 1e-12);
}

TEST(CurveHausdorff, AgreesWithBruteForceForWanderingCurves) {
  std::mt19937 generator(7);
  std::uniform_int_distribution<std::size_t> pieces(15, 60);
  for (int trial = 0; trial < 12; ++trial) {
    // from unlike curves to nearly equal ones
    const double amplitude = 0.06 * std::pow(0.4, trial % 6);
    std::mt19937 twin = generator;
    const Curve base = wandering(twin, 0.3, 0.05), change = wandering(generator, 0.3, amplitude);
    const Curve changed = [&](double s) {
      CurvePiece::End end = base(s);
      const CurvePiece::End by = change(s);
      end.position += by.position - Vector3d(s, 0.0, 0.0);
      end.tangent += by.tangent - Vector3d::UnitX();
      end.second_derivative += by.second_derivative;
      return end;
    };
    const Centreline a = centreline(base, 0.3, pieces(generator));
    const Centreline b = centreline(changed, 0.3 + 0.2 * amplitude, pieces(generator));
    const Hausdorff found = curveHausdorff(a, b);
    EXPECT_LE(found.error_bound, 1e-7);

    const int per_piece = 40;
    const std::vector<Vector3d> points_a = samples(a, per_piece), points_b = samples(b, per_piece);
    // chords of 0.5 mm of curves bent to 15 mm at the tightest leave them by 2e-6 at most
    constexpr double kChord = 2e-6;
    double largest = 0.0;
    for (std::size_t i = 0; i < points_a.size(); i += 3)
      largest = std::max(largest, distanceToPolygon(points_a[i], points_b));
    for (std::size_t i = 0; i < points_b.size(); i += 3)
      largest = std::max(largest, distanceToPolygon(points_b[i], points_a));
    EXPECT_LE(largest, found.distance + found.error_bound + kChord) << trial;
    // places are at most 1.5 mm apart, and the distance changes by no more than the way
    EXPECT_GE(largest, found.distance - 1e-3) << trial;
    EXPECT_NEAR(distanceToPolygon(place(found, a, b), found.on_first ? points_b : points_a), found.distance,
                kChord)
        << trial;
    EXPECT_NEAR((place(found, a, b) - nearest(found, a, b)).norm(), found.distance, 2e-12);
  }
}

TEST(CurveHausdorff, BoundHoldsForCoarseAccuracy) {
  std::mt19937 generator(3);
  for (int trial = 0; trial < 20; ++trial) {
    const Centreline a = centreline(wandering(generator, 0.3, 0.04), 0.3, 30);
    const Centreline b = centreline(wandering(generator, 0.3, 0.04), 0.3, 45);
    const double exact = curveHausdorff(a, b, 1e-10).distance;
    for (const double accuracy : {1e-2, 1e-3, 1e-5}) {
      const Hausdorff found = curveHausdorff(a, b, accuracy);
      EXPECT_LE(found.error_bound, accuracy);
      EXPECT_LE(found.distance, exact + 1e-10);
      EXPECT_GE(found.distance + found.error_bound, exact - 1e-12);
    }
  }
}

TEST(CurveHausdorff, PlaceIsStationaryAlongTheCurve) {
  // a shallow bump over a straight line: 10 mm high at 0.15
  const Curve bump = [](double s) {
    const double k = M_PI / 0.3;
    return CurvePiece::End{{s, 0.01 * std::sin(k * s), 0.0},
                           {1.0, 0.01 * k * std::cos(k * s), 0.0},
                           {0.0, -0.01 * k * k * std::sin(k * s), 0.0}};
  };
  const Centreline a = centreline(bump, 0.3, 17);
  const Centreline line = centreline(straight(Vector3d::Zero(), {1, 0, 0}), 0.3, 5);
  const Hausdorff found = curveHausdorff(line, a, 1e-5);
  EXPECT_NEAR(place(found, line, a).x(), 0.15, 1e-9);  // the accuracy asks for 0.4 mm only
  EXPECT_NEAR(found.distance, 0.01, 1e-9);
}

TEST(SurfaceHausdorff, ParallelTubes) {
  const Centreline a = centreline(straight({0, 0, 0}, {1, 0, 0}), 0.3, 6, 0.004, 0.004);
  for (const double shift : {0.0, 0.001, 0.02}) {
    const Centreline b = centreline(straight({0, shift, 0}, {1, 0, 0}), 0.3, 9, 0.006, 0.006);
    const Hausdorff found = surfaceHausdorff(a, b);
    EXPECT_NEAR(found.distance, shift + 0.002, 1e-9);  // the thicker one's far side
    EXPECT_FALSE(found.on_first);
    EXPECT_LE(found.error_bound, 1e-6);
  }
}

TEST(SurfaceHausdorff, ConeAndCylinderDifferMostAtTheThickEnd) {
  const Centreline cylinder = centreline(straight({0, 0, 0}, {1, 0, 0}), 0.1, 6, 0.004, 0.004);
  const Centreline cone = centreline(straight({0, 0, 0}, {1, 0, 0}), 0.1, 6, 0.004, 0.006);
  const Hausdorff found = surfaceHausdorff(cylinder, cone);
  EXPECT_NEAR(found.distance, 0.002, 1e-9);
  EXPECT_FALSE(found.on_first);
  EXPECT_NEAR(found.distance, surfaceHausdorff(cone, cylinder).distance, 1e-12);
}

TEST(SurfaceHausdorff, LongerTubeEndsInItsRoundEnd) {
  const Centreline a = centreline(straight({0, 0, 0}, {1, 0, 0}), 0.30, 6, 0.005, 0.005);
  const Centreline b = centreline(straight({0, 0, 0}, {1, 0, 0}), 0.32, 6, 0.004, 0.004);
  EXPECT_NEAR(surfaceHausdorff(a, b).distance, 0.02 - 0.001, 1e-9);
}

TEST(SurfaceHausdorff, NoSampledPointOfEitherSurfaceIsFurther) {
  std::mt19937 generator(11);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 6; ++trial) {
    const Centreline a = centreline(wandering(generator, 0.3, 0.03), 0.3, 30, 0.006, 0.003);
    const Centreline b = centreline(wandering(generator, 0.3, 0.03), 0.3, 40, 0.004, 0.005);
    const Hausdorff found = surfaceHausdorff(a, b);
    EXPECT_LE(found.error_bound, 1e-6);
    double largest = 0.0;
    for (int direction = 0; direction < 2; ++direction) {
      const Centreline& from = direction == 0 ? a : b;
      const Centreline& to = direction == 0 ? b : a;
      const int kPerPiece = 20;
      for (const Centreline::Piece& piece : from.pieces) {
        for (int k = 0; k < 40; ++k) {
          // around the mantle, and all over the round ends
          const bool start = &piece == &from.pieces.front() && k % 2 == 0;
          const bool end = &piece == &from.pieces.back() && k % 2 == 0;
          const double t = start ? 0.0
                           : end ? 1.0
                                 : std::uniform_real_distribution<double>(0.0, 1.0)(generator);
          const double radius = piece.start_radius + t * (piece.end_radius - piece.start_radius);
          const Vector3d any(normal(generator), normal(generator), normal(generator));
          const Vector3d along = piece.curve.first(t);
          const Vector3d out = start ? Vector3d(any.dot(along) > 0.0 ? -any : any)
                               : end ? Vector3d(any.dot(along) < 0.0 ? -any : any)
                                     : along.cross(any);
          const Vector3d point = piece.curve.position(t) + radius * out.normalized();
          double outside = std::numeric_limits<double>::infinity();
          for (const Centreline::Piece& other : to.pieces) {
            for (int j = 0; j <= kPerPiece; ++j) {
              const double u = double(j) / kPerPiece;
              outside = std::min(outside, (point - other.curve.position(u)).norm() - other.start_radius -
                                              u * (other.end_radius - other.start_radius));
            }
          }
          largest = std::max(largest, std::abs(outside));
        }
      }
    }
    // distances are taken to places at most 0.7 mm apart: at 10 mm and more they are too long by 1e-5 at most
    EXPECT_LE(largest, found.distance + found.error_bound + 1e-5) << trial;
    EXPECT_GE(largest, found.distance - 1e-3) << trial;
  }
}

TEST(Hausdorff, RefusesBadInput) {
  const Centreline line = centreline(straight({0, 0, 0}, {1, 0, 0}), 0.3, 2);
  EXPECT_THROW(curveHausdorff(line, {}), std::invalid_argument);
  EXPECT_THROW(curveHausdorff(line, line, 0.0), std::invalid_argument);
  EXPECT_THROW(surfaceHausdorff(line, line, -1e-6), std::invalid_argument);
}

}  // namespace
}  // namespace cable_variation
