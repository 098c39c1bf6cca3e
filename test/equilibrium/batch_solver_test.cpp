// Many equilibria at once are those that EquilibriumSolver finds one by one.

#include <cable_variation/equilibrium/batch_solver.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include <cable_variation/scene_file/scene_reader.h>
#include <equilibrium/case_table.h>

namespace cable_variation::test {
namespace {

constexpr double kDegree = M_PI / 180.0;

constexpr double kAccuracy = 1e-4;
// A batch works on the grid that half of the errors asks for.
constexpr double kOnBatchGrid = 0.5;

EquilibriumSolver solved(const Harness& harness, double share = 1.0) {
  EquilibriumOptions options;
  options.accuracy = share * kAccuracy;
  options.force_accuracy *= share;
  options.eigenvalue = false;
  EquilibriumSolver solver(options);
  const Equilibrium result = solver.solve(harness);
  EXPECT_TRUE(result.converged()) << result.message;
  return solver;
}

// Every number of a harness off its nominal, at random: clips by up to 3 mm and 3°, arc lengths by 2 mm,
// properties by 5 %.
class Deviation {
 public:
  explicit Deviation(unsigned seed) : generator_(seed) {}

  Harness of(Harness harness) {
    for (Clip& clip : harness.clips) {
      clip.pose.position += 3e-3 * vector();
      clip.pose.orientation =
          clip.pose.orientation * so3::exp(3.0 * kDegree * uniform() * vector().normalized());
      if (clip.arc_length > 0.0 && clip.arc_length < harness.cables[clip.cable].length) {
        clip.arc_length += 2e-3 * uniform();
      }
    }
    for (std::size_t c = 0; c < harness.cables.size(); ++c) {
      Cable& cable = harness.cables[c];
      const double before = cable.length;
      cable.length += 2e-3 * uniform();
      for (SectionAt& at : cable.sections) at.arc_length *= cable.length / before;
      for (RestCurvatureAt& at : cable.rest_curvature) at.arc_length *= cable.length / before;
      for (Clip& clip : harness.clips) {
        if (clip.cable == c && clip.arc_length == before) clip.arc_length = cable.length;
      }
      for (PointLoad& load : harness.loads) {
        if (load.cable == c && load.arc_length == before) load.arc_length = cable.length;
      }
      for (Joint& joint : harness.joints) {
        if (joint.child == c && joint.child_arc_length == before) joint.child_arc_length = cable.length;
      }
      const double bending = share(), mass = share(), stretch = share();
      for (SectionAt& at : cable.sections) {
        at.section.EI_y *= bending;
        at.section.EI_z *= bending;
        at.section.EA *= stretch;
        at.section.mass_per_length *= mass;
      }
      const double formed = share();
      for (RestCurvatureAt& at : cable.rest_curvature) at.curvature *= formed;
    }
    for (Joint& joint : harness.joints) joint.parent_arc_length += 2e-3 * uniform();
    for (PointLoad& load : harness.loads) load.force *= share();
    harness.gravity += 0.2 * vector();
    return harness;
  }

 private:
  double uniform() { return std::uniform_real_distribution<double>(-1.0, 1.0)(generator_); }
  double share() { return 1.0 + 0.05 * uniform(); }
  Eigen::Vector3d vector() { return {uniform(), uniform(), uniform()}; }

  std::mt19937 generator_;
};

std::size_t pointCount(const Equilibrium& of) {
  std::size_t count = 0;
  for (const CableShape& shape : of.shapes) count += shape.points.size();
  return count;
}

void expectSame(const Equilibrium& batch, const Equilibrium& alone) {
  ASSERT_EQ(batch.shapes.size(), alone.shapes.size());
  // Both end their iterations when forces balance to some 1e-8 of what bending takes, and a stretched cable
  // of 5 kN tells 1e-9 m by 1e-4 N.
  const double force = 1e-4, moment = 1e-6;
  for (std::size_t c = 0; c < alone.shapes.size(); ++c) {
    const auto& a = batch.shapes[c].points;
    const auto& b = alone.shapes[c].points;
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_NEAR(a[i].arc_length, b[i].arc_length, 1e-15);
      // a ten thousandth of the accuracy: what is left of balance moves the softest, cables in hinges and on
      // planes
      EXPECT_LT((a[i].pose.position - b[i].pose.position).norm(), 1e-8);
      EXPECT_LT(angleBetween(a[i].pose.orientation, b[i].pose.orientation), 1e-7);
      EXPECT_LT((a[i].force - b[i].force).norm(), force);
      EXPECT_LT((a[i].moment - b[i].moment).norm(), moment);
      EXPECT_LT((a[i].tangent - b[i].tangent).norm(), 1e-7);
    }
  }
  ASSERT_EQ(batch.clip_reactions.size(), alone.clip_reactions.size());
  for (std::size_t i = 0; i < alone.clip_reactions.size(); ++i) {
    EXPECT_EQ(batch.clip_reactions[i].name, alone.clip_reactions[i].name);
    EXPECT_LT((batch.clip_reactions[i].force - alone.clip_reactions[i].force).norm(), force);
    EXPECT_LT((batch.clip_reactions[i].moment - alone.clip_reactions[i].moment).norm(), moment);
  }
  ASSERT_EQ(batch.joint_reactions.size(), alone.joint_reactions.size());
  for (std::size_t i = 0; i < alone.joint_reactions.size(); ++i) {
    EXPECT_LT((batch.joint_reactions[i].force - alone.joint_reactions[i].force).norm(), force);
  }
  const double size = std::abs(alone.energy.elastic) + std::abs(alone.energy.gravity);
  // where the difference of two grids stops being asymptotic, the estimate jumps from a seventh of it to a
  // third
  EXPECT_LT(std::abs(std::log(batch.discretisation_error / alone.discretisation_error)), std::log(3.0));
  EXPECT_NEAR(batch.energy.elastic, alone.energy.elastic, 1e-8 * size);
  EXPECT_NEAR(batch.energy.gravity, alone.energy.gravity, 1e-8 * size);
  EXPECT_NEAR(batch.energy.springs, alone.energy.springs, 1e-8 * size);
  EXPECT_NEAR(batch.energy.loads, alone.energy.loads, 1e-8 * size);
}

// On another grid: as far from each other as both are from the continuum.
void expectClose(const Equilibrium& batch, const Equilibrium& alone) {
  const double error = batch.discretisation_error + alone.discretisation_error;
  for (std::size_t c = 0; c < alone.shapes.size(); ++c) {
    const std::vector<Pose> a = batch.shapes[c].sample(61), b = alone.shapes[c].sample(61);
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_LT((a[i].position - b[i].position).norm(), error);
  }
}

class BatchSolverOf : public testing::TestWithParam<NamedHarness> {};

// Solves them in batches and one by one. `most_left`: how many may be left to update(), their motion too
// large for a batch.
void expectFoundByUpdate(const Harness& nominal, const std::vector<Harness>& harnesses,
                         std::size_t most_left) {
  BatchSolver batch(solved(nominal));
  const EquilibriumSolver solver = solved(nominal, kOnBatchGrid);
  std::vector<std::string> left;
  std::size_t same = 0;
  for (std::size_t first = 0; first < harnesses.size(); first += BatchSolver::kBatch) {
    batch.solve(&harnesses[first], BatchSolver::kBatch);
    for (std::size_t i = 0; i < BatchSolver::kBatch; ++i) {
      SCOPED_TRACE("harness " + std::to_string(first + i));
      if (!batch.outcome(i).converged()) {
        left.emplace_back(toString(batch.outcome(i).status));
        continue;
      }
      EquilibriumSolver follower = solver;
      follower.update(harnesses[first + i]);
      const Equilibrium alone =
          follower.update(harnesses[first + i]);  // once more takes away what the first left
      ASSERT_TRUE(alone.converged()) << alone.message;
      // update() may need a finer grid to halve the error of this one, too
      const bool same_grid = pointCount(batch.describe(i)) == pointCount(alone);
      same += same_grid ? 1 : 0;
      same_grid ? expectSame(batch.describe(i), alone) : expectClose(batch.describe(i), alone);
    }
  }
  EXPECT_LE(left.size(), most_left) << left.back();
  EXPECT_GE(same, harnesses.size() / 2);
}

TEST_P(BatchSolverOf, FindsWhatUpdateFinds) {
  Deviation deviation(1);
  std::vector<Harness> harnesses;
  for (int i = 0; i < 16; ++i) harnesses.push_back(deviation.of(GetParam().harness));
  // a quarter at most: the nominal grid leaves half of the error, which some of the others double
  expectFoundByUpdate(GetParam().harness, harnesses, 4);
}

std::vector<NamedHarness> batchTable() {
  std::vector<NamedHarness> table = {{"case_H", caseH()}, {"case_W", caseW()}};
  for (const NamedHarness& of : harnessPerSection()) {
    if (of.name.find("_fixed") != std::string::npos) table.push_back(of);
  }
  for (const NamedHarness& of : harnessPerClip()) {
    if (!of.harness.clips.back().constraint.slides) table.push_back(of);
  }
  for (const NamedHarness& of : harnessPerJoint()) table.push_back(of);
  return table;
}

INSTANTIATE_TEST_SUITE_P(All, BatchSolverOf, testing::ValuesIn(batchTable()), harnessName);

// The shipped case over the tolerances of its own variables: two cables and a breakout.
TEST(BatchSolver, SolvesTheShippedHarness) {
  const std::string root = CABLE_VARIATION_SOURCE_DIR;
  const Scene scene = readScene(root + "/config/harness.yaml", [&](const std::string&) { return root; });
  std::mt19937 generator(3);
  std::vector<Harness> harnesses;
  for (int i = 0; i < 24; ++i) {
    DesignValues values;
    for (const DesignVariable& variable : scene.design_variables) {
      std::uniform_real_distribution<double> within(variable.lower, variable.upper);
      values[variable.name] = variable.nominal + within(generator);
    }
    harnesses.push_back(harnessAt(scene, values));
  }
  expectFoundByUpdate(harnessAt(scene, {}), harnesses, 4);
}

void expectIdentical(const Equilibrium& a, const Equilibrium& b) {
  ASSERT_EQ(a.shapes.size(), b.shapes.size());
  for (std::size_t c = 0; c < a.shapes.size(); ++c) {
    ASSERT_EQ(a.shapes[c].points.size(), b.shapes[c].points.size());
    for (std::size_t i = 0; i < a.shapes[c].points.size(); ++i) {
      const ShapePoint& p = a.shapes[c].points[i];
      const ShapePoint& q = b.shapes[c].points[i];
      EXPECT_TRUE(p.pose.position == q.pose.position &&
                  p.pose.orientation.coeffs() == q.pose.orientation.coeffs() && p.force == q.force &&
                  p.moment == q.moment && p.second_derivative == q.second_derivative);
    }
  }
  EXPECT_EQ(a.energy.total(), b.energy.total());
  EXPECT_EQ(a.iterations, b.iterations);
}

// Alone, in a full batch, at another place in it, beside a neighbour that needs more steps or none, on
// another thread.
TEST(BatchSolver, GivesTheSameBitsInWhateverCompany) {
  const Harness nominal = branched(Joint::Type::hinge);
  const EquilibriumSolver solver = solved(nominal);
  BatchSolver batch(solver);
  Deviation deviation(5);
  std::vector<Harness> harnesses = {nominal};
  for (int i = 1; i < 8; ++i) harnesses.push_back(deviation.of(nominal));
  std::vector<Equilibrium> alone;
  for (const Harness& harness : harnesses) {
    batch.solve(&harness, 1);
    ASSERT_TRUE(batch.outcome(0).converged());
    alone.push_back(batch.describe(0));
  }
  EXPECT_NE(alone[0].iterations, alone[1].iterations);
  batch.solve(harnesses.data(), harnesses.size());
  for (std::size_t i = 0; i < harnesses.size(); ++i) expectIdentical(batch.describe(i), alone[i]);
  // a neighbour that finds no rest at all
  std::vector<Harness> reversed(harnesses.rbegin(), harnesses.rend());
  reversed[3].clips[1].pose.position.x() += 1.0;
  std::thread([&] {
    BatchSolver copy(batch);
    copy.solve(reversed.data(), reversed.size());
    EXPECT_FALSE(copy.outcome(3).converged());
    for (std::size_t i = 0; i < harnesses.size(); ++i) {
      if (i != 3) expectIdentical(copy.describe(i), alone[7 - i]);
    }
  }).join();
}

TEST(BatchSolver, TellsWhatItCannotSolve) {
  const Harness nominal = caseW();
  const EquilibriumSolver solver = solved(nominal);
  BatchSolver batch(solver);
  std::vector<Harness> harnesses(5, nominal);
  harnesses[0].clips[1].pose.position *= 2.0;                           // out of reach
  harnesses[1].clips.push_back(clipOn(0, "C", 0.15, pivotClip()));      // another clip
  harnesses[2].clips[1].arc_length -= 0.01;                             // holds no end any more
  harnesses[3].clips[1].pose.orientation = so3::exp({0.0, 0.0, M_PI});  // turned round
  batch.solve(harnesses.data(), harnesses.size());
  EXPECT_FALSE(batch.outcome(0).converged());
  EXPECT_EQ(batch.outcome(1).status, BatchStatus::other_structure);
  EXPECT_EQ(batch.outcome(2).status, BatchStatus::other_structure);
  EXPECT_FALSE(batch.outcome(3).converged());
  EXPECT_TRUE(batch.outcome(4).converged());
  EXPECT_FALSE(batch.describe(1).converged());
  EXPECT_THROW(batch.outcome(5), std::out_of_range);
  EXPECT_THROW(batch.solve(harnesses.data(), 0), std::invalid_argument);
  EXPECT_THROW(batch.solve(harnesses.data(), BatchSolver::kBatch + 1), std::invalid_argument);
}

// A straight twisted rod buckles at T = 2 λ EI/L, tan λ = λ (Greenhill; twist_stability_test.cpp). Newton's
// method stays on the straight shape beyond; that is no minimum.
TEST(BatchSolver, TellsThatAShapeIsUnstable) {
  constexpr double kCriticalTwist = 2.0 * 4.493409457909064 / 4.0;
  const auto twisted = [](double angle) {
    Harness harness =
        clamped(uniformCable(1.0, roundSection(1e6, 1e6, 4.0, 1.0)),
                {Eigen::Vector3d(1.0, 0.0, 0.0), so3::exp({angle, 0.0, 0.0})}, Eigen::Vector3d::Zero());
    harness.clips[1].constraint = guideClip();
    return harness;
  };
  BatchSolver batch(solved(twisted(0.95 * kCriticalTwist)));
  const std::vector<Harness> harnesses = {twisted(0.98 * kCriticalTwist), twisted(1.02 * kCriticalTwist)};
  batch.solve(harnesses.data(), harnesses.size());
  EXPECT_TRUE(batch.outcome(0).converged()) << toString(batch.outcome(0).status);
  EXPECT_EQ(batch.outcome(1).status, BatchStatus::unstable) << toString(batch.outcome(1).status);
}

TEST(BatchSolver, RefusesWhatItDoesNotKnow) {
  EXPECT_THROW(BatchSolver{EquilibriumSolver()}, std::logic_error);
  const auto refusal = [](const Harness& harness) -> std::string {
    try {
      BatchSolver batch(solved(harness));
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  const Cable cable = cableKinds()[1].cable;
  EXPECT_NE(refusal(heldBetween(cable, slidingClip())).find("clip 'C'"), std::string::npos);
  Harness moment = cantilever(cable);
  moment.loads = {loadAt(0, kTableLength, {0.2, 0.1, -0.3}, {0.004, 0.003, -0.002})};
  EXPECT_NE(refusal(moment).find("load 'load'"), std::string::npos);
}

}  // namespace
}  // namespace cable_variation::test
