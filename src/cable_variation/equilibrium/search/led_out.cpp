#include <cable_variation/equilibrium/search/led_out.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <cable_variation/equilibrium/discretisation/contact_system.h>
#include <cable_variation/equilibrium/discretisation/equilibrium_result.h>
#include <cable_variation/equilibrium/search/initial_shape.h>
#include <cable_variation/equilibrium/search/lowest_shape.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;

// A harness with parts taken away.
struct Cleared {
  Harness harness;
  double way = 0.0;  // the longest that a part was taken [m]
};

// Parts are the same if their surface and place are.
bool samePart(const PartContact& a, const PartContact& b) {
  return a.surface == b.surface && a.pose.position == b.pose.position &&
         a.pose.orientation.coeffs() == b.pose.orientation.coeffs();
}

// Along `direction`, what is in the way of the natural start. Nothing when it is too far.
std::optional<Cleared> clear(const Harness& harness, const Vector3d& direction) {
  constexpr double kGrowth = 1.3;
  constexpr double kFirst = 2.0;  // radii
  Problem problem(harness);
  problem.setGrid(startGrid(problem.harness, problem.topology));
  const InitialShape initial(problem.harness, problem.topology);
  const Configuration natural =
      initial.make(problem.system->grid(), std::vector<Routing>(initial.intervals().size()));
  const double furthest = 2.0 * problem.length();
  std::vector<double> ways(harness.contacts.size(), 0.0);
  ContactSystem& contact = *problem.system->contact();
  Cleared cleared{harness, 0.0};
  while (const std::optional<std::size_t> crossed = contact.crossed(natural)) {
    const PartContact& part = harness.contacts[*crossed];
    const double radius =
        sectionAt(harness.cables[part.cable], 0.5 * harness.cables[part.cable].length).radius +
        part.stand_off;
    const double way = std::max(kFirst * radius, kGrowth * ways[*crossed]);
    if (!(way < furthest)) return std::nullopt;
    for (std::size_t i = 0; i < ways.size(); ++i) {
      if (!samePart(harness.contacts[i], part)) continue;
      ways[i] = way;
      problem.harness.contacts[i].pose.position = harness.contacts[i].pose.position + way * direction;
    }
    cleared.way = std::max(cleared.way, way);
    contact.harnessChanged();
  }
  cleared.harness = problem.harness;
  return cleared;
}

std::vector<Vector3d> directionsOf(const Harness& harness) {
  constexpr double kSame = 1e-6;
  std::vector<Vector3d> directions;
  const auto add = [&](const Vector3d& direction) {
    const bool known = std::any_of(directions.begin(), directions.end(),
                                   [&](const Vector3d& other) { return (other - direction).norm() < kSame; });
    if (!known) directions.push_back(direction);
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) add(sign * Vector3d::Unit(2 - axis));
  }
  for (const PartContact& contact : harness.contacts) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const double sign : {-1.0, 1.0})
        add(sign * (contact.pose.orientation * Vector3d(Vector3d::Unit(2 - axis))));
    }
  }
  return directions;
}

}  // namespace

std::unique_ptr<Branch> ledOut(const Harness& harness, const EquilibriumOptions& options,
                               Equilibrium& result) {
  constexpr std::size_t kMost = 4;  // directions, of those with the shortest ways
  std::vector<Cleared> ways;
  for (const Vector3d& direction : directionsOf(harness)) {
    if (std::optional<Cleared> way = clear(harness, direction)) ways.push_back(std::move(*way));
  }
  const bool outside =
      std::any_of(ways.begin(), ways.end(), [](const Cleared& way) { return way.way == 0.0; });
  if (outside) return nullptr;  // nothing is in the way
  std::stable_sort(ways.begin(), ways.end(),
                   [](const Cleared& a, const Cleared& b) { return a.way < b.way; });
  if (ways.size() > kMost) ways.resize(kMost);
  struct Found {
    std::unique_ptr<Branch> branch;
    Equilibrium result;
    double energy = 0.0;
  };
  std::vector<Found> found;
  const Topology topology = makeTopology(harness);
  for (const Cleared& way : ways) {
    Found here;
    here.branch = lowestOfStarts(way.harness, options, here.result);
    const bool back =
        here.branch && !here.branch->unstable() && here.branch->follow(harness, topology, here.result);
    result.iterations += here.result.iterations;
    if (!back) continue;
    here.energy = here.branch->problem().system->energy().total();
    found.push_back(std::move(here));
  }
  if (found.empty()) {
    result.message += "; parts that were taken away along one of " + std::to_string(ways.size()) +
                      " directions could not be brought back without passing through a cable";
    return nullptr;
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Found& a, const Found& b) { return a.energy < b.energy; });
  Found& best = found.front();
  best.result.iterations = result.iterations;
  result = std::move(best.result);
  result.alternatives.clear();
  const Problem& at = best.branch->problem();
  for (std::size_t i = 1; i < found.size(); ++i) {
    const Problem& other = found[i].branch->problem();
    const double apart =
        largestDistance(at.system->grid(), at.configuration, other.system->grid(), other.configuration);
    constexpr double kSameShape = 1e-3;  // of the harness's length
    if (apart > kSameShape * at.length()) result.alternatives.push_back({found[i].energy, apart});
  }
  return std::move(best.branch);
}

}  // namespace cable_variation
