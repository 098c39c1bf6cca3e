// Elasticas that touch a plane, against shooting: where they touch, how hard, and what their clamps bear.

#include <gtest/gtest.h>

#include <contact/contact_cases.h>
#include <contact/planar_elastica.h>

namespace cable_variation::test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kGravity = 9.81;
constexpr double kRadius = 0.004;
// Inextensible next to its bending: the oracles know no stretch and no shear.
Section stiffInStretch(double EI, double mass_per_length) {
  return roundSection(1e6 * EI, 1e6 * EI, 0.8 * EI, EI, mass_per_length, kRadius);
}

TriangleMesh table(int fields = 1) {
  return rectangle(Vector2d(-0.5, -0.5), Vector2d(1.5, 0.5), fields, fields);
}

Harness onTable(const Cable& cable, const Pose& start, const Vector3d& gravity) {
  Harness harness = cantilever(cable, gravity);
  harness.clips[0].pose = start;
  harness.contacts = {contactWith("table", table())};
  return harness;
}

void expectTouches(const Equilibrium& result) {
  EXPECT_GT(result.smallest_gap, -1e-5);
  EXPECT_LT(result.smallest_gap, 1e-5);
  for (const ContactInterval& interval : result.contacts) {
    for (const ContactForce& place : interval.places) EXPECT_GT(place.force, 0.0);
  }
}

// A heavy cable is held at a height and lies on a table further on. Where it lifts off, its weight, its
// bending and the table's point force there decide; nothing pulls along it.
TEST(Elastica, LiftedOffATable) {
  const double EI = 1e-2, mass = 0.1, length = 1.0, weight = mass * kGravity;
  for (const double height : {0.01, 0.05, 0.15}) {
    const Equilibrium result =
        EquilibriumSolver().solve(onTable(uniformCable(length, stiffInStretch(EI, mass)),
                                          poseAt(0.0, 0.0, height + kRadius), {0.0, 0.0, -kGravity}));
    ASSERT_TRUE(result.converged()) << height << ": " << result.message;
    expectTouches(result);

    // from where it touches to the clamp: x to the left, z, angle, moment
    const auto clampOf = [&](const Vector2d& unknown) {  // lifted length, point force
      return integrate(Planar::Zero(), unknown[0], 400, [&](double s, const Planar& at) {
        return Planar(std::cos(at[2]), std::sin(at[2]), at[3] / EI,
                      (unknown[1] - weight * s) * std::cos(at[2]));
      });
    };
    const double guess = std::pow(72.0 * EI * height / weight, 0.25);
    const Vector2d lifted = rootOf<2>(
        [&](const Vector2d& unknown) {
          const Planar clamp = clampOf(unknown);
          return Vector2d(clamp[2], (clamp[1] - height) / height);
        },
        Vector2d(guess, weight * guess / 3.0), Vector2d(guess, weight * guess));
    const Planar clamp = clampOf(lifted);

    ASSERT_EQ(result.contacts.size(), 1U) << height;
    // known to where the cable is a hundredth of a millimetre up: F u³ / 6 EI beyond
    const double known = std::cbrt(6.0 * EI * 1e-5 / lifted[1]);
    EXPECT_NEAR(result.contacts[0].start, lifted[0], known) << height;
    EXPECT_NEAR(result.contacts[0].end, length, 1e-3) << height;
    const double carried = weight * (length - lifted[0]) + lifted[1];
    EXPECT_NEAR(result.contacts[0].force.z(), carried, 1e-3 * carried) << height;
    EXPECT_NEAR(result.clip_reactions[0].force.z(), weight * lifted[0] - lifted[1],
                2e-3 * weight * lifted[0]);
    EXPECT_NEAR(std::abs(result.clip_reactions[0].moment.y()), std::abs(clamp[3]), 4e-3 * std::abs(clamp[3]))
        << height;
  }
}

// A cantilever without weight points down at a table: its end touches.
TEST(Elastica, EndPressedOnATable) {
  const double EI = 1e-2, length = 0.3, height = 0.02;
  for (const double tilt : {0.08, 0.09, 0.1}) {
    const Equilibrium result = EquilibriumSolver().solve(
        onTable(uniformCable(length, stiffInStretch(EI, 0.0)),
                poseAt(0.0, 0.0, height + kRadius, {0.0, tilt, 0.0}), Vector3d::Zero()));
    ASSERT_TRUE(result.converged()) << tilt << ": " << result.message;
    expectTouches(result);
    // from the end to the clamp; the table pushes the end straight up
    const auto clampOf = [&](const Vector2d& unknown) {  // the end's angle below the horizon, its force
      return integrate(Planar(0.0, 0.0, unknown[0], 0.0), length, 400, [&](double, const Planar& at) {
        return Planar(std::cos(at[2]), std::sin(at[2]), at[3] / EI, unknown[1] * std::cos(at[2]));
      });
    };
    const Vector2d end = rootOf<2>(
        [&](const Vector2d& unknown) {
          const Planar clamp = clampOf(unknown);
          return Vector2d(clamp[2] - tilt, (clamp[1] - height) / height);
        },
        Vector2d(tilt, 0.0), Vector2d(1.0, 1.0));
    ASSERT_GT(end[0], 0.0) << "the end lies flat";
    ASSERT_EQ(result.contacts.size(), 1U);
    EXPECT_NEAR(result.contacts[0].start, length, 1e-9);
    EXPECT_NEAR(result.contacts[0].force.z(), end[1], 1e-3 * end[1]) << tilt;
    EXPECT_NEAR(result.shapes[0].points.back().pose.position.z(), kRadius, 1e-5);
  }
}

// A straight cantilever is lifted a little by the edge of a box that stands on it, which is between two of
// its places wherever it is: force and place by the beam's closed form, one place that presses, and no other
// that is closed.
TEST(Elastica, EdgeLiftsACantilever) {
  const double EI = 1e-2, length = 0.3, lift = 5e-4, side = 0.05;
  for (const double at : {0.1501, 0.1734, 0.2009, 0.2222}) {
    Harness harness = cantilever(uniformCable(length, stiffInStretch(EI, 0.0)), Vector3d::Zero());
    harness.clips[0].pose = Pose();
    const double edge = lift - kRadius;  // its height
    harness.contacts = {contactWith("box", box(Vector3d(side, 0.1, side)),
                                    poseAt(at, 0.0, edge - side / std::sqrt(2.0), {0.0, M_PI / 4.0, 0.0}))};
    const Equilibrium result = EquilibriumSolver().solve(harness);
    ASSERT_TRUE(result.converged()) << at << ": " << result.message;
    expectTouches(result);
    ASSERT_EQ(result.contacts.size(), 1U) << at;
    EXPECT_LT(result.contacts[0].end - result.contacts[0].start, 2e-5) << at;
    const double force = 3.0 * EI * lift / std::pow(at, 3);
    EXPECT_NEAR(result.contacts[0].force.z(), force, 2e-3 * force) << at;
    // the tube rolls by its radius times its slope there, towards the clamp
    EXPECT_NEAR(result.contacts[0].start, at - kRadius * 1.5 * lift / at, 2e-5) << at;
    EXPECT_LT((result.contacts[0].places[0].on_part - Vector3d(at, 0.0, edge)).norm(), 1e-6) << at;
  }
}

}  // namespace
}  // namespace cable_variation::test
