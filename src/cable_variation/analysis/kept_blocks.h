#pragma once

#include <memory>
#include <string>
#include <vector>

#include <cable_variation/analysis/block_file.h>
#include <cable_variation/simulation/block_exchange.h>

namespace cable_variation {

/// Blocks of a simulation kept in its file NAME.blocks while it runs, so that it can go on after it was
/// killed; or those of several shards, to be merged.
class KeptBlocks : public BlockExchange {
 public:
  /// A run's own file. @param resume goes on with a file that is there; one that is not begins anew
  /// @param is_shard the file is what is asked for: a block that cannot be kept ends the run
  /// Throws FileError; std::invalid_argument: a file to go on with that is of another simulation.
  KeptBlocks(const std::string& path, const BlockFileHeader& header, bool resume, bool is_shard);
  /// Shards, as checkedShards() has them.
  explicit KeptBlocks(std::vector<BlockFileReader> shards);

  std::string solvedBefore(const BlockRange& range) override;
  void keep(const BlockRange& range, const std::string& bytes) override;

  const std::string& path() const { return path_; }
  std::uint64_t resumed() const { return resumed_; }   ///< samples that the file had
  std::uint64_t taken() const { return taken_; }       ///< samples that files had and the run has taken over
  std::uint64_t cut() const { return cut_; }           ///< blocks of shards solved again: their ends cut them
  const std::string& error() const { return error_; }  ///< of a file that is no shard: it ends there

  /// The run has ended. A file is taken away if it is no shard and the run is complete: there is nothing to
  /// go on with. Throws FileError of a shard.
  void finish(bool complete);

 private:
  std::string path_;
  bool is_shard_ = false;
  std::vector<BlockFileReader> files_;
  std::unique_ptr<BlockFileWriter> writer_;
  std::uint64_t resumed_ = 0, taken_ = 0, cut_ = 0;
  std::string error_;
};

/// Shards of one simulation, all samples from 0 on, in the order of the paths.
/// Throws FileError, std::invalid_argument: a file that is none, of another simulation or build than the
/// first, not complete; samples that are in two of them or in none.
std::vector<BlockFileReader> checkedShards(const std::vector<std::string>& paths);

}  // namespace cable_variation
