// A cable's properties along its length: the values given, their slopes, and the steps a grid must respect.

#include <cable_variation/rod/profile.h>

#include <gtest/gtest.h>

#include <equilibrium/cases.h>

namespace cable_variation::test {
namespace {

const Material kRubber{6e6, 0.45, 1200.0};

Cable varyingCable() {
  Cable cable = uniformCable(0.4, solidSection(0.004, kRubber));
  cable.sections = {{0.05, solidSection(0.004, kRubber)},
                    {0.15, solidSection(0.006, kRubber)},
                    {0.15, solidSection(0.008, kRubber)},
                    {0.30, solidSection(0.005, kRubber)}};
  cable.rest_curvature = {{0.05, {0.1, 1.0, 2.0}},
                          {0.12, {0.0, 3.0, -1.0}},
                          {0.2, {-0.2, 2.0, 5.0}},
                          {0.2, {0.0, 7.0, 0.0}},
                          {0.35, {0.4, 0.0, 1.0}}};
  return cable;
}

TEST(RodProfile, InterpolatesSectionsLinearly) {
  const RodProfile profile(varyingCable());
  const Section a = solidSection(0.004, kRubber), b = solidSection(0.006, kRubber),
                c = solidSection(0.008, kRubber);
  EXPECT_EQ(profile.at(0.0).stiffness[0], a.EA);  // the first section holds before its place
  EXPECT_NEAR(profile.at(0.10).stiffness[0], 0.5 * (a.EA + b.EA), 1e-12 * a.EA);
  EXPECT_NEAR(profile.at(0.10).mass_per_length, 0.5 * (a.mass_per_length + b.mass_per_length), 1e-15);
  EXPECT_NEAR(profile.at(0.10).radius, 0.005, 1e-15);
  EXPECT_EQ(profile.at(0.15).stiffness[4], c.EI_y);  // at a step the side s+
  EXPECT_NEAR(profile.at(0.15 - 1e-12).stiffness[4], b.EI_y, 1e-9 * b.EI_y);
  EXPECT_EQ(profile.at(0.40).stiffness[3], solidSection(0.005, kRubber).GJ);  // the last one after its place
}

TEST(RodProfile, OrdersStiffnessAsTheRodNeedsIt) {
  Section section{1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 0.7, 0.001};
  const RodProperties p = RodProfile(uniformCable(1.0, section)).at(0.3);
  for (int k = 0; k < 6; ++k) EXPECT_EQ(p.stiffness[k], k + 1.0);
  EXPECT_EQ(p.mass_per_length, 0.7);
  EXPECT_TRUE(p.stiffness_slope.isZero(0.0));
}

TEST(RodProfile, PassesThroughTheRestCurvatureGiven) {
  const Cable cable = varyingCable();
  const RodProfile profile(cable);
  for (std::size_t i : {0u, 1u, 4u}) {
    const RestCurvatureAt& knot = cable.rest_curvature[i];
    EXPECT_LT((profile.at(knot.arc_length).rest_curvature - knot.curvature).norm(), 1e-12) << "knot " << i;
  }
  EXPECT_LT((profile.at(0.2 - 1e-12).rest_curvature - cable.rest_curvature[2].curvature).norm(), 1e-8);
  EXPECT_LT((profile.at(0.2 + 1e-12).rest_curvature - cable.rest_curvature[3].curvature).norm(), 1e-8);
  EXPECT_EQ(profile.at(0.0).rest_curvature, cable.rest_curvature.front().curvature);
  EXPECT_EQ(profile.at(0.4).rest_curvature, cable.rest_curvature.back().curvature);
}

// Hermite pieces with slopes from three knots reproduce a parabola.
TEST(RodProfile, ReproducesAParabola) {
  const auto parabola = [](double s) {
    return Eigen::Vector3d(0.0, 1.0 + 3.0 * s - 20.0 * s * s, 5.0 * s * s);
  };
  Cable cable = uniformCable(0.4, solidSection(0.004, kRubber));
  for (double s : {0.0, 0.05, 0.13, 0.2, 0.32, 0.4}) cable.rest_curvature.push_back({s, parabola(s)});
  const RodProfile profile(cable);
  // the first and the last piece have a one-sided slope
  for (double s : {0.06, 0.1, 0.15, 0.19, 0.25, 0.31}) {
    EXPECT_LT((profile.at(s).rest_curvature - parabola(s)).norm(), 1e-12) << s;
  }
}

TEST(RodProfile, SlopesAreThoseOfTheValues) {
  const RodProfile profile(varyingCable());
  const double h = 1e-6;
  for (double s : {0.02, 0.07, 0.11, 0.13, 0.18, 0.22, 0.29, 0.33, 0.38}) {
    const RodProperties here = profile.at(s), ahead = profile.at(s + h), behind = profile.at(s - h);
    // central differences: h² and rounding of 1e-16/h
    const auto slope = [h](const auto& a, const auto& b) { return ((a - b) / (2.0 * h)).eval(); };
    EXPECT_LT((slope(ahead.stiffness, behind.stiffness) - here.stiffness_slope).norm(),
              1e-7 * here.stiffness[0]);
    EXPECT_NEAR((ahead.mass_per_length - behind.mass_per_length) / (2.0 * h), here.mass_slope, 1e-8);
    EXPECT_LT((slope(ahead.rest_curvature, behind.rest_curvature) - here.rest_curvature_slope).norm(), 1e-5);
    EXPECT_LT(
        (slope(ahead.rest_curvature_slope, behind.rest_curvature_slope) - here.rest_curvature_second).norm(),
        1e-3);
  }
}

TEST(RodProfile, BreaksAreSectionKnotsAndStepsOfTheRestCurvature) {
  EXPECT_EQ(RodProfile(varyingCable()).breaks(), (std::vector<double>{0.05, 0.15, 0.2, 0.3}));
  EXPECT_TRUE(RodProfile(uniformCable(0.4, solidSection(0.004, kRubber))).breaks().empty());
}

TEST(SectionAt, AgreesWithTheProfile) {
  const Cable cable = varyingCable();
  const RodProfile profile(cable);
  for (double s : {-1.0, 0.0, 0.05, 0.09, 0.15, 0.2, 0.3, 0.4, 9.0}) {
    const double inside = std::min(std::max(s, 0.0), cable.length);
    EXPECT_NEAR(sectionAt(cable, s).EI_z, profile.at(inside).stiffness[5], 1e-15) << s;
  }
}

}  // namespace
}  // namespace cable_variation::test
