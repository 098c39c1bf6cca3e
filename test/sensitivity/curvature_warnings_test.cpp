// Measures whose solved limits are off the straight lines of their derivatives.
#include <cable_variation/sensitivity/curvature_warnings.h>

#include <limits>

#include <gtest/gtest.h>

namespace cable_variation {
namespace {

// Two variables of +-2 and +-1; a measure of 3 m for each function of them, with its derivatives.
class CurvatureWarnings : public testing::Test {
 protected:
  CurvatureWarnings() {
    for (const double tolerance : {2.0, 1.0}) {
      DesignVariable variable;
      variable.name = tolerance > 1.5 ? "wide" : "narrow";
      variable.lower = -tolerance;
      variable.upper = tolerance;
      scene_.design_variables.push_back(variable);
    }
    analysis_.variables = {0, 1};
  }

  // value + a x + b x^2 by the first variable, value + c x by the second
  void add(const std::string& name, double a, double b, double c) {
    constexpr double kValue = 3.0;
    Measure measure;
    measure.name = name;
    measure.unit = "N";
    const auto row = static_cast<Eigen::Index>(scene_.measures.size());
    analysis_.measures.push_back(scene_.measures.size());
    scene_.measures.push_back(measure);
    analysis_.values.emplace_back();
    analysis_.values.back().value = kValue;
    analysis_.undefined.emplace_back();
    analysis_.one_sided.push_back(false);
    analysis_.jacobian.conservativeResize(row + 1, 2);
    analysis_.jacobian.row(row) << a, c;
    analysis_.worst_high.conservativeResize(row + 1);
    analysis_.worst_low.conservativeResize(row + 1);
    analysis_.worst_high[row] = 2.0 * std::abs(a) + std::abs(c);
    analysis_.worst_low[row] = -analysis_.worst_high[row];
    analysis_.low_high.push_back(
        {{kValue - 2.0 * a + 4.0 * b, kValue + 2.0 * a + 4.0 * b}, {kValue - c, kValue + c}});
  }

  Scene scene_;
  StabilityAnalysis analysis_;
};

TEST_F(CurvatureWarnings, TellOfCurvesOnly) {
  add("line", 0.5, 0.0, 0.2);
  add("nearly", 0.5, 0.03, 0.2);  // 0.12 of 1.2
  add("bent", 0.5, 0.1, 0.2);     // 0.4 of 1.4
  add("even", 0.0, 0.1, 0.0);     // no derivative at all
  add("noise", 0.0, 1e-7, 0.0);
  const std::vector<std::string> warnings = curvatureWarnings(scene_, analysis_);
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_EQ(warnings[0].rfind("bent: ", 0), 0U) << warnings[0];
  EXPECT_NE(
      warnings[0].find("tolerance of wide: 2.4 N at its lower limit, 3 N in the design, 4.4 N at its upper"),
      std::string::npos)
      << warnings[0];
  EXPECT_EQ(warnings[1].rfind("even: ", 0), 0U) << warnings[1];
}

TEST_F(CurvatureWarnings, NothingOfWhatIsNotDefinedOrNotSolved) {
  add("bent", 0.5, 0.1, 0.2);
  analysis_.low_high[0][0] = {std::numeric_limits<double>::quiet_NaN(),
                              std::numeric_limits<double>::quiet_NaN()};
  EXPECT_TRUE(curvatureWarnings(scene_, analysis_).empty());
  add("undefined", 0.5, 0.1, 0.2);
  analysis_.undefined.back() = "no value";
  add("from the design on", 0.5, 0.1, 0.2);
  analysis_.one_sided.back() = true;
  EXPECT_TRUE(curvatureWarnings(scene_, analysis_).empty());
}

}  // namespace
}  // namespace cable_variation
