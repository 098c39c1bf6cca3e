// Distances between cables: closed forms, and brute force with and without a joint.
#include <cable_variation/geometry/tube_distance/distance.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <geometry/distance_oracle.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;
using test::Chance;
using test::Real;

// The library works to 1e-8 m; 1e-7 m is what it promises.
constexpr double kPromised = 1e-7;

Centreline arc(const Vector3d& centre, double bend_radius, double angle, double radius, std::size_t pieces) {
  Centreline cable;
  const auto end = [&](double a) {
    return CurvePiece::End{centre + bend_radius * Vector3d(std::cos(a), std::sin(a), 0.0),
                           {-std::sin(a), std::cos(a), 0.0},
                           Vector3d(-std::cos(a), -std::sin(a), 0.0) / bend_radius};
  };
  const double step = angle / static_cast<double>(pieces), length = bend_radius * step;
  for (std::size_t i = 0; i < pieces; ++i) {
    const auto k = static_cast<double>(i);
    cable.pieces.push_back({CurvePiece(end(k * step), end((k + 1.0) * step), length), k * length,
                            (k + 1.0) * length, radius, radius});
  }
  return cable;
}

TEST(CableDistance, OfCrossingStraightOnes) {
  const Centreline a = test::straightCable({-1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 0.01, 7);
  const Centreline b = test::straightCable({0.1, -1.0, 0.2}, {0.1, 1.0, 0.2}, 0.02, 5);
  const auto pair = distance(a, b);
  ASSERT_TRUE(pair && pair->other_place);
  EXPECT_NEAR(pair->distance, 0.17, 1e-14);
  EXPECT_EQ(pair->contact, ClosestPair::Contact::clear);
  EXPECT_NEAR(a.arcLength(pair->place), 1.1, 1e-12);
  EXPECT_NEAR(b.arcLength(*pair->other_place), 1.0, 1e-12);
  EXPECT_NEAR((pair->direction + Vector3d::UnitZ()).norm(), 0.0, 1e-14);
  EXPECT_EQ(pair->runner_up, std::numeric_limits<double>::infinity());
}

TEST(CableDistance, OfParallelStraightOnesIsNotUnique) {
  const Centreline a = test::straightCable({0.0, 0.0, 100.0}, {1.0, 0.0, 100.0}, 0.01, 10);
  const Centreline b = test::straightCable({0.2, 0.05, 100.0}, {1.3, 0.05, 100.0}, 0.01, 13);
  const auto pair = distance(a, b);
  ASSERT_TRUE(pair);
  EXPECT_NEAR(pair->distance, 0.03, 1e-13);
  EXPECT_NEAR(pair->runner_up, 0.03, 1e-13);
}

TEST(CableDistance, OfThoseThatMeetIsMinusBothRadii) {
  const Centreline a = test::straightCable({-1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 0.01, 3);
  const Centreline b = test::straightCable({0.1, -1.0, 0.0}, {0.1, 1.0, 0.0}, 0.02, 4);
  const auto pair = distance(a, b);
  ASSERT_TRUE(pair);
  EXPECT_NEAR(pair->distance, -0.03, 1e-13);
  EXPECT_EQ(pair->contact, ClosestPair::Contact::overlap);
  EXPECT_NEAR(std::abs(pair->direction.z()), 1.0, 1e-12);
}

// Half circles: concentric ones are 20 mm apart all along; the pieces are no circles, but quintic curves
// that follow them to (angle/2)^6/720 R = 5e-13 R for 10 pieces.
TEST(CableDistance, OfConcentricArcs) {
  const Centreline a = arc(Vector3d::Zero(), 0.1, M_PI, 0.004, 10);
  const Centreline b = arc(Vector3d::Zero(), 0.12, M_PI, 0.006, 14);
  const auto pair = distance(a, b);
  ASSERT_TRUE(pair);
  EXPECT_NEAR(pair->distance, 0.01, 2e-8);
  EXPECT_NEAR(pair->runner_up, 0.01, 2e-8);
}

TEST(CableDistance, OfAnArcAboutAStraightOneHasTwoEnds) {
  // a half circle of 100 mm about a line through its centre, along its diameter: both ends touch the line
  const Centreline a = arc(Vector3d(0.0, 0.05, 0.0), 0.1, M_PI, 0.004, 10);
  const Centreline b = test::straightCable({-0.2, 0.0, 0.0}, {0.2, 0.0, 0.0}, 0.004, 8);
  const auto pair = distance(a, b);
  ASSERT_TRUE(pair);
  EXPECT_NEAR(pair->distance, 0.042, 1e-9);
  EXPECT_NEAR(pair->runner_up, pair->distance, 1e-9);
}

// A branch at right angles: the pair whose way through the joint is w = x + y and whose distance is
// sqrt(x² + y²) is closest at x = y.
TEST(CableDistance, ThroughAJointStartsWhereTheWayIsLongEnough) {
  const Centreline trunk = test::straightCable({-0.2, 0.0, 0.0}, {0.2, 0.0, 0.0}, 0.004, 9);
  const Centreline branch = test::straightCable({0.0, 0.0, 0.0}, {0.0, 0.3, 0.0}, 0.003, 7);
  const auto pair = distance(trunk, branch, JoinedAt{0.2, 0.0, 0.05});
  ASSERT_TRUE(pair);
  EXPECT_NEAR(pair->distance, 0.05 / std::sqrt(2.0) - 0.007, 1e-8);
  EXPECT_NEAR(pair->runner_up, pair->distance, 1e-8);  // on either side of the branch
  // nothing is that far from the joint
  EXPECT_FALSE(distance(trunk, branch, JoinedAt{0.2, 0.0, 0.6}));
}

constexpr int kSamples = 60;

Real bruteForce(const Centreline& a, const Centreline& b, const std::optional<JoinedAt>& joined) {
  Real smallest = std::numeric_limits<Real>::infinity();
  const auto way = [](const Centreline::Piece& piece) {
    Real sum = std::abs(Real(piece.end_radius) - piece.start_radius);
    for (std::size_t k = 1; k < 6; ++k) sum += Real(k) * piece.curve.coefficients()[k].cast<Real>().norm();
    return sum;
  };
  for (const Centreline::Piece& p : a.pieces) {
    for (const Centreline::Piece& q : b.pieces) {
      const auto value = [&](Real t, Real u) {
        return (test::curvePosition(p.curve, t) - test::curvePosition(q.curve, u)).norm() -
               test::radiusAt(p, t) - test::radiusAt(q, u);
      };
      if (value(0.5L, 0.5L) - (way(p) + way(q)) / 2 >= smallest) continue;
      const auto onFirst = [&](Real t) {
        const auto at = [&](Real u) { return value(t, u); };
        if (!joined) return test::smallestOver(0, 1, kSamples, at);
        const Real length = Real(q.end) - q.start;
        const Real rest =
            joined->shortest_way - std::abs(p.start + t * (Real(p.end) - p.start) - joined->on_cable);
        if (rest <= 0) return test::smallestOver(0, 1, kSamples, at);
        Real least = 1e3L;  // [m], far above all: nothing counts
        const Real before = std::min<Real>(1, (joined->on_other - rest - q.start) / length);
        const Real after = std::max<Real>(0, (joined->on_other + rest - q.start) / length);
        if (before >= 0) least = std::min(least, test::smallestOver(0, before, kSamples, at));
        if (after <= 1) least = std::min(least, test::smallestOver(after, 1, kSamples, at));
        return least;
      };
      smallest = std::min(smallest, test::smallestOver(0, 1, kSamples, onFirst));
    }
  }
  return smallest;
}

TEST(CableDistance, AgreesWithBruteForce) {
  Chance chance(7);
  double largest = 0.0;
  for (int i = 0; i < 600; ++i) {
    const double length = chance.size(2e-3, 0.2);
    const auto cable = [&] {
      return test::randomCable(chance, 1 + chance.below(3), length * chance.size(0.3, 3.0),
                               chance.oneOf(4) ? 0.0 : chance.between(0.0, 0.9),
                               chance.oneOf(4) ? 0.0 : length * chance.between(0.0, 0.3), chance.oneOf(3));
    };
    const Centreline a = cable();
    Centreline b = chance.oneOf(3) ? a : cable();  // the same: they run beside each other
    const Vector3d move = chance.oneOf(5) ? Vector3d::Zero() : Vector3d(length * chance.inBox(2.0));
    for (Centreline::Piece& piece : b.pieces) {
      const auto end = [&](double t) {
        return CurvePiece::End{piece.curve.position(t) + move, piece.curve.first(t), piece.curve.second(t)};
      };
      piece.curve = CurvePiece(end(0.0), end(1.0), 1.0);
    }
    const auto pair = distance(a, b);
    ASSERT_TRUE(pair);
    const auto expected = static_cast<double>(bruteForce(a, b, {}));
    EXPECT_NEAR(pair->distance, expected, kPromised) << i;
    largest = std::max(largest, std::abs(pair->distance - expected));
  }
  std::cout << "largest error " << largest << " m\n";
}

TEST(CableDistance, ThroughAJointAgreesWithBruteForce) {
  Chance chance(8);
  int found = 0;
  double largest = 0.0;
  for (int i = 0; i < 200; ++i) {
    const double length = chance.size(2e-3, 0.2);
    const Centreline a = test::randomCable(chance, 3, length, chance.between(0.0, 0.6), 0.1 * length, false);
    Centreline b =
        test::randomCable(chance, 2, length, chance.between(0.0, 0.6), 0.05 * length, chance.oneOf(2));
    // b starts somewhere on a
    const Centreline::Place joint{chance.below(3), chance.oneOf(3) ? 0.0 : chance.between(0.0, 1.0)};
    for (Centreline::Piece& piece : b.pieces) {
      const auto end = [&](double t) {
        return CurvePiece::End{piece.curve.position(t) + a.position(joint), piece.curve.first(t),
                               piece.curve.second(t)};
      };
      piece.curve = CurvePiece(end(0.0), end(1.0), 1.0);
    }
    const JoinedAt joined{a.arcLength(joint), 0.0, length * chance.between(0.1, 3.0)};
    const auto pair = distance(a, b, joined);
    const auto expected = static_cast<double>(bruteForce(a, b, joined));
    ASSERT_EQ(pair.has_value(), expected < 100.0) << i;
    if (!pair) continue;
    ++found;
    EXPECT_NEAR(pair->distance, expected, kPromised) << i;
    largest = std::max(largest, std::abs(pair->distance - expected));
    const double way = std::abs(a.arcLength(pair->place) - joined.on_cable) + b.arcLength(*pair->other_place);
    EXPECT_GE(way, joined.shortest_way - 1e-11) << i;
  }
  EXPECT_GT(found, 150);
  std::cout << "largest error " << largest << " m\n";
}

TEST(CableDistance, RefusesWhatIsNoCable) {
  const Centreline good = test::straightCable({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 0.01);
  EXPECT_THROW(distance(good, Centreline()), std::invalid_argument);
  EXPECT_THROW(distance(Centreline(), good), std::invalid_argument);
  Centreline bad = good;
  bad.pieces[0].end_radius = -1.0;
  EXPECT_THROW(distance(good, bad), std::invalid_argument);
  bad = test::straightCable({0.0, 0.0, 0.0}, {1.0, std::nan(""), 0.0}, 0.01);
  EXPECT_THROW(distance(good, bad), std::invalid_argument);
  EXPECT_THROW(distance(good, good, JoinedAt{0.0, std::nan(""), 0.0}), std::invalid_argument);
  EXPECT_THROW(distance(good, good, {}, -1e-3), std::invalid_argument);
}

}  // namespace
}  // namespace cable_variation
