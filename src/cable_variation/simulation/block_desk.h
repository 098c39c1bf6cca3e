#pragma once  // internal to simulation/

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>

#include <cable_variation/simulation/block_exchange.h>
#include <cable_variation/simulation/sample_block.h>

namespace cable_variation {

/// A block that is complete, and its bytes if an exchange wants them.
struct FinishedBlock {
  SampleBlock block;
  std::string bytes;
};

/// Deals the blocks of a simulation, to threads and to others elsewhere, and gives them on in their order,
/// whoever is done first. Blocks begin at multiples of their size, wherever the samples do.
class BlockDesk : public BlockDealer {
 public:
  /// What a thread is to do next: solve a block, or, if there are bytes, read it.
  struct Work {
    BlockRange range;
    std::string bytes;
  };
  using Take = std::function<void(FinishedBlock&)>;

  /// Samples `next` to `end`. @param size of a block @param window so many may be dealt ahead of what was
  /// given on @param take is given each block in its order, by one thread at a time
  BlockDesk(std::uint64_t next, std::uint64_t end, std::size_t size, std::size_t window, Take take);

  /// For a thread: waits until there is something to do; none: all is done.
  /// @param goes_on asked now and then while it waits; false: stop()
  std::optional<Work> work(const std::function<bool()>& goes_on);
  void finish(FinishedBlock block);
  /// No more is dealt; blocks before the first that is missing are still given on.
  void stop();
  /// Likewise; throwFailure() throws it, the first one.
  void fail(std::exception_ptr error);
  void throwFailure() const;

  bool next(BlockRange& range) override;
  void deliver(const BlockRange& range, std::string bytes) override;
  bool ended() const override;

 private:
  bool mayDeal() const { return next_ < end_ && !stopped_ && next_ - given_ < window_; }
  bool isOver() const { return stopped_ || given_ == end_; }
  BlockRange deal();

  const std::uint64_t end_, size_, window_;
  const Take take_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::uint64_t next_, given_;  // the next sample to be dealt, to be given on
  bool stopped_ = false, giving_ = false;
  std::exception_ptr failure_;
  std::set<BlockRange> elsewhere_;  // dealt by next() and not back yet
  std::deque<Work> delivered_;
  std::map<std::uint64_t, std::unique_ptr<FinishedBlock>> finished_;  // and not yet given on
};

}  // namespace cable_variation
