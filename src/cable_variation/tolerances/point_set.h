#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <cable_variation/util/counter_random.h>

namespace cable_variation {

enum class SamplerType {
  monte_carlo,      ///< independent points
  latin_hypercube,  ///< each of `count` equal parts of every coordinate holds one point
  sobol             ///< Sobol' points, Owen scrambled; best for counts that are powers of two
};

const char* toString(SamplerType type);
/// Throws std::invalid_argument that names the samplers there are.
SamplerType samplerTypeOf(const std::string& name);

/// Beyond this many samples a count is a mistake: at 10,000 a second they would take a day.
constexpr std::uint64_t kMostSamples = 1000000000;

/// Random points of the open unit cube, by index: nothing is stored but Sobol' direction numbers. Each point
/// by itself is evenly distributed, whatever the sampler.
class PointSet {
 public:
  /// @param count of points. Latin hypercube: the number of parts. The others begin alike whatever it is.
  /// Throws std::invalid_argument: no dimension, no or more than kMostSamples points, more dimensions than
  /// there are Sobol' direction numbers for.
  PointSet(SamplerType type, std::size_t dimensions, std::uint64_t count, std::uint64_t seed);

  SamplerType type() const { return type_; }
  std::size_t dimensions() const { return dimensions_; }
  std::uint64_t count() const { return count_; }

  /// @param index < count() @param coordinates of the point, dimensions() of them
  void point(std::uint64_t index, double* coordinates) const;

 private:
  double latinCoordinate(std::uint64_t index, std::uint32_t dimension) const;
  std::uint64_t shuffled(std::uint64_t index, std::uint32_t dimension) const;
  double sobolCoordinate(std::uint64_t index, std::uint32_t dimension) const;

  SamplerType type_;
  std::size_t dimensions_;
  std::uint64_t count_;
  CounterRandom random_, shuffle_;
  std::uint64_t rows_ = 0, columns_ = 0;   // Latin hypercube: a table with a cell for each part and few more
  std::vector<std::uint32_t> directions_;  // Sobol': of each dimension, one per bit of the index
};

}  // namespace cable_variation
