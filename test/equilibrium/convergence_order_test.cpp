// The nodes of equal elements converge with order six: Galerkin's cubic elements with three Gauss points.

#include <gtest/gtest.h>

#include <equilibrium/cases.h>
#include <equilibrium/fixed_grid.h>

namespace cable_variation::test {
namespace {

constexpr std::size_t kFinest = 64;

// The stable equilibrium on `elements` elements, reached from that of the finest grid.
Configuration equilibriumOn(const FixedGrid& finest, std::size_t elements) {
  FixedGrid coarse(finest.harness, elements);
  coarse.configuration = transfer(finest.configuration, finest.system.grid(), coarse.system.grid());
  const Minimum minimum = minimise(coarse.system, coarse.configuration);
  EXPECT_TRUE(minimum.stable());
  return coarse.configuration;
}

double nodeError(const FixedGrid& finest, std::size_t elements) {
  const Configuration coarse = equilibriumOn(finest, elements);
  double largest = 0.0;
  for (std::size_t k = 0; k <= elements; ++k) {
    const Eigen::Vector3d& exact = finest.configuration.spans[0].positions[3 * k * kFinest / elements];
    largest = std::max(largest, (coarse.spans[0].positions[3 * k] - exact).norm());
  }
  return largest;
}

class ConvergenceOrder : public testing::TestWithParam<int> {};

TEST_P(ConvergenceOrder, NodesConvergeWithOrderSix) {
  FixedGrid finest(GetParam() == 0 ? caseH() : caseW(), kFinest);
  ASSERT_TRUE(minimise(finest.system, finest.configuration).stable());
  const double at_8 = nodeError(finest, 8), at_16 = nodeError(finest, 16), at_32 = nodeError(finest, 32);
  EXPECT_GT(std::log2(at_8 / at_16), 5.5);
  // of 32 elements the error is 1e-11 m, where rounding begins
  EXPECT_GT(std::log2(at_16 / at_32), 5.0);
  EXPECT_LT(at_32, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(CasesHAndW, ConvergenceOrder, testing::Values(0, 1));

}  // namespace
}  // namespace cable_variation::test
