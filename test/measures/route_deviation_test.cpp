// How far a cable is from a route: closed forms, places sampled densely, and the limit where it lies on it.

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <measures/solved_scene.h>

namespace cable_variation::test {
namespace {

using Eigen::Vector3d;

constexpr double kLength = 0.4;
const Section kSection = solidSection(0.004, {1e8, 0.25, 2000.0});

Measure routeOf(const std::vector<Vector3d>& points, double from = 0.0, double to = kLength) {
  Measure made = measure(Measure::Type::route_deviation, "route");
  made.from = from;
  made.to = to;
  made.route = points;
  return made;
}

struct Found {
  Scene scene;
  Solved solved;
  EquilibriumSolver solver;
  std::vector<MeasureValue> values;
};

Found solvedWith(const Harness& harness, const std::vector<Measure>& measures) {
  EquilibriumOptions options;
  options.accuracy = 1e-7;
  Found found{sceneOf(harness), {}, EquilibriumSolver(options), {}};
  found.scene.measures = measures;
  found.solved = solveAt(found.scene, {}, found.solver);
  EXPECT_TRUE(found.solved.equilibrium.converged()) << found.solved.equilibrium.message;
  found.values = MeasureEvaluator(found.scene, found.solved.view())
                     .evaluate(found.solved.view(), allOf(measures.size()));
  return found;
}

// A straight cable along x, and routes beside it.
TEST(RouteDeviation, IsTheLargestOfBothWays) {
  const Harness straight = cantilever(uniformCable(kLength, kSection), Vector3d::Zero());
  const Found found =
      solvedWith(straight, {
                               routeOf({{0, 0.03, 0}, {kLength, 0.03, 0}}),            // beside it
                               routeOf({{0, 0, 0}, {0.1, 0, 0}}),                      // too short
                               routeOf({{0, 0, 0}, {0.5, 0, 0}}),                      // too long
                               routeOf({{0, 0, 0}, {0.2, 0, 0.05}, {kLength, 0, 0}}),  // a detour
                               routeOf({{0.1, 0.02, 0}, {0.2, 0.02, 0}}, 0.1, 0.2),
                               routeOf({{kLength, 0.01, 0}, {0, 0.01, 0}}),  // the other way round
                           });
  const double expected[] = {0.03, kLength - 0.1, 0.1, 0.05, 0.02, 0.01};
  for (std::size_t i = 0; i < found.values.size(); ++i) {
    EXPECT_NEAR(found.values[i].value, expected[i], 1e-9) << i;
    EXPECT_NEAR((found.values[i].point - found.values[i].other).norm(), expected[i], 1e-9) << i;
  }
  EXPECT_NEAR(found.values[1].arc_length, kLength, 1e-6);
  EXPECT_LT((found.values[2].other - Vector3d(0.5, 0, 0)).norm(), 1e-9);
  EXPECT_LT((found.values[3].other - Vector3d(0.2, 0, 0.05)).norm(), 1e-6);
}

// A cable that is made as an arc, on stretches of it: the chord is the sagitta away.
TEST(RouteDeviation, OfAnArcFromItsChordIsTheSagitta) {
  Cable cable = uniformCable(kLength, kSection);
  const double radius = 0.17;
  cable.rest_curvature = {{0.0, {0.0, 0.0, 1.0 / radius}}};
  const auto at = [&](double s) {
    return Vector3d(radius * std::sin(s / radius), radius * (1.0 - std::cos(s / radius)), 0.0);
  };
  std::vector<Measure> measures;
  std::vector<double> sagittas;
  for (const auto& [from, to] : {std::pair<double, double>{0.0, 0.1}, {0.03, 0.27}, {0.2, kLength}}) {
    measures.push_back(routeOf({at(from), at(to)}, from, to));
    sagittas.push_back(radius * (1.0 - std::cos(0.5 * (to - from) / radius)));
  }
  const Found found = solvedWith(cantilever(cable, Vector3d::Zero()), measures);
  for (std::size_t i = 0; i < measures.size(); ++i) {
    EXPECT_NEAR(found.values[i].value, sagittas[i], 2e-7);
    EXPECT_NEAR(found.values[i].arc_length, 0.5 * (measures[i].from + measures[i].to), 1e-4);
  }
}

double distanceTo(const Vector3d& point, const std::vector<Vector3d>& polyline) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < polyline.size(); ++i) {
    const Vector3d way = polyline[i + 1] - polyline[i];
    const double share = std::clamp((point - polyline[i]).dot(way) / way.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (polyline[i] + share * way - point).norm());
  }
  return nearest;
}

std::vector<Vector3d> alongOf(const std::vector<Vector3d>& polyline, int per_piece) {
  std::vector<Vector3d> points{polyline.front()};
  for (std::size_t i = 0; i + 1 < polyline.size(); ++i) {
    for (int k = 1; k <= per_piece; ++k)
      points.push_back(polyline[i] + static_cast<double>(k) / per_piece * (polyline[i + 1] - polyline[i]));
  }
  return points;
}

// Random routes around a cable that sags, compared with places sampled on both.
TEST(RouteDeviation, IsThatOfPlacesSampled) {
  std::mt19937 random(16);
  std::uniform_real_distribution<double> share(0.0, 1.0), aside(-0.06, 0.06);
  const Harness harness = clamped(uniformCable(kLength, kSection), poseAt(0.3, 0.05, -0.04, {0.3, 0.4, 0.2}));
  std::vector<Measure> measures;
  for (int i = 0; i < 40; ++i) {
    const double from = 0.9 * kLength * share(random);
    const double to = i % 4 == 0 ? kLength : from + 0.01 + (0.99 * kLength - from - 0.01) * share(random);
    std::vector<Vector3d> points;
    for (int k = 0; k < 2 + i % 5; ++k)
      points.emplace_back(0.3 * share(random), aside(random), -0.05 + aside(random));
    measures.push_back(routeOf(points, from, std::max(to, from + 0.01)));
  }
  const Found found = solvedWith(harness, measures);
  for (std::size_t i = 0; i < measures.size(); ++i) {
    constexpr int kSteps = 400, kPerPiece = 300;
    std::vector<Vector3d> line;
    for (int k = 0; k <= kSteps; ++k) {
      const double s = measures[i].from + (measures[i].to - measures[i].from) * k / kSteps;
      line.push_back(found.solved.equilibrium.shapes[0].position(s));
    }
    double sampled = 0.0;
    for (const Vector3d& point : line) sampled = std::max(sampled, distanceTo(point, measures[i].route));
    for (const Vector3d& point : alongOf(measures[i].route, kPerPiece))
      sampled = std::max(sampled, distanceTo(point, line));
    // no place is further from a sampled one than half a step, and distances change by no more than the way
    double step = (measures[i].to - measures[i].from) / kSteps;
    for (std::size_t k = 0; k + 1 < measures[i].route.size(); ++k)
      step = std::max(step, (measures[i].route[k + 1] - measures[i].route[k]).norm() / kPerPiece);
    EXPECT_GE(found.values[i].value, sampled - 2e-6) << i;
    EXPECT_LE(found.values[i].value, sampled + 0.51 * step + 2e-6) << i;
  }
}

// On its route the value has a kink: its derivative is the limit of differences to both sides.
TEST(RouteDeviation, OnItsRouteHasTheLimitOfItsDifferences) {
  const Harness harness =
      clamped(uniformCable(kLength, kSection), poseAt(kLength, 0.0, 0.0), Vector3d::Zero());
  Found found = solvedWith(
      harness, {routeOf({{0, 0, 0}, {kLength, 0, 0}}), routeOf({{0.1, 0, 0}, {0.3, 0, 0}}, 0.1, 0.3)});
  found.scene.design_variables = {variable("y", ClipTranslation{1, Axis::y}),
                                  variable("rz", ClipRotation{1, Axis::z})};
  const std::vector<DesignRate> design = designRates(found.scene, {}, {}, allOf(2));
  std::vector<HarnessRate> rates;
  for (const DesignRate& rate : design) rates.push_back(rate.harness);
  const MeasureEvaluator evaluator(found.scene, found.solved.view());
  const Eigen::MatrixXd jacobian = evaluator.jacobian(found.solved.view(), allOf(2), found.values, design,
                                                      found.solver.differentiate(rates));
  EXPECT_NEAR(jacobian(0, 0), 1.0, 1e-6);  // the end itself
  for (std::size_t m = 0; m < 2; ++m) {
    EXPECT_LT(found.values[m].value, 1e-9);
    EXPECT_FALSE(found.values[m].unique);
    for (std::size_t v = 0; v < 2; ++v) {
      for (const double step : {1e-4, -1e-4}) {
        EquilibriumSolver solver = found.solver;
        const Solved moved = solveAt(found.scene, {{found.scene.design_variables[v].name, step}}, solver);
        const double value = evaluator.evaluate(moved.view(), allOf(2))[m].value;
        EXPECT_NEAR(value / std::abs(step),
                    jacobian(static_cast<Eigen::Index>(m), static_cast<Eigen::Index>(v)), 2e-3);
      }
    }
  }
}

}  // namespace
}  // namespace cable_variation::test
