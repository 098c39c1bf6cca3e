#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <cable_variation/simulation/block_exchange.h>

namespace cable_variation_command {

/// Threads of a helper that solve blocks as they come. Going away waits for what is being solved.
class RankPool {
 public:
  struct Solved {
    cable_variation::BlockRange range;
    std::string bytes;
  };

  /// @param make a solver for the thread that calls it
  RankPool(std::size_t threads, const std::function<cable_variation::BlockSolver()>& make);
  ~RankPool();
  RankPool(const RankPool&) = delete;
  RankPool& operator=(const RankPool&) = delete;

  void add(const cable_variation::BlockRange& range);
  bool take(Solved& solved);  ///< false: nothing is done now
  /// What a solver threw, or Cancelled if it was told to end.
  void throwFailure();

 private:
  void work(const cable_variation::BlockSolver& solve);
  void end();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<cable_variation::BlockRange> waiting_;
  std::deque<Solved> solved_;
  bool ended_ = false;
  std::exception_ptr failure_;
  std::vector<std::thread> threads_;
};

}  // namespace cable_variation_command
