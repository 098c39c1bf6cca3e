// Gradient against differences of energy, Hessian against differences of the
// gradient, for every section, clip preset and joint, away from equilibrium.

#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <equilibrium/case_table.h>
#include <equilibrium/fixed_grid.h>

namespace cable_variation::test {
namespace {

// Potential along a motion from `from`: energy less the work of dead moments, which have none of their own.
class AlongMotion {
 public:
  AlongMotion(FixedGrid& grid, NodalField motion) : grid_(grid), motion_(std::move(motion)) {}

  // Moves by `t` times the motion and evaluates there; returns the energy.
  double energyAt(double t) {
    grid_.system.evaluate(grid_.configuration,
                          RodSystem::Hessian::none);  // move() takes its effects from here
    NodalField step = motion_;
    step.scale(t);
    Configuration there = grid_.configuration;
    grid_.system.move(step, there);
    grid_.system.evaluate(there, RodSystem::Hessian::none);
    return grid_.system.energy().total();
  }

  // The derivative of the gradient along the motion, against `other`: fourth order in h.
  double gradientSlope(const NodalField& other) {
    const auto slope = [&](double h) {
      energyAt(h);
      const double ahead = grid_.system.gradient().dot(other);
      energyAt(-h);
      return (ahead - grid_.system.gradient().dot(other)) / (2.0 * h);
    };
    constexpr double kStep = 1e-4;
    return (4.0 * slope(kStep) - slope(2.0 * kStep)) / 3.0;
  }

 private:
  FixedGrid& grid_;
  NodalField motion_;
};

class Derivatives : public testing::TestWithParam<NamedHarness> {
 protected:
  void SetUp() override {
    grid_ = std::make_unique<FixedGrid>(GetParam().harness, 2);
    // off any equilibrium and any symmetry: by centimetres and tenths of radians
    const NodalField away = grid_->randomMotion(generator_, 0.01, 0.3);
    grid_->system.move(away, grid_->configuration);
  }

  std::mt19937 generator_{42};
  std::unique_ptr<FixedGrid> grid_;
};

TEST_P(Derivatives, GradientIsTheSlopeOfTheEnergy) {
  for (int trial = 0; trial < 4; ++trial) {
    const NodalField motion = grid_->randomMotion(generator_, 0.01, 1.0);
    AlongMotion along(*grid_, motion);
    // fourth order central difference; energies of joules carry 1e-16, over h: 1e-12
    const double h = 1e-4;
    const double difference =
        (8.0 * (along.energyAt(h) - along.energyAt(-h)) - along.energyAt(2 * h) + along.energyAt(-2 * h)) /
        (12.0 * h);
    const double energy = along.energyAt(0.0);
    // the work of dead moments is not part of the energy
    const Configuration& here = grid_->configuration;
    Configuration there = here;
    const double work = grid_->system.move(motion, there);
    EXPECT_NEAR(grid_->system.gradient().dot(motion), difference - work,
                1e-8 * (std::abs(energy) + std::abs(difference)));
  }
}

TEST_P(Derivatives, EveryUnknownHasItsOwnSlope) {
  grid_->system.evaluate(grid_->configuration, RodSystem::Hessian::none);
  const Eigen::VectorXd gradient = grid_->system.gradient().unknowns;
  ASSERT_GT(gradient.size(), 0);
  for (Eigen::Index i = 0; i < gradient.size(); ++i) {
    NodalField motion = grid_->system.zeroField();
    motion.unknowns[i] = 0.01;
    AlongMotion along(*grid_, motion);
    const double h = 1e-3;
    const double difference =
        (8.0 * (along.energyAt(h) - along.energyAt(-h)) - along.energyAt(2 * h) + along.energyAt(-2 * h)) /
        (12.0 * h);
    const double energy = along.energyAt(0.0);
    Configuration there = grid_->configuration;
    const double work = grid_->system.move(motion, there);
    EXPECT_NEAR(0.01 * gradient[i], difference - work, 1e-9 * (std::abs(energy) + std::abs(difference)))
        << "unknown " << i;
  }
}

// H is known through its inverse only: with x = H⁻¹ f, wᵀHx must be w·f for every w. In rotations wᵀHx is
// the mean of the gradient's slope along x against w and along w against x.
TEST_P(Derivatives, HessianIsTheSlopeOfTheGradient) {
  const auto metric = grid_->system.bendingMetric();
  for (int trial = 0; trial < 3; ++trial) {
    NodalField force = grid_->randomMotion(generator_, 1.0, 0.01);
    grid_->system.evaluate(grid_->configuration, RodSystem::Hessian::exact);
    grid_->system.factorise(0.0, metric, true);  // dead moments add a skew part
    NodalField motion;
    grid_->system.solve(force, motion);
    double size = 1e-300;
    for (const auto& nodes : motion.spans) {
      size = std::max({size, nodes.topRows<3>().cwiseAbs().maxCoeff() / 0.01,
                       nodes.bottomRows<3>().cwiseAbs().maxCoeff()});
    }
    motion.scale(1.0 / size);
    force.scale(1.0 / size);
    for (int w = 0; w < 3; ++w) {
      const NodalField other = grid_->randomMotion(generator_, 0.01, 1.0);
      const double along = AlongMotion(*grid_, motion).gradientSlope(other);
      const double across = AlongMotion(*grid_, other).gradientSlope(motion);
      EXPECT_NEAR(other.dot(force), 0.5 * (along + across), 1e-6 * (std::abs(along) + std::abs(across)));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sections, Derivatives, testing::ValuesIn(harnessPerSection()), harnessName);
INSTANTIATE_TEST_SUITE_P(Clips, Derivatives, testing::ValuesIn(harnessPerClip()), harnessName);
INSTANTIATE_TEST_SUITE_P(Joints, Derivatives, testing::ValuesIn(harnessPerJoint()), harnessName);

}  // namespace
}  // namespace cable_variation::test
