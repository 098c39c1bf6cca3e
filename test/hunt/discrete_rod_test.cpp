// The independent rod itself: derivatives by differences, order of convergence, closed forms.

#include <cmath>

#include <gtest/gtest.h>

#include <equilibrium/cases.h>
#include <hunt/discrete_minimise.h>
#include <hunt/discrete_start.h>
#include <hunt/family.h>

namespace cable_variation::hunt {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

VectorXd randomStep(Draw& draw, const DiscreteRod& rod, double size) {
  VectorXd step(rod.unknowns());
  for (Eigen::Index i = 0; i < step.size(); ++i) step[i] = size * draw.between(-1.0, 1.0);
  return step;
}

double energyAt(const DiscreteRod& rod, const DiscreteShape& shape, const VectorXd& step, double share) {
  DiscreteShape moved = shape;
  rod.move(share * step, {}, moved);
  return rod.energy(moved).total();
}

// Whatever the family: the gradient is the energy's derivative, the Hessian its second, along random motions.
TEST(DiscreteRod, GradientAndHessianAreThoseOfTheEnergy) {
  for (const Family& family : families()) {
    SCOPED_TRACE(family.name);
    Harness harness = makeHarness(family, 3, 1);
    // soft enough in stretch for differences to see bending
    for (Cable& cable : harness.cables) {
      for (SectionAt& at : cable.sections) {
        at.section.EA = at.section.GA_y = at.section.GA_z =
            50.0 * at.section.EI_y / (cable.length * cable.length);
      }
    }
    const DiscreteRod rod(harness, layOut(harness, 8));
    Draw draw(11, 0, 0);
    const DiscreteShape shape = simpleStart(rod, draw, true);
    double shortest = 1.0;
    for (const Cable& cable : harness.cables) shortest = std::min(shortest, cable.length);
    const VectorXd step = randomStep(draw, rod, 1e-3 * shortest);
    VectorXd gradient;
    Eigen::SparseMatrix<double> hessian;
    const double energy = rod.assemble(shape, {}, gradient, hessian).total();
    EXPECT_DOUBLE_EQ(energy, rod.energy(shape).total());
    const double along = gradient.dot(step);
    const double second = step.dot(hessian.selfadjointView<Eigen::Lower>() * step);
    // differences of second and, by Richardson, fourth order
    const auto first = [&](double t) {
      return (energyAt(rod, shape, step, t) - energyAt(rod, shape, step, -t)) / (2.0 * t);
    };
    const auto curved = [&](double t) {
      return (energyAt(rod, shape, step, t) - 2.0 * energy + energyAt(rod, shape, step, -t)) / (t * t);
    };
    const double scale = gradient.cwiseAbs().dot(step.cwiseAbs());
    EXPECT_NEAR((4.0 * first(0.05) - first(0.1)) / 3.0, along, 1e-7 * scale);
    EXPECT_NEAR((4.0 * curved(0.1) - curved(0.2)) / 3.0, second,
                1e-4 * std::abs(second) + 1e-9 * std::abs(energy));
  }
}

// Case H of data/reference: both grids approach the continuum with the square of the segments' length.
TEST(DiscreteRod, IsOfSecondOrder) {
  const Harness harness = test::caseH();
  std::vector<double> energies;
  DiscreteLayout layout = layOut(harness, 20);
  Draw draw(1, 0, 0);
  DiscreteShape shape = simpleStart(DiscreteRod(harness, layout), draw, false);
  for (int grid = 0; grid < 3; ++grid) {
    const DiscreteRod rod(harness, layout);
    ASSERT_TRUE(descend(rod, shape).stable);
    energies.push_back(rod.energy(shape).total());
    shape = onHalved(layout, shape);
    layout = halved(layout);
  }
  EXPECT_NEAR((energies[0] - energies[1]) / (energies[1] - energies[2]), 4.0, 0.2);
}

// Euler's column between clamps, pressed a little less and a little more than 4π²EI/L² bears; the load is
// given.
TEST(DiscreteRod, EigenvalueChangesSignAtEulersLoad) {
  const double EI = 1e-2, length = 0.5, critical = M_PI * M_PI * EI / (4.0 * length * length);
  for (double share : {0.98, 1.02}) {
    Harness harness =
        test::cantilever(test::uniformCable(length, test::roundSection(1e5, 1e5, EI, EI)), Vector3d::Zero());
    harness.loads = {test::loadAt(0, length, {-share * critical, 0.0, 0.0})};
    const DiscreteRod rod(harness, layOut(harness, 80));
    Draw draw(1, 0, 0);
    DiscreteShape shape = simpleStart(rod, draw, false);
    // straight
    for (std::size_t k = 0; k < shape.pieces[0].vertices.size(); ++k) {
      shape.pieces[0].vertices[k] = {length * rod.layout().pieces[0].at[k + 1], 0.0, 0.0};
    }
    for (auto& segment : shape.pieces[0].segments) segment.setIdentity();
    shape.stations[1].position = {length, 0.0, 0.0};
    shape.stations[1].orientation.setIdentity();
    ASSERT_TRUE(settle(rod, shape).stationary);
    EXPECT_EQ(smallestEigenvalue(rod, shape) > 0.0, share < 1.0);
  }
}

}  // namespace
}  // namespace cable_variation::hunt
