#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <cable_variation/analysis/run_control.h>
#include <cable_variation/analysis/simulation_identity.h>
#include <cable_variation/simulation/block_exchange.h>
#include <command/rank_link.h>
#include <command/verb.h>

namespace cable_variation_command {

/// A simulation that several processes work at: the first one deals blocks of samples to the others, its
/// helpers, as they get done, solves some itself, and puts all of them together in their order.
class Ranks : public cable_variation::BlockExchange {
 public:
  /// The ranks that this process was started with; nullptr: it is alone. Throws as linkOfRanks().
  /// @param threads of this process; 0: all cores that it may use
  static std::unique_ptr<Ranks> join(std::uint64_t threads, cable_variation::RunControl& control);

  Ranks(std::unique_ptr<RankLink> link, std::uint64_t threads, cable_variation::RunControl& control);

  /// All ranks say what they are about to simulate. Throws std::invalid_argument: some would simulate
  /// something else, or are of another build; what a helper threw before it came here.
  void agree(const cable_variation::SimulationIdentity& identity);

  /// Where blocks are kept, of the first rank; nullptr: nowhere.
  void keepIn(cable_variation::BlockExchange* kept) { kept_ = kept; }

  // For the simulation.
  std::string solvedBefore(const cable_variation::BlockRange& range) override;
  void keep(const cable_variation::BlockRange& range, const std::string& bytes) override;
  std::size_t mostElsewhere() const override { return elsewhere_; }
  void deal(cable_variation::BlockDealer& dealer) override;
  bool isHelper() const override { return link_->rank() != 0; }
  void help(std::size_t threads, const std::function<cable_variation::BlockSolver()>& make) override;

  /// Ends it: the first rank tells the helpers to stop and waits for them, a helper waits until it is told.
  void leave();
  /// A helper's answer: none, the first rank's counts.
  Answer quiet();
  /// Likewise when something went wrong: the first rank says what.
  Answer failed(const std::exception& error);

 private:
  struct Message {
    int from = 0;
    RankMessage kind = RankMessage::bye;
    std::string bytes;
  };
  bool receive(Message& message);
  void take(const Message& message, cable_variation::BlockDealer& dealer);
  bool dealTo(int rank, cable_variation::BlockDealer& dealer);
  void agreeAsFirst(const cable_variation::SimulationIdentity& identity);
  void agreeAsHelper(const cable_variation::SimulationIdentity& identity);
  [[noreturn]] void throwOf(const Message& message) const;

  std::unique_ptr<RankLink> link_;
  std::uint64_t threads_;
  cable_variation::RunControl& control_;
  cable_variation::BlockExchange* kept_ = nullptr;
  std::size_t elsewhere_ = 0;
  std::vector<std::string> hosts_;
  std::vector<std::size_t> free_;  // per rank: so many blocks more it may have
  int byes_ = 0;
  bool stopped_ = false, left_ = false;
};

}  // namespace cable_variation_command
