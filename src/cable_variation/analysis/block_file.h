#pragma once

#include <cstdint>
#include <map>
#include <string>

#include <cable_variation/analysis/simulation_identity.h>
#include <cable_variation/simulation/block_exchange.h>

namespace cable_variation {

/// What stands at the head of a file of blocks.
struct BlockFileHeader {
  SimulationIdentity identity, request;
  std::string scene;  ///< path of its file
  std::uint64_t first = 0, samples = 0;

  std::uint64_t end() const { return first + samples; }
};

/// A file of complete blocks of a simulation's samples: header and blocks each with length and checksum, in
/// the byte order of this machine, so that what a killed run has left is told from what is whole.
class BlockFileReader {
 public:
  /// Reads the header and looks through all blocks, to the first that is not whole.
  /// Throws FileError that names the file: it cannot be read; std::invalid_argument likewise: it is none.
  explicit BlockFileReader(std::string path);
  ~BlockFileReader();
  BlockFileReader(BlockFileReader&& other) noexcept;
  BlockFileReader& operator=(BlockFileReader&&) = delete;

  /// Whether a file ends before its header does: its run was ended as it began, and nothing is in it.
  static bool isCutInHeader(const std::string& path);

  const std::string& path() const { return path_; }
  const BlockFileHeader& header() const { return header_; }
  std::size_t count() const { return blocks_.size(); }  ///< of the blocks that are there
  /// Up to which sample they are, from the header's first one on, without a gap.
  std::uint64_t completeTo() const { return complete_to_; }
  /// Where the whole part of the file ends [B].
  std::uint64_t end() const { return end_; }

  bool has(const BlockRange& range) const { return blocks_.count(range) > 0; }
  /// A block's bytes; empty: it is not there. Safe from several threads. Throws FileError.
  std::string bytesOf(const BlockRange& range) const;

 private:
  struct Place {
    std::uint64_t offset = 0, size = 0;
  };
  void readHeader();
  bool readRecord();
  std::string read(std::uint64_t offset, std::uint64_t size) const;  // shorter at the file's end

  std::string path_;
  int file_ = -1;
  BlockFileHeader header_;
  std::map<BlockRange, Place> blocks_;
  std::uint64_t end_ = 0, complete_to_ = 0;
};

/// Appends to such a file, alone.
class BlockFileWriter {
 public:
  /// Begins a new one, in the place of one that is there. Throws FileError that names the file and what the
  /// system says, or that another run writes it now.
  BlockFileWriter(std::string path, const BlockFileHeader& header);
  /// Goes on with one, behind its first `end` bytes.
  BlockFileWriter(std::string path, std::uint64_t end);
  ~BlockFileWriter();
  BlockFileWriter(const BlockFileWriter&) = delete;
  BlockFileWriter& operator=(const BlockFileWriter&) = delete;

  /// All of it or nothing. Throws FileError: the disk is full.
  void append(const BlockRange& range, const std::string& bytes);
  /// Brought to the disk. Throws FileError.
  void sync();

 private:
  void open();
  void write(const std::string& bytes);

  std::string path_;
  int file_ = -1;
  std::uint64_t end_ = 0;
};

}  // namespace cable_variation
