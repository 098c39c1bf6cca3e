// Derivatives of cables that touch against differences of re-solved ones: on planes, boxes and edges, by
// everything that varies, and the parts' own motion.

#include <algorithm>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <cable_variation/equilibrium/discretisation/equilibrium_result.h>
#include <cable_variation/equilibrium/search/lowest_shape.h>

#include <contact/contact_cases.h>

namespace cable_variation::test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kRadius = 0.004;

struct NamedRate {
  std::string name;
  HarnessRate rate;
  double step = 0.0;  // that moves the cable by some hundredths of a millimetre
};

// The cable is held at its end by clip 1 and touches one part.
std::vector<NamedRate> ratesFor() {
  std::vector<NamedRate> rates;
  const auto add = [&](const std::string& name, double step) -> HarnessRate& {
    rates.push_back({name, {}, step});
    return rates.back().rate;
  };
  const Vector3d askew = Vector3d(0.3, -0.5, 0.8).normalized();
  add("clip", 2e-5).clip_frames = {{1, {askew, Vector3d::Zero()}}};
  add("clip's turn", 1e-4).clip_frames = {{1, {Vector3d::Zero(), askew}}};
  add("part up", 2e-5).part_frames = {{0, {Vector3d::UnitZ(), Vector3d::Zero()}}};
  add("part", 2e-5).part_frames = {{0, {askew, Vector3d::Zero()}}};
  add("part's turn", 1e-4).part_frames = {{0, {Vector3d::Zero(), askew}}};
  CableRate cable;
  HarnessRate& length = add("length", 2e-5);
  length.clip_arc_lengths = {{1, 1.0}};
  cable.length = 1.0;
  length.cables = {cable};
  cable = {};
  cable.stiffness.tail<2>().setOnes();
  add("EI", 1e-3).cables = {cable};
  cable = {};
  cable.mass = 1.0;
  add("mass", 1e-3).cables = {cable};
  cable = {};
  cable.radius = 1.0;
  add("radius", 3e-3).cables = {cable};
  return rates;
}

// A shape at rest, all that presses closed to next to nothing.
struct Rested {
  std::vector<CableShape> shapes;
  std::vector<ContactSystem::Pressing> pressing;
  Grid grid;
  double force = 0.0;
  Equilibrium result;
};

std::optional<Rested> restOf(Branch& branch) {
  branch.letPointsMove();
  const Problem& problem = branch.problem();
  Rested rested;
  problem.system->evaluate(problem.configuration, RodSystem::Hessian::none);
  rested.pressing = problem.system->contact()->pressing();
  rested.grid = problem.system->grid();
  rested.shapes = describeShapes(problem.harness, problem.topology, *problem.system, problem.configuration);
  describe(problem.harness, problem.topology, *problem.system, problem.configuration, rested.result);
  for (const ContactSystem::Pressing& at : rested.pressing) rested.force += at.force;
  return rested;
}

std::optional<Rested> restAt(const Branch& nominal, const Harness& harness) {
  Branch branch(nominal);
  Equilibrium cost;
  if (!branch.follow(harness, makeTopology(harness), cost)) return std::nullopt;
  return restOf(branch);
}

// Whether the same places press, those that move where they have gone.
bool pressAlike(const Rested& a, const Rested& b) {
  if (a.grid != b.grid || a.pressing.size() != b.pressing.size()) return false;
  for (std::size_t i = 0; i < a.pressing.size(); ++i) {
    const bool moves = a.pressing[i].sharpness > 0.0;
    if (moves != (b.pressing[i].sharpness > 0.0)) return false;
    if (!moves && std::abs(a.pressing[i].share - b.pressing[i].share) > 1e-9) return false;
  }
  return true;
}

struct Tally {
  int compared = 0, other_places = 0, points = 0;
};

void compare(const Harness& harness, const std::string& name, Tally& tally) {
  EquilibriumOptions options;
  options.eigenvalue = false;
  EquilibriumSolver solver(options);
  const Equilibrium solved = solver.solve(harness);
  ASSERT_TRUE(solved.converged()) << name << ": " << solved.message;
  if (solved.contacts.empty()) return;
  Equilibrium cost;
  const std::unique_ptr<Branch> branch = lowestShape(harness, options, cost);
  ASSERT_TRUE(branch) << name;
  const std::optional<Rested> nominal = restAt(*branch, harness);
  ASSERT_TRUE(nominal) << name;
  const std::vector<NamedRate> named = ratesFor();
  std::vector<HarnessRate> variables;
  variables.reserve(named.size());
  for (const NamedRate& each : named) variables.push_back(each.rate);
  const std::vector<EquilibriumRate> rates = solver.differentiate(variables);
  for (std::size_t j = 0; j < named.size(); ++j) {
    SCOPED_TRACE(name + " by " + named[j].name);
    const double step = named[j].step;
    const auto at = [&](double by) { return restAt(*branch, changed(harness, named[j].rate, by * step)); };
    const auto up = at(1.0), down = at(-1.0);
    if (!up || !down || !pressAlike(*nominal, *up) || !pressAlike(*nominal, *down) ||
        rates[j].contacts.size() != nominal->pressing.size()) {
      ++tally.other_places;
      continue;
    }
    ++tally.compared;
    for (const auto& at_point : nominal->pressing) tally.points += at_point.sharpness > 0.0 ? 1 : 0;
    const EquilibriumRate& rate = rates[j];
    ASSERT_EQ(rate.shapes[0].size(), up->shapes[0].points.size());
    double largest = 0.0, off = 0.0, largest_moment = 0.0, off_moment = 0.0, largest_force = 0.0,
           off_force = 0.0;
    for (std::size_t k = 0; k < rate.shapes[0].size(); ++k) {
      const ShapePoint &a = up->shapes[0].points[k], &b = down->shapes[0].points[k];
      const ShapePointRate& of = rate.shapes[0][k];
      const auto note = [&](const Vector3d& x, const Vector3d& y, const Vector3d& derivative, double& most,
                            double& error) {
        most = std::max(most, derivative.norm());
        error = std::max(error, ((x - y) / (2.0 * step) - derivative).norm());
      };
      note(a.pose.position, b.pose.position, of.position, largest, off);
      note(a.force, b.force, of.force, largest_force, off_force);
      note(a.moment, b.moment, of.moment, largest_moment, off_moment);
    }
    EXPECT_LT(off, 2e-3 * largest + 1e-9 / step);
    EXPECT_LT(off_moment, 3e-3 * largest_moment);
    EXPECT_LT(off_force, 3e-3 * largest_force);
    double force_rate = 0.0, force_scale = 0.0;
    for (const ContactForceRate& of : rate.contacts) {
      force_rate += of.force;
      force_scale = std::max(force_scale, std::abs(of.force));
    }
    EXPECT_NEAR(force_rate, (up->force - down->force) / (2.0 * step),
                5e-3 * (std::abs(force_rate) + largest_force));
    EXPECT_NEAR(rate.elastic_energy, (up->result.energy.elastic - down->result.energy.elastic) / (2.0 * step),
                3e-3 * std::abs(rate.elastic_energy) + 1e-6 / step * nominal->result.energy.elastic);
    for (std::size_t clip = 0; clip < 2; ++clip) {
      const Vector3d difference =
          (up->result.clip_reactions[clip].force - down->result.clip_reactions[clip].force) / (2.0 * step);
      EXPECT_LT((rate.clip_reactions[clip].force - difference).norm(), 3e-3 * largest_force);
    }
  }
}

TEST(ContactDerivatives, AreDifferencesOfSolvedShapes) {
  std::mt19937 random(1966);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  Tally on_planes, on_boxes;
  constexpr int kCases = 24;
  for (int i = 0; i < kCases; ++i) {
    const double length = uniform(0.3, 0.6);
    Harness harness =
        clamped(uniformCable(length, roundSection(1e4, 4e3, 8e-3, 1e-2, uniform(0.02, 0.3), kRadius)),
                poseAt(uniform(0.6, 0.95) * length, uniform(-0.05, 0.05), uniform(-0.03, 0.05),
                       {0.0, uniform(-0.3, 0.3), uniform(-0.3, 0.3)}));
    const bool plane = i % 2 == 0;
    const Vector3d size(uniform(0.05, 0.2), uniform(0.05, 0.2), uniform(0.01, 0.05));
    const Pose pose = poseAt(uniform(0.2, 0.6) * length, uniform(-0.02, 0.02),
                             plane ? -uniform(0.05, 0.08) : -uniform(0.05, 0.09),
                             {uniform(-0.2, 0.2), plane ? uniform(-0.05, 0.05) : uniform(-0.2, 0.2), 0.0});
    harness.contacts = {plane ? contactWith("part", rectangle(Vector2d(-1.0, -1.0), Vector2d(1.0, 1.0)), pose)
                              : contactWith("part", box(size), pose)};
    compare(harness, (plane ? "plane " : "box ") + std::to_string(i), plane ? on_planes : on_boxes);
  }
  // what presses is not the same on both sides of a step in some
  EXPECT_GT(on_planes.compared, on_planes.other_places);
  EXPECT_GT(on_boxes.compared, on_boxes.other_places);
  EXPECT_GT(on_boxes.points, 10);
}

// Cables that hang down to a table, where the gap's minimum is blunt.
TEST(ContactDerivatives, OfCablesThatHangToATable) {
  std::mt19937 random(1969);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  Tally tally;
  for (int i = 0; i < 12; ++i) {
    Harness harness =
        clamped(uniformCable(0.5, roundSection(1e4, 4e3, 8e-3, 1e-2, uniform(0.1, 0.3), kRadius)),
                poseAt(uniform(0.38, 0.44), uniform(-0.05, 0.05), uniform(0.02, 0.04)));
    harness.clips[0].pose = poseAt(0.0, 0.0, uniform(0.03, 0.05));
    harness.contacts = {contactWith("table", rectangle(Vector2d(-0.5, -0.5), Vector2d(1.0, 0.5)))};
    compare(harness, "table " + std::to_string(i), tally);
  }
  EXPECT_GT(tally.compared, tally.other_places);
}

}  // namespace
}  // namespace cable_variation::test
