// The accuracy asked for is kept, and the error reported bounds the true one, on every kind of harness.

#include <gtest/gtest.h>

#include <equilibrium/case_table.h>

namespace cable_variation::test {
namespace {

double largestDistanceBetween(const Equilibrium& a, const Equilibrium& b) {
  double largest = 0.0;
  for (std::size_t c = 0; c < a.shapes.size(); ++c) {
    const std::vector<Pose> on_a = a.shapes[c].sample(201), on_b = b.shapes[c].sample(201);
    for (std::size_t i = 0; i < on_a.size(); ++i) {
      largest = std::max(largest, (on_a[i].position - on_b[i].position).norm());
    }
  }
  return largest;
}

class Discretisation : public testing::TestWithParam<NamedHarness> {};

TEST_P(Discretisation, ErrorStaysBelowAccuracyAndBelowItsEstimate) {
  const Equilibrium exact = solve(GetParam().harness, 1e-9);
  ASSERT_TRUE(exact.converged()) << exact.message;
  for (double accuracy : {1e-3, 1e-4, 1e-5, 1e-6}) {
    const Equilibrium result = solve(GetParam().harness, accuracy);
    ASSERT_TRUE(result.converged()) << result.message;
    const double error = largestDistanceBetween(result, exact);
    EXPECT_LE(error, accuracy);
    // a fifth more: a rest curvature given by knots is smooth between them only, which costs orders
    EXPECT_LE(error, 1.2 * result.discretisation_error) << "accuracy " << accuracy;
  }
}

INSTANTIATE_TEST_SUITE_P(Sections, Discretisation, testing::ValuesIn(harnessPerSection()), harnessName);
INSTANTIATE_TEST_SUITE_P(Clips, Discretisation, testing::ValuesIn(harnessPerClip()), harnessName);
INSTANTIATE_TEST_SUITE_P(Joints, Discretisation, testing::ValuesIn(harnessPerJoint()), harnessName);

}  // namespace
}  // namespace cable_variation::test
