#include <cable_variation/tolerances/point_set.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include <boost/random/sobol.hpp>

namespace cable_variation {

namespace {

constexpr std::array<const char*, 3> kNames = {"monte_carlo", "latin_hypercube", "sobol"};

// Streams of random numbers that share the seed.
constexpr std::uint32_t kPointStream = 1, kShuffleStream = 2;

constexpr std::uint32_t kIndexBits = 30;  // kMostSamples fits
static_assert(kMostSamples <= 1ull << kIndexBits);

// Owen's nested uniform scrambling: the flip of each binary digit depends on all digits before it. A block of
// 128 random bits has the flips of seven levels of that tree, 127 nodes, under one prefix. As many digits as
// tell all points of a coordinate apart, and a few more.
constexpr std::uint32_t kLevels = 7, kDigits = 35;

std::uint64_t scrambled(std::uint64_t digits, const CounterRandom& random, std::uint32_t dimension) {
  std::uint64_t result = 0;
  for (std::uint32_t level = 0; level < kDigits; level += kLevels) {
    // a leading 1 tells prefixes of different lengths apart
    const std::uint64_t prefix = 1ull << level | digits >> (kDigits - level);
    const auto words = random.block(prefix, dimension);
    std::uint32_t node = 1;
    for (std::uint32_t k = 1; k <= kLevels; ++k) {
      const std::uint64_t digit = digits >> (kDigits - level - k) & 1u;
      const std::uint64_t flip = words[node >> 5] >> (node & 31u) & 1u;
      result = result << 1 | (digit ^ flip);
      node = node << 1 | static_cast<std::uint32_t>(digit);
    }
  }
  return result;
}

}  // namespace

const char* toString(SamplerType type) { return kNames[static_cast<std::size_t>(type)]; }

SamplerType samplerTypeOf(const std::string& name) {
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (name == kNames[i]) return static_cast<SamplerType>(i);
  }
  throw std::invalid_argument("there is no sampler '" + name +
                              "'; expected monte_carlo, latin_hypercube or sobol");
}

PointSet::PointSet(SamplerType type, std::size_t dimensions, std::uint64_t count, std::uint64_t seed)
    : type_(type),
      dimensions_(dimensions),
      count_(count),
      random_(seed, kPointStream),
      shuffle_(seed, kShuffleStream) {
  if (dimensions == 0) throw std::invalid_argument("samples of no design variable; expected 1 or more");
  if (count == 0 || count > kMostSamples) {
    throw std::invalid_argument(std::to_string(count) + " samples; expected 1 to " +
                                std::to_string(kMostSamples));
  }
  if (type == SamplerType::latin_hypercube) {
    rows_ = static_cast<std::uint64_t>(std::ceil(std::sqrt(static_cast<double>(count))));
    columns_ = (count + rows_ - 1) / rows_;
  }
  if (type == SamplerType::sobol) {
    constexpr std::size_t kMost = boost::random::default_sobol_table::max_dimension;
    if (dimensions > kMost) {
      throw std::invalid_argument("sampler sobol for " + std::to_string(dimensions) +
                                  " coordinates; expected " + std::to_string(kMost) +
                                  " at most, or sampler monte_carlo");
    }
    // Point n of Boost's engine, counted from 1, belongs to the Gray code of n; that of 2^(k+1) - 1 has bit k
    // alone, so the point is the direction number k.
    boost::random::sobol_engine<std::uint32_t, 32> engine(dimensions);
    directions_.resize(dimensions * kIndexBits);
    for (std::uint32_t k = 0; k < kIndexBits; ++k) {
      engine.seed((2u << k) - 2u);
      for (std::size_t d = 0; d < dimensions; ++d) directions_[d * kIndexBits + k] = engine();
    }
  }
}

void PointSet::point(std::uint64_t index, double* coordinates) const {
  for (std::uint32_t d = 0; d < dimensions_; ++d) {
    switch (type_) {
      case SamplerType::monte_carlo:
        coordinates[d] = random_.uniform(index, d);
        break;
      case SamplerType::latin_hypercube:
        coordinates[d] = latinCoordinate(index, d);
        break;
      case SamplerType::sobol:
        coordinates[d] = sobolCoordinate(index, d);
        break;
    }
  }
}

double PointSet::latinCoordinate(std::uint64_t index, std::uint32_t dimension) const {
  const auto part = static_cast<double>(shuffled(index, dimension));
  const double coordinate = (part + random_.uniform(index, dimension)) / static_cast<double>(count_);
  return std::min(coordinate, 1.0 - 0x1p-53);
}

// A permutation computed by index: a Feistel network on a table of rows_ x columns_ cells (Black and Rogaway,
// Ciphers with arbitrary finite domains, 2002), walked until it comes to one of the count_ cells in use.
std::uint64_t PointSet::shuffled(std::uint64_t index, std::uint32_t dimension) const {
  constexpr std::uint32_t kRounds = 6;
  // a random number below `bound`, the same for the same half and round
  const auto pick = [&](std::uint64_t half, std::uint32_t round, std::uint64_t bound) {
    return shuffle_.block(half << 3 | round, dimension)[0] * bound >> 32;
  };
  std::uint64_t cell = index;
  do {
    std::uint64_t left = cell % rows_, right = cell / rows_;
    for (std::uint32_t round = 0; round < kRounds; round += 2) {
      left += pick(right, round, rows_);
      if (left >= rows_) left -= rows_;
      right += pick(left, round + 1, columns_);
      if (right >= columns_) right -= columns_;
    }
    cell = left + rows_ * right;
  } while (cell >= count_);
  return cell;
}

double PointSet::sobolCoordinate(std::uint64_t index, std::uint32_t dimension) const {
  const std::uint32_t* direction = directions_.data() + std::size_t{dimension} * kIndexBits;
  std::uint32_t digits = 0;
  for (; index != 0; index >>= 1, ++direction) {
    if (index & 1u) digits ^= *direction;
  }
  constexpr std::uint32_t kBelow = kDigits - 32;
  return openUnit(scrambled(static_cast<std::uint64_t>(digits) << kBelow, random_, dimension)
                  << (64 - kDigits));
}

}  // namespace cable_variation
