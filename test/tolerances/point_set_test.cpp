// Points of the unit cube: their stratification, counted; their randomness, by statistics over seeds.
#include <cable_variation/tolerances/point_set.h>

#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace cable_variation {
namespace {

using Point = std::vector<double>;

Point pointOf(const PointSet& set, std::uint64_t index) {
  Point point(set.dimensions());
  set.point(index, point.data());
  return point;
}

const std::vector<SamplerType> kAll = {SamplerType::monte_carlo, SamplerType::latin_hypercube,
                                       SamplerType::sobol};

std::size_t cellOf(double coordinate, std::size_t cells) {
  return static_cast<std::size_t>(coordinate * static_cast<double>(cells));
}

TEST(PointSet, EveryPointIsWithinTheOpenCube) {
  for (const SamplerType type : kAll) {
    const PointSet set(type, 5, 3000, 11);
    for (std::uint64_t i = 0; i < 3000; ++i) {
      for (const double x : pointOf(set, i)) EXPECT_TRUE(x > 0.0 && x < 1.0) << toString(type);
    }
  }
}

TEST(PointSet, LatinHypercubeHasOnePointInEachPartOfEachCoordinate) {
  for (const std::uint64_t count : {1u, 2u, 3u, 7u, 10u, 1000u, 10007u}) {
    const PointSet set(SamplerType::latin_hypercube, 3, count, 5);
    std::vector<std::set<std::size_t>> parts(3);
    for (std::uint64_t i = 0; i < count; ++i) {
      const Point point = pointOf(set, i);
      for (std::size_t d = 0; d < 3; ++d) parts[d].insert(cellOf(point[d], count));
    }
    for (std::size_t d = 0; d < 3; ++d) EXPECT_EQ(parts[d].size(), count);
  }
}

// Chi-squared statistics, for which Wilson and Hilferty's normal score says how likely they are.
double scoreOf(const std::map<std::vector<std::size_t>, int>& counts, std::size_t cells, int trials) {
  const double expected = static_cast<double>(trials) / static_cast<double>(cells);
  double statistic = static_cast<double>(cells - counts.size()) * expected;
  for (const auto& [cell, count] : counts) statistic += (count - expected) * (count - expected) / expected;
  const double freedoms = static_cast<double>(cells - 1);
  return (std::cbrt(statistic / freedoms) - (1.0 - 2.0 / (9.0 * freedoms))) /
         std::sqrt(2.0 / (9.0 * freedoms));
}

TEST(PointSet, LatinHypercubesOfAllSeedsAreEquallyLikely) {
  constexpr int kSeeds = 20000;
  std::map<std::vector<std::size_t>, int> orders, pairs;
  for (int seed = 0; seed < kSeeds; ++seed) {
    const PointSet three(SamplerType::latin_hypercube, 1, 3, static_cast<std::uint64_t>(seed));
    orders[{cellOf(pointOf(three, 0)[0], 3), cellOf(pointOf(three, 1)[0], 3)}] += 1;
    const PointSet seven(SamplerType::latin_hypercube, 2, 7, static_cast<std::uint64_t>(seed));
    const Point point = pointOf(seven, 4);
    pairs[{cellOf(point[0], 7), cellOf(point[1], 7)}] += 1;
  }
  EXPECT_EQ(orders.size(), 6u);  // 3! permutations
  EXPECT_LT(std::abs(scoreOf(orders, 6, kSeeds)), 4.0);
  EXPECT_LT(std::abs(scoreOf(pairs, 49, kSeeds)), 4.0);
}

// Any 2^m points that begin at a multiple of 2^m: one in each of 2^m parts of each coordinate, and for the
// first two coordinates one in each box of area 2^-m whose sides are powers of two. Scrambling keeps that.
TEST(PointSet, SobolPointsAreStratified) {
  constexpr std::uint64_t kDimensions = 50;
  const PointSet set(SamplerType::sobol, kDimensions, 1u << 20, 3);
  for (const std::uint64_t m : {1u, 4u, 9u}) {
    const std::uint64_t size = 1u << m, begin = 5 * size;
    std::vector<std::set<std::size_t>> parts(kDimensions);
    std::vector<std::set<std::size_t>> boxes(m + 1);
    for (std::uint64_t i = begin; i < begin + size; ++i) {
      const Point point = pointOf(set, i);
      for (std::size_t d = 0; d < kDimensions; ++d) parts[d].insert(cellOf(point[d], size));
      for (std::size_t k = 0; k <= m; ++k) {
        boxes[k].insert(cellOf(point[0], 1u << k) * size + cellOf(point[1], size >> k));
      }
    }
    for (const auto& found : parts) EXPECT_EQ(found.size(), size);
    for (const auto& found : boxes) EXPECT_EQ(found.size(), size);
  }
}

TEST(PointSet, ScrambledSobolPointsAreUniformInPairs) {
  constexpr int kSeeds = 20000;
  std::map<std::vector<std::size_t>, int> cells, neighbours;
  for (int seed = 0; seed < kSeeds; ++seed) {
    const PointSet set(SamplerType::sobol, 3, 64, static_cast<std::uint64_t>(seed));
    const Point point = pointOf(set, 13);
    cells[{cellOf(point[0], 8), cellOf(point[2], 8)}] += 1;
    // the first two points always differ in the first digit and are independent beyond
    const double first = std::fmod(2.0 * pointOf(set, 0)[1], 1.0);
    const double second = std::fmod(2.0 * pointOf(set, 1)[1], 1.0);
    neighbours[{cellOf(first, 8), cellOf(second, 8)}] += 1;
  }
  EXPECT_LT(std::abs(scoreOf(cells, 64, kSeeds)), 4.0);
  EXPECT_LT(std::abs(scoreOf(neighbours, 64, kSeeds)), 4.0);
}

// ∏ (1 + (x - 1/2)/(d + 1)) has mean 1. Standard errors over 64 seeds: Monte Carlo's falls with the root of
// the count, a Latin hypercube takes out what is a sum of functions of one coordinate each, Sobol' points
// more.
TEST(PointSet, BetterSamplersHaveSmallerErrors) {
  constexpr std::uint64_t kCount = 1024, kSeeds = 64;
  std::map<SamplerType, double> error;
  for (const SamplerType type : kAll) {
    double squares = 0.0;
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      const PointSet set(type, 4, kCount, seed);
      double sum = 0.0;
      for (std::uint64_t i = 0; i < kCount; ++i) {
        const Point point = pointOf(set, i);
        double product = 1.0;
        for (std::size_t d = 0; d < 4; ++d) product *= 1.0 + (point[d] - 0.5) / static_cast<double>(d + 1);
        sum += product;
      }
      squares += (sum / kCount - 1.0) * (sum / kCount - 1.0);
    }
    error[type] = std::sqrt(squares / kSeeds);
  }
  double variance = 1.0;  // ∏ (1 + 1/(12 (d + 1)²)) - 1
  for (const double d : {1.0, 2.0, 3.0, 4.0}) variance *= 1.0 + 1.0 / (12.0 * d * d);
  const double expected = std::sqrt((variance - 1.0) / kCount);
  EXPECT_NEAR(error[SamplerType::monte_carlo], expected, 0.4 * expected);  // 4.5 standard errors of 64 seeds
  EXPECT_LT(error[SamplerType::latin_hypercube], 0.4 * expected);
  EXPECT_LT(error[SamplerType::sobol], 0.05 * expected);
}

TEST(PointSet, BadInputIsRefused) {
  EXPECT_THROW(PointSet(SamplerType::monte_carlo, 0, 10, 1), std::invalid_argument);
  EXPECT_THROW(PointSet(SamplerType::monte_carlo, 1, 0, 1), std::invalid_argument);
  EXPECT_THROW(PointSet(SamplerType::sobol, 1, kMostSamples + 1, 1), std::invalid_argument);
  EXPECT_THROW(PointSet(SamplerType::sobol, 100000, 10, 1), std::invalid_argument);
  EXPECT_EQ(samplerTypeOf("latin_hypercube"), SamplerType::latin_hypercube);
  try {
    samplerTypeOf("halton");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "there is no sampler 'halton'; expected monte_carlo, latin_hypercube or sobol");
  }
}

// Indices at the far end of what is allowed.
TEST(PointSet, TheLastOfManyPointsIsThere) {
  for (const SamplerType type : kAll) {
    const PointSet set(type, 2, kMostSamples, 1);
    const Point point = pointOf(set, kMostSamples - 1);
    EXPECT_NE(point, pointOf(set, kMostSamples - 2));
    EXPECT_EQ(point, pointOf(set, kMostSamples - 1));
  }
}

}  // namespace
}  // namespace cable_variation
