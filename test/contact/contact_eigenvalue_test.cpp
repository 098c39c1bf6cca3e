// The smallest eigenvalue of cables that touch: closed forms, an independent dense chain, and no trace of how
// stiff the solver makes gaps.

#include <gtest/gtest.h>

#include <cable_variation/equilibrium/search/lowest_shape.h>
#include <cable_variation/equilibrium/search/smallest_eigenvalue.h>

#include <contact/contact_cases.h>
#include <contact/link_chain.h>

namespace cable_variation::test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kRadius = 0.004, kLength = 0.3, kEI = 1e-2;

// So much stiffer out of the plane y = 0, in twist, stretch and shear, that the softest motion is in it.
Section softInPlane(double mass_per_length = 0.0) {
  return {1e8 * kEI, 1e8 * kEI, 1e8 * kEI, 200.0 * kEI, kEI, 200.0 * kEI, mass_per_length, kRadius};
}

TriangleMesh table() { return rectangle(Vector2d(-0.5, -0.5), Vector2d(1.5, 0.5)); }

// The shape of an in-plane result as a chain's start.
Eigen::VectorXd anglesOf(const CableShape& shape, Eigen::Index links) {
  Eigen::VectorXd angles(links);
  for (Eigen::Index j = 0; j < links; ++j) {
    const double s = shape.points.back().arc_length / static_cast<double>(links);
    const Vector3d way =
        shape.position(s * static_cast<double>(j + 1)) - shape.position(s * static_cast<double>(j));
    angles[j] = std::atan2(way.z(), way.x());
  }
  return angles;
}

// A clamped beam whose end is propped by the table.
TEST(ContactEigenvalue, OfAProppedCantilever) {
  constexpr double kTilt = 0.01, kHeight = 0.9 * kTilt * kLength;
  Harness harness = cantilever(uniformCable(kLength, softInPlane()), Vector3d::Zero());
  harness.clips[0].pose = poseAt(0.0, 0.0, kHeight + kRadius, {0.0, kTilt, 0.0});
  harness.contacts = {contactWith("table", table())};
  const Equilibrium result = EquilibriumSolver().solve(harness);
  ASSERT_TRUE(result.converged()) << result.message;
  ASSERT_EQ(result.contacts.size(), 1U);
  const double root = 3.926602, wave = root / kLength;
  // with the cable's own turning in the metric, to first order: ∫w'² over ∫w² of the mode is 11.5/L²
  const double expected =
      kEI * std::pow(wave, 4) * kLength / (1.0 + 0.5 * kRadius * kRadius * 11.5 / (kLength * kLength));
  EXPECT_NEAR(result.smallest_eigenvalue, expected, 1e-3 * expected);
}

// About an edge, with a force that bends the cable much: it rolls and slides there.
TEST(ContactEigenvalue, OfACantileverOverAnEdge) {
  constexpr double kSide = 0.05;
  for (const double lift : {0.002, 0.01, 0.03}) {
    const Vector2d edge(0.151, lift - kRadius);
    Harness harness = cantilever(uniformCable(kLength, softInPlane()), Vector3d::Zero());
    harness.contacts = {
        contactWith("box", box(Vector3d(kSide, 0.1, kSide)),
                    poseAt(edge.x(), 0.0, edge.y() - kSide / std::sqrt(2.0), {0.0, M_PI / 4.0, 0.0}))};
    const Equilibrium result = EquilibriumSolver().solve(harness);
    ASSERT_TRUE(result.converged()) << lift << ": " << result.message;
    ASSERT_EQ(result.contacts.size(), 1U);
    LinkChain chain;
    chain.length = kLength;
    chain.EI = kEI;
    chain.radius = kRadius;
    chain.near = [&](const Vector2d& x) { return (x - edge).squaredNorm(); };
    chain.gap = [](double squared) { return std::sqrt(squared) - kRadius; };
    chain.angles = anglesOf(result.shapes[0], 100);
    ASSERT_LT(chain.settle(), 1e-7);
    EXPECT_NEAR(result.contacts[0].total, chain.multipliers[0], 5e-3 * chain.multipliers[0]) << lift;
    const double expected = chain.smallestEigenvalue();
    EXPECT_NEAR(result.smallest_eigenvalue, expected, 1e-2 * expected) << lift;
  }
}

// Where the elements tell too little of the gap about what presses, none is answered.
TEST(ContactEigenvalue, IsNotAnsweredInAFlatPlace) {
  Harness lying = clamped(uniformCable(kLength, softInPlane(0.1)), poseAt(kLength, 0.0, kRadius));
  lying.clips[0].pose = poseAt(0.0, 0.0, kRadius);
  lying.contacts = {contactWith("table", table())};
  Harness hanging =
      clamped(uniformCable(0.5, roundSection(1e4, 4e3, 8e-3, 1e-2, 0.1, kRadius)), poseAt(0.4, 0.05, 0.03));
  hanging.clips[0].pose = poseAt(0.0, 0.0, 0.05);
  hanging.contacts = {contactWith("table", table())};
  for (const Harness& harness : {lying, hanging}) {
    const Equilibrium result = EquilibriumSolver().solve(harness);
    ASSERT_TRUE(result.converged()) << result.message;
    ASSERT_FALSE(result.contacts.empty());
    EXPECT_TRUE(std::isnan(result.smallest_eigenvalue));
  }
}

// What presses is held, not pushed back by the stiffness that descents are fast with.
TEST(ContactEigenvalue, DoesNotKnowHowStiffGapsAre) {
  Harness harness =
      clamped(uniformCable(0.5, roundSection(1e4, 4e3, 8e-3, 1e-2, 0.1, kRadius)), poseAt(0.4, 0.05, 0.03));
  harness.clips[0].pose = poseAt(0.0, 0.0, 0.05);
  harness.contacts = {contactWith("table", table())};
  Equilibrium result;
  const std::unique_ptr<Branch> branch = lowestShape(harness, {}, result);
  ASSERT_TRUE(branch) << result.message;
  branch->letPointsMove();
  RodSystem& system = *branch->problem().system;
  std::vector<double> eigenvalues, pushed_back;
  for (const double softness : {1e-4, 1e-2, 1.0}) {
    system.contact()->soften(softness);
    system.evaluate(branch->problem().configuration, RodSystem::Hessian::exact);
    pushed_back.push_back(smallestEigenvalue(system, branch->problem().configuration));
    system.evaluate(branch->problem().configuration, RodSystem::Hessian::exact);
    eigenvalues.push_back(smallestEigenvalueInContact(system, branch->problem().configuration));
  }
  EXPECT_GT(eigenvalues[1], 0.0);
  EXPECT_NEAR(eigenvalues[0], eigenvalues[1], 1e-6 * eigenvalues[1]);
  // the force itself is known to that: by the stiffness times a gap of some 1e-10 m
  EXPECT_NEAR(eigenvalues[2], eigenvalues[1], 1e-4 * eigenvalues[1]);
  EXPECT_LT(pushed_back[0], 0.9 * eigenvalues[0]);
  EXPECT_NEAR(pushed_back[2], eigenvalues[2], 1e-2 * eigenvalues[2]);
}

}  // namespace
}  // namespace cable_variation::test
