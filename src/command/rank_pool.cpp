#include <command/rank_pool.h>

#include <utility>

#include <cable_variation/util/error.h>

namespace cable_variation_command {

using cable_variation::BlockRange;

RankPool::RankPool(std::size_t threads, const std::function<cable_variation::BlockSolver()>& make) {
  try {
    for (std::size_t i = 0; i < threads; ++i) {
      threads_.emplace_back([this, make] {
        try {
          work(make());
        } catch (...) {
          const std::lock_guard<std::mutex> lock(mutex_);
          if (!failure_) failure_ = std::current_exception();
        }
      });
    }
  } catch (...) {
    end();
    throw;
  }
}

RankPool::~RankPool() { end(); }

void RankPool::end() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ended_ = true;
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void RankPool::work(const cable_variation::BlockSolver& solve) {
  std::unique_lock<std::mutex> lock(mutex_);
  for (;;) {
    changed_.wait(lock, [&] { return ended_ || !waiting_.empty(); });
    if (ended_) return;
    const BlockRange range = waiting_.front();
    waiting_.pop_front();
    lock.unlock();
    std::string bytes = solve(range);
    if (bytes.empty()) throw cable_variation::Cancelled("was told to end");
    lock.lock();
    solved_.push_back({range, std::move(bytes)});
  }
}

void RankPool::add(const BlockRange& range) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    waiting_.push_back(range);
  }
  changed_.notify_one();
}

bool RankPool::take(Solved& solved) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (solved_.empty()) return false;
  solved = std::move(solved_.front());
  solved_.pop_front();
  return true;
}

void RankPool::throwFailure() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (failure_) std::rethrow_exception(failure_);
}

}  // namespace cable_variation_command
