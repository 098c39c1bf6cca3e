// Two cantilevers of the literature, with converged tip positions.

#include <gtest/gtest.h>

#include <equilibrium/cases.h>

namespace cable_variation::test {
namespace {

const Eigen::Vector3d kWeightless = Eigen::Vector3d::Zero();

struct BendCase {
  double torsion_constant, force;
  Eigen::Vector3d tip;  ///< converged
};

// Bathe and Bolourchi 1979: an eighth of a circle of radius 100, unit square section, load out of its plane.
Harness bend(double torsion_constant, double force) {
  const double E = 1e7, G = 5e6, radius = 100.0;
  Section section{E, G, G, G * torsion_constant, E / 12.0, E / 12.0, 0.0, std::sqrt(0.5)};
  Cable cable = uniformCable(radius * M_PI / 4.0, section);
  cable.rest_curvature = {{0.0, {0.0, 0.0, -1.0 / radius}}};
  Harness harness = cantilever(cable, kWeightless);
  harness.clips[0].pose.orientation = so3::exp({0.0, 0.0, M_PI / 2.0});
  harness.clips.push_back(clipOn(0, "tip", cable.length, freeClip()));
  harness.loads = {loadAt(0, cable.length, {0.0, 0.0, force})};
  return harness;
}

TEST(FortyFiveDegreeBend, UnloadedTipIsTheCircles) {
  const Equilibrium result = solve(bend(1.0 / 6.0, 0.0), 1e-6);
  ASSERT_TRUE(result.converged()) << result.message;
  const double half = 100.0 * std::sqrt(0.5);
  EXPECT_LT((result.shapes[0].points.back().pose.position - Eigen::Vector3d(100.0 - half, half, 0.0)).norm(),
            1e-6);
}

class FortyFiveDegreeBend : public testing::TestWithParam<BendCase> {};

// Half a unit of the last of the table's digits, per component.
TEST_P(FortyFiveDegreeBend, TipAgreesWithTheConvergedTable) {
  const Equilibrium result = solve(bend(GetParam().torsion_constant, GetParam().force), 1e-6);
  ASSERT_TRUE(result.converged()) << result.message;
  const Eigen::Vector3d tip = result.shapes[0].points.back().pose.position;
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(tip[k], GetParam().tip[k], 0.6e-4) << "axis " << k;
}

INSTANTIATE_TEST_SUITE_P(Table, FortyFiveDegreeBend,
                         testing::Values(BendCase{1.0 / 6.0, 300.0, {22.2448, 58.7791, 40.1919}},
                                         BendCase{1.0 / 6.0, 600.0, {15.6848, 47.1504, 53.4749}},
                                         BendCase{0.1406, 300.0, {22.1128, 58.5362, 40.4800}},
                                         BendCase{0.1406, 600.0, {15.5579, 46.8922, 53.6072}}));

// Simo and Vu-Quoc 1986 with eight linear elements, J = 1/6: 0.2 is their discretisation.
TEST(FortyFiveDegreeBend, AgreesWithThePublishedTipsToTheirDiscretisation) {
  const Eigen::Vector3d at_300 = solve(bend(1.0 / 6.0, 300.0), 1e-4).shapes.at(0).points.back().pose.position;
  const Eigen::Vector3d at_600 = solve(bend(1.0 / 6.0, 600.0), 1e-4).shapes.at(0).points.back().pose.position;
  EXPECT_LT((at_300 - Eigen::Vector3d(22.33, 58.84, 40.08)).cwiseAbs().maxCoeff(), 0.2);
  EXPECT_LT((at_600 - Eigen::Vector3d(15.79, 47.23, 53.37)).cwiseAbs().maxCoeff(), 0.2);
}

struct PrincetonRow {
  double beta;                ///< load against the wide direction [deg]
  double along_wide, across;  ///< tip displacement along the wide and the thin direction [mm]
};

class PrincetonBeam : public testing::TestWithParam<PrincetonRow> {};

// The beam of Dowell and Traybar, 8.896 N at its tip; half a unit of the table's last digit.
TEST_P(PrincetonBeam, TipAgreesWithTheTable) {
  const double length = 0.508, wide = 12.3777e-3, thin = 3.2024e-3, E = 71.7e9, G = E / (2.0 * 1.31);
  const double about_thin = thin * wide * wide * wide / 12.0, about_wide = wide * thin * thin * thin / 12.0;
  const Section section{E * wide * thin,
                        G * wide * thin,
                        G * wide * thin,
                        G * 0.198 * (about_thin + about_wide),
                        E * about_wide,
                        E * about_thin,
                        0.0,
                        0.5 * wide};
  const double beta = GetParam().beta * M_PI / 180.0;
  Harness harness = cantilever(uniformCable(length, section), kWeightless);
  harness.clips.push_back(clipOn(0, "tip", length, freeClip()));
  harness.loads = {loadAt(0, length, 8.896 * Eigen::Vector3d(0.0, std::cos(beta), std::sin(beta)))};
  const Equilibrium result = solve(harness, 1e-7);
  ASSERT_TRUE(result.converged()) << result.message;
  const Eigen::Vector3d tip = result.shapes[0].points.back().pose.position;
  EXPECT_NEAR(1e3 * tip.y(), GetParam().along_wide, 0.6e-3);
  EXPECT_NEAR(1e3 * tip.z(), GetParam().across, 0.6e-3);
}

INSTANTIATE_TEST_SUITE_P(Table, PrincetonBeam,
                         testing::Values(PrincetonRow{0.0, 10.713, 0.0}, PrincetonRow{30.0, 10.208, 79.547},
                                         PrincetonRow{60.0, 6.742, 129.958},
                                         PrincetonRow{90.0, 0.0, 146.252}));

}  // namespace
}  // namespace cable_variation::test
