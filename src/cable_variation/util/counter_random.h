#pragma once

#include <array>
#include <cstdint>

namespace cable_variation {

/// Ten rounds of Philox 4x32: a block of random bits for each counter and key (Salmon, Moraes, Dror and Shaw,
/// Parallel random numbers: as easy as 1, 2, 3, SC 2011).
std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key);

/// A number in (0, 1), never an end, by the leading 52 of `bits`.
inline double openUnit(std::uint64_t bits) { return (static_cast<double>(bits >> 12) + 0.5) * 0x1p-52; }

/// Random numbers by their place, not by their turn: without a state, so the same whatever the number of
/// threads and the order in which they are asked for.
class CounterRandom {
 public:
  /// @param stream tells apart what shares a seed
  CounterRandom(std::uint64_t seed, std::uint32_t stream)
      : key_{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}, stream_(stream) {}

  std::array<std::uint32_t, 4> block(std::uint64_t row, std::uint32_t column) const {
    return philox({static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(row >> 32), column, stream_},
                  key_);
  }
  std::uint64_t bits(std::uint64_t row, std::uint32_t column) const {
    const auto words = block(row, column);
    return static_cast<std::uint64_t>(words[0]) << 32 | words[1];
  }
  /// In (0, 1), evenly.
  double uniform(std::uint64_t row, std::uint32_t column) const { return openUnit(bits(row, column)); }

 private:
  std::array<std::uint32_t, 2> key_;
  std::uint32_t stream_;
};

/// The numbers of one row, one after the other: for what draws as many as it happens to need.
class RandomRow {
 public:
  RandomRow(const CounterRandom& random, std::uint64_t row) : random_(random), row_(row) {}

  double uniform() { return random_.uniform(row_, column_++); }  ///< in (0, 1), evenly

 private:
  CounterRandom random_;
  std::uint64_t row_;
  std::uint32_t column_ = 0;
};

}  // namespace cable_variation
