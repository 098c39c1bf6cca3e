// Samples of a made-up scene, some of them not solved: all are counted, and blocks merge into the same
// figures.
#include <cable_variation/simulation/simulation_statistics.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <cable_variation/tolerances/sampler.h>
#include <cable_variation/tolerances/tolerances.h>

namespace cable_variation {
namespace {

constexpr std::uint64_t kSamples = 20000;

Scene sceneOfTwo() {
  Scene scene;
  for (const char* name : {"a", "b"}) {
    DesignVariable variable;
    variable.name = name;
    variable.lower = -3.0;
    variable.upper = 3.0;
    scene.design_variables.push_back(variable);
  }
  scene.correlations = {{0, 1, 0.5}};
  Measure sum;
  sum.name = "sum";
  sum.upper = 4.0;
  Measure first;
  first.name = "first";
  scene.measures = {sum, first};
  return scene;
}

SampleOutcome outcomeOf(std::uint64_t index, bool failing) {
  if (!failing) return SampleOutcome::solved;
  if (index % 10 == 3) return SampleOutcome::not_converged;
  if (index % 1000 == 7) return SampleOutcome::snapped;
  if (index == 5000) return SampleOutcome::impossible;
  return SampleOutcome::solved;
}

void add(SimulationAccumulator& accumulator, const Sampler& sampler, std::uint64_t index, bool failing) {
  double deviations[2];
  sampler.sample(index, deviations);
  const double a = deviations[0], b = deviations[1];
  const double linear[2] = {10.0 + a + b, a}, values[2] = {linear[0], a + 0.05 * a * b};
  accumulator.add(index, outcomeOf(index, failing), deviations, values, linear);
}

SimulationStatistics simulate(bool failing, std::uint64_t block) {
  const Scene scene = sceneOfTwo();
  const Sampler sampler(scene, {0, 1}, SamplerType::monte_carlo, kSamples, 1);
  const SimulationAccumulator empty(scene, {0, 1}, {0, 1});
  SimulationAccumulator all = empty;
  for (std::uint64_t begin = 0; begin < kSamples; begin += block) {
    SimulationAccumulator part = empty;
    for (std::uint64_t i = begin; i < begin + block; ++i) add(part, sampler, i, failing);
    all.merge(part);
  }
  return all.statistics(0.95, {LinearMoments{10.0, std::sqrt(3.0)}, LinearMoments{0.0, 1.0}});
}

// Var(a + b) = 1 + 1 + 2 0.5 = 3.
TEST(SimulationStatistics, FiguresAreThoseOfTheVariables) {
  const SimulationStatistics s = simulate(false, kSamples);
  EXPECT_EQ(s.samples, kSamples);
  EXPECT_EQ(s.count(SampleOutcome::solved), kSamples);
  EXPECT_NEAR(s.statistics[0].mean, 10.0, 4.0 * std::sqrt(3.0 / kSamples));
  EXPECT_NEAR(s.statistics[0].sigma, std::sqrt(3.0), 4.0 * std::sqrt(1.5 / kSamples));
  EXPECT_NEAR(s.statistics[0].controlled->sigma, std::sqrt(3.0), 1e-9);
  EXPECT_NEAR(s.contributions.slope(0, 0), 1.0, 1e-9);
  EXPECT_NEAR(s.contributions.regression_share(0, 0), 0.5, 0.02);
  // correlated: Var(E[a + b | a]) = (1 + 0.5)² of 3
  EXPECT_NEAR(s.contributions.first_order(0, 0), 0.75, 0.02);
  EXPECT_GT(s.statistics[1].controlled->mean_gain, 10.0);
}

TEST(SimulationStatistics, SamplesThatWereNotSolvedAreCountedAndListed) {
  const SimulationStatistics s = simulate(true, kSamples);
  EXPECT_EQ(s.count(SampleOutcome::not_converged), 2000u);
  EXPECT_EQ(s.count(SampleOutcome::snapped), 20u);
  EXPECT_EQ(s.count(SampleOutcome::impossible), 1u);
  EXPECT_EQ(s.count(SampleOutcome::solved), kSamples - 2021);
  EXPECT_EQ(s.listed.size(), SimulationStatistics::kMostListed);
  EXPECT_EQ(s.listed[0].index, 3u);
  EXPECT_EQ(s.listed[1].index, 7u);
  EXPECT_EQ(s.listed[1].outcome, SampleOutcome::snapped);
  EXPECT_EQ(s.listed[1].deviations.size(), 2u);
  EXPECT_EQ(s.statistics[0].count, kSamples - 2001);
  EXPECT_EQ(s.statistics[0].missing, 2001u);
  EXPECT_FALSE(s.statistics[0].controlled);
  EXPECT_EQ(s.contributions.left_out, 2001u);
}

TEST(SimulationStatistics, BlocksMergeIntoTheSameFigures) {
  const SimulationStatistics once = simulate(true, kSamples), blocks = simulate(true, 250);
  EXPECT_EQ(once.outcomes, blocks.outcomes);
  ASSERT_EQ(once.listed.size(), blocks.listed.size());
  for (std::size_t i = 0; i < once.listed.size(); ++i)
    EXPECT_EQ(once.listed[i].index, blocks.listed[i].index);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(once.statistics[i].sigma, blocks.statistics[i].sigma, 1e-12);
    EXPECT_NEAR(once.statistics[i].kurtosis, blocks.statistics[i].kurtosis, 1e-10);
    EXPECT_EQ(once.statistics[i].histogram.counts, blocks.statistics[i].histogram.counts);
  }
  EXPECT_LT((once.contributions.first_order - blocks.contributions.first_order).norm(), 1e-12);
}

TEST(SimulationStatistics, ThreadsDoNotMatterToTheLastBit) {
  const Scene scene = sceneOfTwo();
  const Sampler sampler(scene, {0, 1}, SamplerType::monte_carlo, kSamples, 1);
  constexpr std::size_t kBlock = 256;
  const auto simulated = [&](std::size_t threads) {
    const SimulationAccumulator empty(scene, {0, 1}, {0, 1});
    std::vector<SimulationAccumulator> blocks((kSamples + kBlock - 1) / kBlock, empty);
    std::vector<std::thread> running;
    for (std::size_t t = 0; t < threads; ++t) {
      running.emplace_back([&, t] {
        for (std::size_t b = t; b < blocks.size(); b += threads) {
          for (std::uint64_t i = kBlock * b; i < std::min<std::uint64_t>(kSamples, kBlock * (b + 1)); ++i) {
            add(blocks[b], sampler, i, true);
          }
        }
      });
    }
    for (std::thread& thread : running) thread.join();
    SimulationAccumulator all = empty;
    for (const SimulationAccumulator& block : blocks) all.merge(block);
    return all.statistics(0.95);
  };
  const SimulationStatistics one = simulated(1), three = simulated(3);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(one.statistics[i].mean, three.statistics[i].mean);
    EXPECT_EQ(one.statistics[i].sigma, three.statistics[i].sigma);
    EXPECT_EQ(one.statistics[i].kurtosis, three.statistics[i].kurtosis);
    EXPECT_EQ(one.statistics[i].percentiles[0].value, three.statistics[i].percentiles[0].value);
  }
  EXPECT_EQ(one.contributions.first_order, three.contributions.first_order);
  EXPECT_EQ(one.contributions.slope, three.contributions.slope);
}

// σ of normal measures to ±0.5 % at 95 %: (1.96/0.005)²/2 = 76,800 samples with a value; a tenth has none.
TEST(SimulationStatistics, SamplesForAWantedErrorOfAllMeasures) {
  const SimulationStatistics s = simulate(true, kSamples);
  EXPECT_NEAR(static_cast<double>(samplesNeeded(s, 0.005)), 76832.0 / 0.9, 5000.0);
  EXPECT_EQ(samplesNeeded(s, 0.05), kSamples);
  EXPECT_EQ(samplesNeeded(s, 1e-6), kMostSamples);
  EXPECT_THROW(samplesNeeded(s, 0.0), std::invalid_argument);
  SimulationStatistics nothing_yet = s;
  nothing_yet.statistics[1] = MeasureAccumulator({}, {}).statistics(0.95);
  EXPECT_EQ(samplesNeeded(nothing_yet, 0.05), 2 * kSamples);
}

TEST(SimulationStatistics, WithoutALinearModelThereIsNoControl) {
  const Scene scene = sceneOfTwo();
  SimulationAccumulator accumulator(scene, {0}, {0});
  for (int i = 0; i < 100; ++i) {
    const double x = std::sin(i);
    accumulator.add(static_cast<std::uint64_t>(i), SampleOutcome::solved, &x, &x, nullptr);
  }
  const SimulationStatistics s = accumulator.statistics(0.95);
  EXPECT_FALSE(s.statistics[0].controlled);
  EXPECT_EQ(s.statistics[0].no_control, "there is no linear model");
}

}  // namespace
}  // namespace cable_variation
