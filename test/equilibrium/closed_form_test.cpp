// Cantilevers that have a closed form: elastica, roll-up into circles, helices.

#include <gtest/gtest.h>

#include <equilibrium/cases.h>

namespace cable_variation::test {
namespace {

const Eigen::Vector3d kWeightless = Eigen::Vector3d::Zero();

Harness loadedCantilever(const Section& section, const Eigen::Vector3d& force,
                         const Eigen::Vector3d& moment) {
  Harness harness = cantilever(uniformCable(1.0, section), kWeightless);
  harness.clips.push_back(clipOn(0, "tip", 1.0, freeClip()));
  harness.loads = {loadAt(0, 1.0, force, moment)};
  return harness;
}

struct ElasticaRow {
  double alpha, across, along, tip_angle;  ///< PL²/EI; w/L, u/L, θ [rad]
};

class Elastica : public testing::TestWithParam<ElasticaRow> {};

// Inextensible and unshearable up to strains of α/EA ≤ 1e-6; the table has six digits.
TEST_P(Elastica, TipAgreesWithTheTable) {
  const ElasticaRow& row = GetParam();
  const Section section = roundSection(1e7, 1e7, 0.8, 1.0);
  const Equilibrium result = solve(loadedCantilever(section, {0.0, row.alpha, 0.0}, kWeightless), 1e-7);
  ASSERT_TRUE(result.converged()) << result.message;
  const Pose tip = result.shapes[0].points.back().pose;
  EXPECT_NEAR(tip.position.y(), row.across, 2e-6);
  EXPECT_NEAR(1.0 - tip.position.x(), row.along, 2e-6);
  EXPECT_NEAR(so3::log(tip.orientation).z(), row.tip_angle, 2e-6);
  EXPECT_NEAR(result.clip_reactions[0].moment.z(), -row.alpha * tip.position.x(), 1e-6 * row.alpha);
}

INSTANTIATE_TEST_SUITE_P(Table, Elastica,
                         testing::Values(ElasticaRow{1.0, .301721, .056433, .461352},
                                         ElasticaRow{2.0, .493457, .160642, .781750},
                                         ElasticaRow{5.0, .713792, .387628, 1.215368},
                                         ElasticaRow{10.0, .810609, .554996, 1.430286}));

class RollUp : public testing::TestWithParam<double> {};

TEST_P(RollUp, TipMomentBendsTheRodIntoAnArc) {
  const double t = GetParam();  // ML/EI
  const Section section = roundSection(1e4, 5e3, 0.8, 1.0);
  const Equilibrium result = solve(loadedCantilever(section, kWeightless, {0.0, 0.0, t}), 1e-7);
  ASSERT_TRUE(result.converged()) << result.message;
  for (int i = 0; i <= 20; ++i) {
    const double s = i / 20.0;
    const Eigen::Vector3d arc(std::sin(t * s) / t, (1.0 - std::cos(t * s)) / t, 0.0);
    EXPECT_LT((result.shapes[0].position(s) - arc).norm(), 1e-7) << "at " << s;
  }
  EXPECT_NEAR(result.energy.elastic, 0.5 * t * t, 1e-7 * t * t);
}

INSTANTIATE_TEST_SUITE_P(Moments, RollUp, testing::Values(0.3, 1.0, -2.0, M_PI, 4.5, 2.0 * M_PI));

struct HelixCase {
  double beta, GJ;  ///< angle between moment and tangent [rad], torsion stiffness over EI
};

class Helix : public testing::TestWithParam<HelixCase> {};

// The tangent turns about the moment at the rate m/EI, whatever GJ is: radius EI sin β/m, pitch 2π EI cos
// β/m.
TEST_P(Helix, EndMomentFixedInSpaceWindsTheRod) {
  const HelixCase& of = GetParam();
  const double m = 3.0;
  const Eigen::Vector3d axis(std::cos(of.beta), 0.0, std::sin(of.beta));
  const Section section = roundSection(1e4, 5e3, of.GJ, 1.0);
  const Equilibrium result = solve(loadedCantilever(section, kWeightless, m * axis), 1e-7);
  ASSERT_TRUE(result.converged()) << result.message;
  const double radius = std::sin(of.beta) / m, pitch = 2.0 * M_PI * std::cos(of.beta) / m;
  const Eigen::Vector3d outward = Eigen::Vector3d::UnitX().cross(axis).normalized();
  const Eigen::Vector3d third = axis.cross(outward);
  for (int i = 0; i <= 20; ++i) {
    const double s = i / 20.0;
    const Eigen::Vector3d helix = radius * ((std::cos(m * s) - 1.0) * outward + std::sin(m * s) * third) +
                                  pitch * m * s / (2.0 * M_PI) * axis;
    EXPECT_LT((result.shapes[0].position(s) - helix).norm(), 1e-7) << "at " << s;
  }
}

INSTANTIATE_TEST_SUITE_P(Angles, Helix,
                         testing::Values(HelixCase{0.5, 0.7}, HelixCase{0.5, 1.6}, HelixCase{1.1, 0.7},
                                         HelixCase{1.1, 1.6}, HelixCase{1.5, 0.7}));

}  // namespace
}  // namespace cable_variation::test
