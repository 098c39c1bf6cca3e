#include <cable_variation/analysis/kept_blocks.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include <unistd.h>

#include <cable_variation/util/error.h>

namespace cable_variation {

namespace {

std::string samplesText(std::uint64_t first, std::uint64_t end) {
  return "samples " + std::to_string(first) + " to " + std::to_string(end - 1);
}

void requireSame(const BlockFileHeader& file, const std::string& path, const BlockFileHeader& wanted) {
  std::string differences = differenceOf(file.identity, "in the file", wanted.identity, "now");
  if (file.first != wanted.first || file.samples != wanted.samples) {
    differences += (differences.empty() ? "" : "; ") + samplesText(file.first, file.end()) +
                   " in the file, " + samplesText(wanted.first, wanted.end()) + " now";
  }
  if (differences.empty()) return;
  throw std::invalid_argument("file '" + path + "' is of another simulation: " + differences +
                              "; expected the same, or no --resume to begin anew");
}

}  // namespace

KeptBlocks::KeptBlocks(const std::string& path, const BlockFileHeader& header, bool resume, bool is_shard)
    : path_(path), is_shard_(is_shard) {
  if (!resume || !std::filesystem::exists(path) || BlockFileReader::isCutInHeader(path)) {
    writer_ = std::make_unique<BlockFileWriter>(path, header);
    return;
  }
  BlockFileReader file(path);
  requireSame(file.header(), path, header);
  writer_ = std::make_unique<BlockFileWriter>(path, file.end());
  resumed_ = file.completeTo() - header.first;
  files_.push_back(std::move(file));
}

KeptBlocks::KeptBlocks(std::vector<BlockFileReader> shards) : files_(std::move(shards)) {}

std::string KeptBlocks::solvedBefore(const BlockRange& range) {
  for (const BlockFileReader& file : files_) {
    std::string bytes = file.bytesOf(range);
    if (!bytes.empty()) return bytes;
  }
  return "";
}

void KeptBlocks::keep(const BlockRange& range, const std::string& bytes) {
  const bool is_there =
      std::any_of(files_.begin(), files_.end(), [&](const BlockFileReader& file) { return file.has(range); });
  if (is_there) {
    taken_ += range.count;
    return;
  }
  cut_ += writer_ ? 0 : 1;
  if (!writer_ || !error_.empty()) return;
  try {
    writer_->append(range, bytes);
  } catch (const FileError& problem) {
    if (is_shard_) throw;
    error_ = problem.what();
  }
}

void KeptBlocks::finish(bool complete) {
  if (!writer_) return;
  if (complete && !is_shard_) {
    ::unlink(path_.c_str());
  } else if (is_shard_) {
    writer_->sync();
  }
  writer_.reset();
}

std::vector<BlockFileReader> checkedShards(const std::vector<std::string>& paths) {
  std::vector<BlockFileReader> shards;
  for (const std::string& path : paths) {
    shards.emplace_back(path);
    const BlockFileReader& shard = shards.back();
    const BlockFileHeader& header = shard.header();
    const std::string difference =
        differenceOf(shards.front().header().identity, "in '" + shards.front().path() + "'", header.identity,
                     "in '" + path + "'");
    if (!difference.empty())
      throw std::invalid_argument("shards are of different simulations: " + difference);
    if (shard.completeTo() != header.end()) {
      throw std::invalid_argument(
          "shard '" + path + "' is not complete: " + std::to_string(shard.completeTo() - header.first) +
          " of its " + samplesText(header.first, header.end()) + " are there; --resume completes it");
    }
  }
  std::vector<const BlockFileReader*> order;
  order.reserve(shards.size());
  for (const BlockFileReader& shard : shards) order.push_back(&shard);
  std::sort(order.begin(), order.end(), [](const BlockFileReader* one, const BlockFileReader* other) {
    return one->header().first < other->header().first;
  });
  std::uint64_t next = 0;
  const BlockFileReader* before = nullptr;
  for (const BlockFileReader* shard : order) {
    const BlockFileHeader& header = shard->header();
    if (header.first > next)
      throw std::invalid_argument(samplesText(next, header.first) + " are in none of the shards");
    if (header.first < next) {
      throw std::invalid_argument(samplesText(header.first, std::min(next, header.end())) + " are in both '" +
                                  before->path() + "' and '" + shard->path() + "'");
    }
    next = header.end();
    before = shard;
  }
  return shards;
}

}  // namespace cable_variation
