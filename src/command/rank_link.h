#pragma once

#include <memory>
#include <string>

namespace cable_variation_command {

/// What is told between the ranks of a run.
enum class RankMessage {
  identity,  ///< of a helper's simulation
  agreed,    ///< by the first rank: go on
  ready,     ///< a helper has so many threads
  block,     ///< a block to be solved, or one that has been
  failed,    ///< what went wrong with a helper
  stop,      ///< by the first rank: no more
  bye        ///< a helper tells nothing more
};

/// The processes that one run is spread over, numbered from 0. By one thread.
class RankLink {
 public:
  virtual ~RankLink() = default;

  virtual int rank() const = 0;
  virtual int size() const = 0;
  virtual std::string host() const = 0;

  /// Returns before it has arrived.
  virtual void send(int to, RankMessage kind, std::string bytes) = 0;
  /// What has arrived, in the order that its sender sent it; false: nothing.
  virtual bool receive(int& from, RankMessage& kind, std::string& bytes) = 0;
  /// Whether all that was sent is on its way for good.
  virtual bool sent() = 0;
  /// All ranks have said what they had to say; nothing is sent or received after that.
  virtual void finish() = 0;
};

/// If this process is one of several that mpirun or srun has started: the others; else nullptr.
/// Throws std::invalid_argument: it is, and this build has no MPI.
std::unique_ptr<RankLink> linkOfRanks();

}  // namespace cable_variation_command
