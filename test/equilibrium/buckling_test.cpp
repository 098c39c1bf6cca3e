// Closed forms of buckling: where the smallest eigenvalue of what solve() and update() answer gets zero, and
// that nothing is answered beyond but what has buckled.

#include <array>
#include <complex>
#include <functional>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <gtest/gtest.h>

#include <Eigen/LU>

#include <equilibrium/cases.h>

namespace cable_variation::test {
namespace {

using Eigen::Vector3d;

const Vector3d kWeightless = Vector3d::Zero();
constexpr double kLength = 0.8, kEI = 0.05, kGJ = 0.04;
// κ = EA L²/EI of 1e7: stretch and shear shift the critical loads by some 1e-6 of themselves.
constexpr double kEA = 1e7 * kEI / (kLength * kLength);

Cable uniformRod() { return uniformCable(kLength, roundSection(kEA, 0.4 * kEA, kGJ, kEI)); }

double eigenvalueOf(const Harness& harness) {
  const Equilibrium result = solve(harness);
  EXPECT_TRUE(result.converged()) << result.message;
  return result.smallest_eigenvalue;
}

// The load, as a share of `expected`, at which the eigenvalue is zero: by a parabola through three loads
// below. `power` 2: at a limit point it is the eigenvalue's square that is smooth.
double zeroOf(const std::function<double(double)>& eigenvalue, double power = 1.0) {
  const std::array<double, 3> share = {0.97, 0.98, 0.99};
  Eigen::Matrix3d powers;
  Vector3d values;
  for (int i = 0; i < 3; ++i) {
    const double t = share[static_cast<std::size_t>(i)] - 1.0;
    const double value = eigenvalue(1.0 + t);
    EXPECT_GT(value, 0.0) << "at " << 1.0 + t << " of the critical load";
    powers.row(i) << 1.0, t, t * t;
    values[i] = std::pow(value, power);
  }
  const Vector3d c = powers.lu().solve(values);
  double t = -c[0] / c[1];
  for (int i = 0; i < 20; ++i) t -= (c[0] + c[1] * t + c[2] * t * t) / (c[1] + 2.0 * c[2] * t);
  return 1.0 + t;
}

double largestAside(const Equilibrium& result) {
  double aside = 0.0;
  for (const ShapePoint& point : result.shapes[0].points) {
    aside = std::max(aside, point.pose.position.tail<2>().norm());
  }
  return aside;
}

// Straight along x from the origin; the end is held as `end` says and pressed by `load`.
Harness pressed(const ClipConstraint& end, double load) {
  Harness harness = clamped(uniformRod(), poseAt(kLength, 0.0, 0.0), kWeightless);
  harness.clips[1].constraint = end;
  harness.loads = {loadAt(0, kLength, {-load, 0.0, 0.0})};
  return harness;
}

void expectBuckling(const std::function<Harness(double)>& at, double tolerance) {
  EXPECT_NEAR(zeroOf([&](double share) { return eigenvalueOf(at(share)); }), 1.0, tolerance);
  for (double share : {1.01, 1.1}) {
    const Equilibrium result = solve(at(share));
    ASSERT_TRUE(result.converged()) << share << ": " << result.message;
    EXPECT_GT(result.smallest_eigenvalue, -1e-9 * kEI / std::pow(kLength, 3)) << share;
    EXPECT_GT(largestAside(result), 0.02 * kLength) << share;
  }
}

TEST(Buckling, FixedAndPinned) {
  // tan x = x: x² = 20.19072856
  const double critical = 20.190728556 * kEI / (kLength * kLength);
  ClipConstraint pinned = pivotClip();
  pinned.translation[0] = ClipFreedom::free();
  expectBuckling([&](double share) { return pressed(pinned, share * critical); }, 1e-4);
}

TEST(Buckling, BothFixed) {
  const double critical = 4.0 * M_PI * M_PI * kEI / (kLength * kLength);
  expectBuckling([&](double share) { return pressed(guideClip(), share * critical); }, 1e-4);
}

TEST(Buckling, UnderItsOwnWeight) {
  // Greenhill 1881: (9/4) j² with the first zero j of the Bessel function J of order -1/3
  const double critical = 7.837347438 * kEI / std::pow(kLength, 3);
  const auto at = [&](double share) {
    Harness harness = cantilever(uniformRod(), {-9.81, 0.0, 0.0});
    harness.cables[0].sections[0].section.mass_per_length = share * critical / 9.81;
    return harness;
  };
  expectBuckling(at, 1e-4);
}

// Between clamps under a twisting moment M and a thrust P: w = y + iz obeys EI w'' - iM w' + P w = a + b s,
// so w = A + B s + C exp(iαs) + D exp(iβs) with EI α² - M α - P = 0. The determinant of w = w' = 0 at both
// ends, s = ±L/2, divided by what makes it real.
double greenhillDeterminant(double moment, double thrust) {
  using Complex = std::complex<double>;
  const double root = std::sqrt(moment * moment + 4.0 * thrust * kEI);
  const Complex i(0.0, 1.0);
  Eigen::Matrix4cd m;
  for (int end = 0; end < 2; ++end) {
    const double s = (end == 0 ? -0.5 : 0.5) * kLength;
    const double alpha = (moment + root) / (2.0 * kEI), beta = (moment - root) / (2.0 * kEI);
    m.row(2 * end) << 1.0, s, std::exp(i * alpha * s), std::exp(i * beta * s);
    m.row(2 * end + 1) << 0.0, 1.0, i * alpha * std::exp(i * alpha * s), i * beta * std::exp(i * beta * s);
  }
  const Complex determinant = m.determinant();
  return std::abs(determinant.real()) > std::abs(determinant.imag()) ? determinant.real()
                                                                     : determinant.imag();
}

// The smallest thrust at which a rod between clamps, one free to move along the axis, buckles under `moment`.
double greenhillThrust(double moment) {
  const double euler = 4.0 * M_PI * M_PI * kEI / (kLength * kLength);
  constexpr int kSteps = 2000;
  double low = 1e-6 * euler;
  for (int i = 1; i <= kSteps; ++i) {
    double high = 1.05 * euler * i / kSteps;
    if (greenhillDeterminant(moment, low) * greenhillDeterminant(moment, high) > 0.0) {
      low = high;
      continue;
    }
    while (high - low > 1e-10 * euler) {
      const double middle = 0.5 * (low + high);
      (greenhillDeterminant(moment, low) * greenhillDeterminant(moment, middle) > 0.0 ? low : high) = middle;
    }
    return low;
  }
  return NAN;
}

TEST(Buckling, TwistedAndPressed) {
  const double greatest = 2.0 * 4.493409457909064 * kEI / kLength;  // without thrust: tan λ = λ
  for (double part : {0.3, 0.6, 0.9}) {
    const double moment = part * greatest, critical = greenhillThrust(moment);
    ASSERT_TRUE(std::isfinite(critical));
    const double twist = moment * kLength / kGJ;
    const auto at = [&](double share) {
      Harness harness = pressed(guideClip(), share * critical);
      harness.clips[1].pose.orientation = so3::exp({twist, 0.0, 0.0});
      harness.cables[0].twist = twist;
      return harness;
    };
    SCOPED_TRACE(part);
    EXPECT_NEAR(zeroOf([&](double share) { return eigenvalueOf(at(share)); }), 1.0, 1e-3);
    const Equilibrium beyond = solve(at(1.02));
    ASSERT_TRUE(beyond.converged()) << beyond.message;
    EXPECT_GT(largestAside(beyond), 0.01 * kLength);
  }
}

TEST(Buckling, StripThatTipsOver) {
  // Michell, Prandtl 1899: the first zero 4.0126 of J of order -1/4, squared, of a strip stiff in its plane
  const double weak = 1e-4 * kEI;
  const double critical = 4.012599 * std::sqrt(weak * kGJ * 1e-4) / (kLength * kLength);
  const auto at = [&](double share) {
    Section strip = roundSection(kEA, 0.4 * kEA, 1e-4 * kGJ, kEI);
    strip.EI_z = weak;
    Harness harness = cantilever(uniformCable(kLength, strip), kWeightless);
    harness.loads = {loadAt(0, kLength, {0.0, 0.0, -share * critical})};
    return harness;
  };
  // bending in the plane before, of a ratio of 1e4, lifts it by some 1e-4
  EXPECT_NEAR(zeroOf([&](double share) { return eigenvalueOf(at(share)); }), 1.0, 5e-4);
  const Equilibrium beyond = solve(at(1.02));
  ASSERT_TRUE(beyond.converged()) << beyond.message;
  EXPECT_GT(std::abs(beyond.shapes[0].points.back().pose.position.y()), 0.01 * kLength);
}

// An arch of 215 degrees, clamped at one foot and hinged at the other, under a load at its crown: a limit
// point at 897 EI/R² (DaDeppo and Schmidt 1975; 897.3 by fine grids since).
TEST(Buckling, DeepArch) {
  constexpr double kRadius = 1.0, kBend = 1.0, kAngle = 215.0 * M_PI / 180.0;
  // stiff against leaving its plane
  Section section = roundSection(1e6, 1e6, 1e3, kBend);
  section.EI_y = 1e3;
  Cable cable = uniformCable(kRadius * kAngle, section);
  cable.rest_curvature = {{0.0, {0.0, 0.0, -1.0 / kRadius}}, {cable.length, {0.0, 0.0, -1.0 / kRadius}}};
  Harness harness;
  harness.gravity = kWeightless;
  harness.cables = {cable};
  const auto foot = [&](double side) -> Pose {
    const double angle = side * 0.5 * kAngle;  // from the crown, clockwise along the cable
    return {kRadius * Vector3d(std::sin(angle), std::cos(angle), 0.0), so3::exp({0.0, 0.0, -angle})};
  };
  harness.clips = {clipOn(0, "hinged", 0.0, hingeClip(Axis::z), foot(-1.0)),
                   clipOn(0, "clamped", cable.length, fixedClip(), foot(1.0))};
  EquilibriumOptions options;
  options.accuracy = 1e-6;
  options.multi_start = false;
  EquilibriumSolver solver(options);
  constexpr double kCritical = 8.973 * kBend / (kRadius * kRadius);
  double reached = 0.0;
  const auto follow = [&](double share) {
    // small steps, so that the branch from the unloaded arch is the one that is followed
    while (reached < share) {
      reached = std::min(share, reached + 0.01);
      harness.loads = {loadAt(0, 0.5 * cable.length, {0.0, -reached * kCritical, 0.0})};
      const Equilibrium result = solver.update(harness);
      EXPECT_TRUE(result.converged()) << reached << ": " << result.message;
      if (!result.converged()) return std::nan("");
      if (reached == share) return result.smallest_eigenvalue;
    }
    return std::nan("");
  };
  harness.loads = {loadAt(0, 0.5 * cable.length, {0.0, 0.0, 0.0})};
  ASSERT_TRUE(solver.solve(harness).converged());
  EXPECT_NEAR(zeroOf(follow, 2.0), 1.0, 1e-3);
}

// A cantilever pressed beyond Euler's load: its tip by elliptic integrals of the modulus k = sin(α/2), where
// α is the tip's turn (Love, The mathematical theory of elasticity, §263).
TEST(Buckling, PostBuckledElastica) {
  for (double degrees : {20.0, 60.0, 100.0, 140.0, 170.0}) {
    SCOPED_TRACE(degrees);
    const double k = std::sin(0.5 * degrees * M_PI / 180.0);
    const double K = boost::math::ellint_1(k), E = boost::math::ellint_2(k);
    Harness harness = cantilever(uniformRod(), kWeightless);
    harness.loads = {loadAt(0, kLength, {-K * K * kEI / (kLength * kLength), 0.0, 0.0})};
    const Equilibrium result = solve(harness);
    ASSERT_TRUE(result.converged()) << result.message;
    EXPECT_GT(result.smallest_eigenvalue, -1e-9);  // turning about the axis is neutral
    const Vector3d tip = result.shapes[0].points.back().pose.position;
    EXPECT_NEAR(tip.x(), kLength * (2.0 * E / K - 1.0), 1e-5 * kLength);
    EXPECT_NEAR(tip.tail<2>().norm(), kLength * 2.0 * k / K, 1e-5 * kLength);
  }
}

}  // namespace
}  // namespace cable_variation::test
