#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace cable_variation {

/// Consecutive samples that are solved together.
struct BlockRange {
  std::uint64_t first = 0;
  std::size_t count = 0;

  std::uint64_t end() const { return first + count; }
  bool operator<(const BlockRange& other) const {
    return first != other.first ? first < other.first : count < other.count;
  }
};

/// The blocks of a simulation as somebody sees it who has them solved elsewhere. Safe from several threads.
class BlockDealer {
 public:
  virtual ~BlockDealer() = default;

  /// The next block to be solved; false: none is to be had now, see ended().
  virtual bool next(BlockRange& range) = 0;
  /// A block is back, as bytes of the solver that HelpedBlocks makes. Throws std::invalid_argument: no block
  /// of this simulation.
  virtual void deliver(const BlockRange& range, std::string bytes) = 0;
  /// All blocks are there, or the simulation ends without the others.
  virtual bool ended() const = 0;
};

/// Solves a block for another process: its bytes; empty: it was told to end.
using BlockSolver = std::function<std::string(const BlockRange&)>;

/// Where blocks of samples come from and go to besides the threads of this process: files, other processes.
/// A block's bytes are all that a simulation keeps of its samples; the same simulation elsewhere, of the same
/// build, goes on with them as if it had solved them itself, bit for bit.
class BlockExchange {
 public:
  virtual ~BlockExchange() = default;

  /// The bytes of a block that has been solved before; empty: it has not. By any thread. Throws what is
  /// wrong with where they are.
  virtual std::string solvedBefore(const BlockRange& range) = 0;
  /// Takes every block once it is complete, in their order, those solved before as well. By one thread at a
  /// time. What it throws ends the simulation.
  virtual void keep(const BlockRange& range, const std::string& bytes) = 0;

  /// So many blocks may be under way elsewhere.
  virtual std::size_t mostElsewhere() const { return 0; }
  /// Deals blocks to others until the dealer has ended. What it throws ends the simulation.
  virtual void deal(BlockDealer& /*dealer*/) {}

  /// Whether this process only solves blocks for another one, by help(): its own simulation has no samples.
  virtual bool isHelper() const { return false; }
  /// @param threads to use @param make a solver for the thread that calls it
  virtual void help(std::size_t /*threads*/, const std::function<BlockSolver()>& /*make*/) {}
};

}  // namespace cable_variation
