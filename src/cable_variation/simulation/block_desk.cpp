#include <cable_variation/simulation/block_desk.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <utility>

namespace cable_variation {

namespace {

constexpr std::chrono::milliseconds kAsk(50);  // a thread that waits whether it is to go on

}  // namespace

BlockDesk::BlockDesk(std::uint64_t next, std::uint64_t end, std::size_t size, std::size_t window, Take take)
    : end_(end), size_(size), window_(window * size), take_(std::move(take)), next_(next), given_(next) {}

BlockRange BlockDesk::deal() {
  const std::uint64_t first = next_;
  next_ = std::min(end_, (first / size_ + 1) * size_);
  return {first, static_cast<std::size_t>(next_ - first)};
}

std::optional<BlockDesk::Work> BlockDesk::work(const std::function<bool()>& goes_on) {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!changed_.wait_for(lock, kAsk, [&] { return isOver() || !delivered_.empty() || mayDeal(); })) {
    lock.unlock();
    if (!goes_on()) stop();
    lock.lock();
  }
  if (!delivered_.empty() && !stopped_) {
    Work work = std::move(delivered_.front());
    delivered_.pop_front();
    return work;
  }
  if (isOver()) return {};
  return Work{deal(), ""};
}

void BlockDesk::finish(FinishedBlock block) {
  std::unique_lock<std::mutex> lock(mutex_);
  const std::uint64_t first = block.block.first;
  finished_[first] = std::make_unique<FinishedBlock>(std::move(block));
  if (giving_) return;  // who is at it takes it too
  giving_ = true;
  for (auto front = finished_.find(given_); front != finished_.end() && !failure_;
       front = finished_.find(given_)) {
    const std::unique_ptr<FinishedBlock> given = std::move(front->second);
    finished_.erase(front);
    lock.unlock();
    std::exception_ptr error;
    try {
      take_(*given);
    } catch (...) {
      error = std::current_exception();
    }
    lock.lock();
    if (error) {
      if (!failure_) failure_ = error;
      stopped_ = true;
    } else {
      given_ += given->block.outcomes.size();
    }
    changed_.notify_all();
  }
  giving_ = false;
}

void BlockDesk::stop() {
  const std::lock_guard<std::mutex> lock(mutex_);
  stopped_ = true;
  changed_.notify_all();
}

void BlockDesk::fail(std::exception_ptr error) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!failure_) failure_ = std::move(error);
  stopped_ = true;
  changed_.notify_all();
}

void BlockDesk::throwFailure() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (failure_) std::rethrow_exception(failure_);
}

bool BlockDesk::next(BlockRange& range) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!mayDeal()) return false;
  range = deal();
  elsewhere_.insert(range);
  return true;
}

void BlockDesk::deliver(const BlockRange& range, std::string bytes) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (elsewhere_.erase(range) == 0) {
    throw std::invalid_argument("a block of " + std::to_string(range.count) + " samples from " +
                                std::to_string(range.first) + " that nobody was asked for");
  }
  delivered_.push_back({range, std::move(bytes)});
  changed_.notify_all();
}

bool BlockDesk::ended() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return isOver();
}

}  // namespace cable_variation
