// Stiffness of solid, hose and rectangular sections against textbook values.

#include <cable_variation/rod/section.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace cable_variation {
namespace {

const Material kMaterial{2e6, 0.25, 1000.0};  // G = 0.8e6 Pa

TEST(SolidSection, HasTheStiffnessOfACircle) {
  const Section s = solidSection(0.01, kMaterial, 0.9);
  EXPECT_DOUBLE_EQ(s.EA, 2e6 * M_PI * 1e-4);
  EXPECT_DOUBLE_EQ(s.GA_y, 0.9 * 0.8e6 * M_PI * 1e-4);
  EXPECT_DOUBLE_EQ(s.GA_z, s.GA_y);
  EXPECT_DOUBLE_EQ(s.EI_y, 2e6 * M_PI * 1e-8 / 4.0);
  EXPECT_DOUBLE_EQ(s.EI_z, s.EI_y);
  EXPECT_DOUBLE_EQ(s.GJ, 0.8e6 * M_PI * 1e-8 / 2.0);
  EXPECT_DOUBLE_EQ(s.mass_per_length, 1000.0 * M_PI * 1e-4);
  EXPECT_EQ(s.radius, 0.01);
  EXPECT_EQ(s.young_modulus, 2e6);
  EXPECT_EQ(s.shear_modulus, 0.8e6);
  EXPECT_EQ(s.width, 0.0);
}

TEST(HoseSection, IsTheOuterCircleLessTheInner) {
  const Section outer = solidSection(0.012, kMaterial), inner = solidSection(0.009, kMaterial);
  const Section hose = hoseSection(0.012, 0.009, kMaterial);
  EXPECT_NEAR(hose.EA, outer.EA - inner.EA, 1e-12 * outer.EA);
  EXPECT_NEAR(hose.EI_y, outer.EI_y - inner.EI_y, 1e-12 * outer.EI_y);
  EXPECT_NEAR(hose.GJ, outer.GJ - inner.GJ, 1e-12 * outer.GJ);
  EXPECT_NEAR(hose.mass_per_length, outer.mass_per_length - inner.mass_per_length, 1e-12);
  EXPECT_EQ(hose.radius, 0.012);
}

TEST(RectangleSection, BendsAboutItsAxesByWidthAndHeight) {
  const Section s = rectangleSection(0.02, 0.01, kMaterial);  // 20 mm along y, 10 mm along z
  EXPECT_NEAR(s.EA, 2e6 * 2e-4, 1e-9);
  EXPECT_NEAR(s.EI_y, 2e6 * 0.02 * 1e-6 / 12.0, 1e-15);
  EXPECT_NEAR(s.EI_z, 2e6 * 0.01 * 8e-6 / 12.0, 1e-15);
  EXPECT_NEAR(s.radius, std::hypot(0.01, 0.005), 1e-15);
  EXPECT_EQ(s.width, 0.02);
  EXPECT_EQ(s.height, 0.01);
}

// Timoshenko and Goodier, table of k₁ in J = k₁ a b³: 0.1406 for a square, 0.196 at 3:2, 0.229 at 2:1, 0.312
// at 10:1.
TEST(RectangleSection, HasSaintVenantsTorsionConstant) {
  const auto k1 = [](double ratio) {
    const double b = 0.01, a = ratio * b;
    EXPECT_DOUBLE_EQ(rectangleSection(a, b, kMaterial).GJ, rectangleSection(b, a, kMaterial).GJ);
    return rectangleSection(a, b, kMaterial).GJ / (0.8e6 * a * b * b * b);
  };
  EXPECT_NEAR(k1(1.0), 0.1406, 5e-5);
  EXPECT_NEAR(k1(1.5), 0.196, 5e-4);
  EXPECT_NEAR(k1(2.0), 0.229, 5e-4);
  EXPECT_NEAR(k1(10.0), 0.312, 1e-3);
}

TEST(Interpolate, BlendsEveryMember) {
  const Section a{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12},
      b{11, 22, 33, 44, 55, 66, 77, 88, 99, 110, 121, 132};
  const Section m = interpolate(a, b, 0.3);
  EXPECT_DOUBLE_EQ(m.EA, 4.0);
  EXPECT_DOUBLE_EQ(m.GA_y, 8.0);
  EXPECT_DOUBLE_EQ(m.GA_z, 12.0);
  EXPECT_DOUBLE_EQ(m.GJ, 16.0);
  EXPECT_DOUBLE_EQ(m.EI_y, 20.0);
  EXPECT_DOUBLE_EQ(m.EI_z, 24.0);
  EXPECT_DOUBLE_EQ(m.mass_per_length, 28.0);
  EXPECT_DOUBLE_EQ(m.radius, 32.0);
  EXPECT_DOUBLE_EQ(m.young_modulus, 36.0);
  EXPECT_DOUBLE_EQ(m.shear_modulus, 40.0);
  EXPECT_DOUBLE_EQ(m.width, 44.0);
  EXPECT_DOUBLE_EQ(m.height, 48.0);
}

// Where one side's modulus is not known, or one is round, the blend does not pretend to know.
TEST(Interpolate, KnowsAModulusOrARectangleOnlyBetweenTwo) {
  const Section rectangle = rectangleSection(0.02, 0.01, kMaterial);
  Section measured = solidSection(0.01, kMaterial);
  measured.young_modulus = measured.shear_modulus = 0.0;
  const Section m = interpolate(rectangle, measured, 0.5);
  EXPECT_EQ(m.young_modulus, 0.0);
  EXPECT_EQ(m.shear_modulus, 0.0);
  EXPECT_EQ(m.width, 0.0);
  EXPECT_EQ(m.height, 0.0);
}

template <class Call>
std::string refusalOf(const Call& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "taken";
}

TEST(Sections, RefuseWhatIsNoSection) {
  EXPECT_EQ(refusalOf([] { solidSection(0.0, kMaterial); }), "radius is 0, expected a positive number");
  EXPECT_EQ(refusalOf([] {
              solidSection(0.01, {-1.0, 0.3, 1.0});
            }),
            "young_modulus is -1, expected a positive number");
  EXPECT_EQ(refusalOf([] {
              solidSection(0.01, {1.0, 0.6, 1.0});
            }),
            "poisson_ratio is 0.6, expected more than -1 and at most 0.5");
  EXPECT_EQ(refusalOf([] { solidSection(0.01, {1.0, 0.3, -2.0}); }), "density is -2, expected zero or more");
  EXPECT_EQ(refusalOf([] { solidSection(0.01, kMaterial, 0.0); }),
            "shear_correction is 0, expected a positive number");
  EXPECT_EQ(refusalOf([] { hoseSection(0.01, 0.01, kMaterial); }),
            "inner_radius is 0.01 m, expected less than the outer_radius of 0.01 m");
  EXPECT_EQ(refusalOf([] { rectangleSection(0.01, -0.01, kMaterial); }),
            "height is -0.01, expected a positive number");
}

}  // namespace
}  // namespace cable_variation
